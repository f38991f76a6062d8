#ifndef coapt_io_summary_h
#define coapt_io_summary_h

#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * The figures of a run as an ordered JSON object, written as text in the
   * order in which they are set. Numbers that are not finite become null.
   */
  class Summary
  {
  public:
    /** Sets @p key. A key that was set before keeps its place. @{ */
    void
    set(const std::string &key, const double value);
    void
    set(const std::string &key, const unsigned long value);
    void
    set(const std::string &key, const unsigned int value);
    void
    set(const std::string &key, const bool value);
    void
    set(const std::string &key, const std::string &value);
    void
    set(const std::string &key, const char *value);
    void
    set(const std::string &key, const std::vector<std::string> &values);
    void
    set(const std::string &key, const Summary &object);
    /** @} */

    /** The number (or truth, as 0 or 1) of @p key; not-a-number if it is
     * something else or has not been set. */
    double
    number(const std::string &key) const;

    /** The JSON text. */
    std::string
    json() const;

    /**
     * Writes the JSON text to @p file. Call it on one rank.
     *
     * @throws std::runtime_error if that fails, on this rank alone.
     */
    void
    write(const std::string &file) const;

  private:
    /** Sets the JSON text of a value. */
    void
    set_text(const std::string &key, const std::string &text);

    std::string
    json(const std::string &indentation) const;

    struct Entry
    {
      std::string key;
      std::string text;            // JSON, unless it is an object
      std::vector<Summary> object; // none or one
    };
    std::vector<Entry> entries;
  };
} // namespace coapt

#endif
