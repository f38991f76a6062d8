#ifndef coapt_base_growing_file_h
#define coapt_base_growing_file_h

#include <cstdint>
#include <fstream>
#include <string>

namespace coapt
{
  /** A text file that is written bit by bit during a run, and that a run which
   * goes on from a checkpoint takes up where that was written. */
  class GrowingFile
  {
  public:
    /** Begins @p file anew, or goes on at its end if it @p continues an earlier
     * run.
     *
     * @throws std::runtime_error if it cannot be written. */
    void
    open(const std::string &file, const bool continues);

    /** Where to write to. */
    std::ostream &
    stream()
    {
      return out;
    }

    /** Puts on the disk what has been written.
     *
     * @throws std::runtime_error if that fails. */
    void
    flush();

    /** Saves the length of the file, or cuts it to the one that was saved. A
     * file that is not open has the length zero, and none is cut then. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::uintmax_t length = Archive::is_saving::value ? size() : 0;
      archive &length;
      if (Archive::is_loading::value)
        cut(length);
    }

    /** Length on the disk (bytes); zero if it is not open. */
    std::uintmax_t
    size() const;

  private:
    void
    cut(const std::uintmax_t length) const;

    std::string file;
    std::ofstream out;
  };
} // namespace coapt

#endif
