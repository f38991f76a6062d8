#ifndef coapt_base_csv_table_h
#define coapt_base_csv_table_h

#include <string>
#include <vector>

namespace coapt
{
  /**
   * A text file of columns separated by commas, the first line of which names
   * them. Blank lines and what follows a `#` are skipped; quotes and blanks
   * around an entry do not belong to it.
   */
  class CsvTable
  {
  public:
    /** @throws InputError with file and line if the file cannot be read, has no
     * row, or a row with another number of entries than the header. */
    explicit CsvTable(const std::string &file);

    /** Number of rows below the header. */
    unsigned int
    n_rows() const
    {
      return rows.size();
    }

    /** Names of the columns in their order. */
    const std::vector<std::string> &
    column_names() const
    {
      return names;
    }

    /** Whether there is a column @p name. */
    bool
    has(const std::string &name) const;

    /** The entries of a column. @throws InputError if there is none. */
    std::vector<std::string>
    texts(const std::string &name) const;

    /** The same as numbers. @throws InputError with file, line and column if
     * one is not a finite number. */
    std::vector<double>
    numbers(const std::string &name) const;

    /** "FILE, line N" of a row, for messages about what it holds. */
    std::string
    place(const unsigned int row) const;

  private:
    unsigned int
    column(const std::string &name) const;

    std::string file;
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;
    std::vector<unsigned int> lines;
  };
} // namespace coapt

#endif
