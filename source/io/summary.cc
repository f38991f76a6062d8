#include <coapt/base/exceptions.h>
#include <coapt/io/summary.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace coapt
{
  namespace
  {
    /** @p text in quotes, with JSON's escapes (RFC 8259, section 7). */
    std::string
    quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (c == '"' || c == '\\')
          result += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
          {
            char escape[7];
            std::snprintf(escape, sizeof(escape), "\\u%04x", c);
            result += escape;
          }
        else
          result += c;
      return result + "\"";
    }
  } // namespace

  void
  Summary::set_text(const std::string &key, const std::string &text)
  {
    const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
        return entry.key == key;
      });
    if (found == entries.end())
      entries.push_back({key, text, {}});
    else
      *found = {key, text, {}};
  }



  void
  Summary::set(const std::string &key, const double value)
  {
    char text[32] = "null";
    if (std::isfinite(value))
      std::snprintf(text, sizeof(text), "%.9g", value);
    set_text(key, text);
  }



  void
  Summary::set(const std::string &key, const unsigned long value)
  {
    set_text(key, std::to_string(value));
  }



  void
  Summary::set(const std::string &key, const unsigned int value)
  {
    set_text(key, std::to_string(value));
  }



  void
  Summary::set(const std::string &key, const bool value)
  {
    set_text(key, value ? "true" : "false");
  }



  void
  Summary::set(const std::string &key, const std::string &value)
  {
    set_text(key, quoted(value));
  }



  void
  Summary::set(const std::string &key, const char *value)
  {
    set_text(key, quoted(value));
  }



  void
  Summary::set(const std::string &key, const std::vector<std::string> &values)
  {
    std::string text;
    for (const std::string &value : values)
      text += (text.empty() ? "" : ", ") + quoted(value);
    set_text(key, "[" + text + "]");
  }



  void
  Summary::set(const std::string &key, const Summary &object)
  {
    set_text(key, "");
    std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
      return entry.key == key;
    })->object = {object};
  }



  double
  Summary::number(const std::string &key) const
  {
    for (const Entry &entry : entries)
      if (entry.key == key)
        {
          char *end;
          const double value = std::strtod(entry.text.c_str(), &end);
          if (end != entry.text.c_str() && *end == '\0')
            return value;
          if (entry.text == "true" || entry.text == "false")
            return entry.text == "true";
        }
    return std::numeric_limits<double>::quiet_NaN();
  }



  std::string
  Summary::json(const std::string &indentation) const
  {
    std::string text;
    for (const Entry &entry : entries)
      text += (text.empty() ? "\n" : ",\n") + indentation + "  " +
        quoted(entry.key) + ": " +
        (entry.object.empty() ? entry.text
                              : entry.object[0].json(indentation + "  "));
    return "{" + text + (text.empty() ? "}" : "\n" + indentation + "}");
  }



  std::string
  Summary::json() const
  {
    return json("");
  }



  void
  Summary::write(const std::string &file) const
  {
    std::ofstream stream(file);
    stream << json() << std::endl;
    if (!stream)
      throw std::runtime_error(file + ": writing failed; is the disk full?");
  }
} // namespace coapt
