#include <deal.II/base/mpi.h>

#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/io/checkpoint_file.h>

#include <boost/crc.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace coapt
{
  namespace
  {
    namespace fs = std::filesystem;

    /** What a file begins with; the number grows with the format of what is in
     * it. */
    std::string
    title(const std::string &kind)
    {
      return "coapt " + kind + " 4";
    }

    std::string
    state_in(const std::string &folder)
    {
      return folder + "/state";
    }

    std::uint32_t
    checksum(const std::string &content)
    {
      boost::crc_32_type crc;
      crc.process_bytes(content.data(), content.size());
      return crc.checksum();
    }

    /** The content, once it has been found to be complete. */
    std::string
    content_of(const std::string &folder, const std::string &kind)
    {
      const std::string file = state_in(folder);
      if (!fs::exists(file))
        throw InputError(folder + " holds no checkpoint of a " + kind);
      std::ifstream in(file, std::ios::binary);
      std::string line;
      if (!in || !std::getline(in, line))
        throw InputError(file + ": cannot be read");
      if (line != title(kind))
        throw InputError(file + " is no checkpoint of a " + kind +
                         ", or one of another version");
      while (std::getline(in, line))
        {
          std::istringstream entry(line);
          std::string name;
          std::size_t size       = 0;
          std::uint32_t expected = 0;
          entry >> name >> size;
          if (name != "state")
            {
              std::error_code code;
              if (fs::file_size(folder + "/" + name, code) != size)
                throw InputError(folder + "/" + name +
                                 " is missing or incomplete");
              continue;
            }
          entry >> expected;
          std::ostringstream rest;
          rest << in.rdbuf();
          if (rest.str().size() == size && checksum(rest.str()) == expected)
            return rest.str();
          break;
        }
      throw InputError(file + " is damaged");
    }
  } // namespace



  void
  write_checkpoint_file(const std::string &folder,
                        const std::string &kind,
                        const std::string &content)
  {
    const std::string file = state_in(folder);
    std::ofstream out(file, std::ios::binary);
    out << title(kind) << '\n';
    for (const auto &entry : fs::directory_iterator(folder))
      if (entry.path() != fs::path(file))
        out << entry.path().filename().string() << ' ' << entry.file_size()
            << '\n';
    out << "state " << content.size() << ' ' << checksum(content) << '\n'
        << content;
    if (!out.flush())
      throw std::runtime_error(file + ": writing failed; is the disk full?");
  }



  std::string
  read_checkpoint_file(const std::string &folder,
                       const std::string &kind,
                       MPI_Comm communicator)
  {
    std::string content;
    on_first_rank(communicator, [&]() -> std::string {
      content = content_of(folder, kind);
      return "";
    });
    return dealii::Utilities::MPI::broadcast(communicator, content);
  }
} // namespace coapt
