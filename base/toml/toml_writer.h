#pragma once

#include <string>
#include <string_view>

namespace gsim::base {

/// Returns a TOML string with its quotation marks.
std::string toml_string(std::string_view text);

/// Returns a TOML float in its shortest form, 254 as "254.0".
std::string toml_number(double value);

/// Writer of TOML tables, line by line.
class TomlWriter {
  public:
    /// Begins a table: "[path]".
    void section(std::string_view header);
    /// Writes a line; `value` is in TOML syntax.
    void line(std::string_view key, std::string_view value);
    void number(std::string_view key, double value) { line(key, toml_number(value)); }
    /// Omits a value that does not limit.
    void limit(std::string_view key, double value);

    std::string release() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace gsim::base
