#include <coapt/base/growing_file.h>

#include <filesystem>
#include <stdexcept>

namespace coapt
{
  void
  GrowingFile::open(const std::string &file, const bool continues)
  {
    this->file = file;
    // At its end, whatever is cut off there later.
    out.open(file, continues ? std::ios::app : std::ios::out);
    if (!out)
      throw std::runtime_error(file + ": cannot be written");
  }



  void
  GrowingFile::flush()
  {
    if (!(out << std::flush))
      throw std::runtime_error(file + ": writing failed; is the disk full?");
  }



  std::uintmax_t
  GrowingFile::size() const
  {
    return out.is_open() ? std::filesystem::file_size(file) : 0;
  }



  void
  GrowingFile::cut(const std::uintmax_t length) const
  {
    if (!out.is_open())
      return;
    if (size() < length)
      throw std::runtime_error(
        file + ": is shorter than when the checkpoint was written");
    std::filesystem::resize_file(file, length);
  }
} // namespace coapt
