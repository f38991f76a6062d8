#ifndef coapt_base_log_h
#define coapt_base_log_h

#include <mpi.h>

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * Lines for the terminal and for the log file of a run, written by the first
   * rank; the others keep silent. Warnings are counted by a key, so that one
   * which is raised in each of 10^4 steps takes one line.
   */
  class Log
  {
  public:
    /** A warning, its text when it was first raised, and how often it was. */
    struct Warning
    {
      std::string key;
      std::string text;
      unsigned int count;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &key &text &count;
      }
    };

    /** Writes to @p terminal; no file until open(). */
    explicit Log(const MPI_Comm communicator);
    Log(const MPI_Comm communicator, std::ostream &terminal);

    /**
     * Starts the log file, first with what has been logged so far; if that
     * @p continues an earlier run, at the end of its file.
     *
     * @throws std::runtime_error on the first rank alone if the file cannot
     * be written.
     */
    void
    open(const std::string &file, const bool continues = false);

    /** Writes a line to the terminal and the file. */
    void
    line(const std::string &text);

    /** Writes a line to the file only. */
    void
    file_line(const std::string &text);

    /**
     * Raises the warning @p key. Only the first rank's calls count: what one
     * rank alone sees must be reduced before. The first call writes a line.
     */
    void
    warn(const std::string &key, const std::string &text);

    /** All warnings in the order in which they were first raised. */
    const std::vector<Warning> &
    warnings() const
    {
      return all_warnings;
    }

    /** Saves the warnings, or puts those of an earlier run before the others.
     */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::vector<Warning> earlier = all_warnings;
      archive &earlier;
      if (Archive::is_loading::value)
        put_before(earlier);
    }

  private:
    /** Puts these warnings before those that there are and not among them. */
    void
    put_before(const std::vector<Warning> &earlier);

    const bool is_first_rank;
    std::ostream &terminal;
    std::ofstream file;
    std::string lines_before_open;
    std::vector<Warning> all_warnings;
  };
} // namespace coapt

#endif
