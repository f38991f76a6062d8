#ifndef coapt_base_number_table_h
#define coapt_base_number_table_h

#include <string>
#include <vector>

namespace coapt
{
  /** Columns of numbers from a text file, in the order in which they were asked
   * for. */
  struct NumberTable
  {
    /** A row, and the line of the file that it is on, for error messages. */
    struct Row
    {
      std::vector<double> values;
      unsigned int line;
    };

    std::string file;
    std::vector<Row> rows;

    /**
     * Reads these @p columns from a file with comma-separated rows. Blank lines
     * and what follows a `#` are skipped. The first line may name the columns,
     * which then may come in any order and beside others; without names, they
     * are the first ones in this order.
     *
     * @throws InputError with file and line if the file cannot be opened or has
     * no row, a column is missing, or a cell (its number is told) is not a
     * finite number.
     */
    static NumberTable
    from_file(const std::string &file, const std::vector<std::string> &columns);

    /** The names in the file's first line; empty if that has numbers. */
    static std::vector<std::string>
    column_names(const std::string &file);

    /** Name of file and line of the row @p i. */
    std::string
    place(const unsigned int i) const;

    /** The entry of row @p i and column @p c as a whole number. @throws
     * InputError if it is none of less than ten digits. */
    int
    whole_number(const unsigned int i, const unsigned int c) const;
  };
} // namespace coapt

#endif
