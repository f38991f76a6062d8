#ifndef coapt_tests_io_vtu_reader_h
#define coapt_tests_io_vtu_reader_h

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/** Reads appended, compressed arrays of a .vtu file back, by the format's
 * definition (VTK file formats, Kitware). */
class VtuReader
{
public:
  explicit VtuReader(const std::string &file)
  {
    std::ifstream stream(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(stream), {});
    data = text.find('_', text.find("<AppendedData")) + 1;
  }

  /** The values of the array @p name; empty if it does not exist. */
  template <typename T>
  std::vector<T>
  array(const std::string &name) const
  {
    const auto entry = text.find("Name=\"" + name + "\"");
    if (entry == std::string::npos)
      return {};
    const auto offset = text.find("offset=\"", entry) + 8;
    const auto start  = data + std::stoul(text.substr(offset));

    std::uint64_t header[4];
    std::memcpy(header, &text[start], sizeof(header));
    if (header[0] == 0)
      return {};
    std::vector<T> values(header[1] / sizeof(T));
    uLongf length = header[1];
    uncompress(reinterpret_cast<Bytef *>(values.data()),
               &length,
               reinterpret_cast<const Bytef *>(&text[start + sizeof(header)]),
               header[3]);
    values.resize(length / sizeof(T));
    return values;
  }

private:
  std::string text;
  std::size_t data;
};

#endif
