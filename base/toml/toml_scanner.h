#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/toml/toml_layout.h"

namespace gsim::base {

/// Scanner of the start and end of keys and values in a TOML text within its bounds (toml_bounds.h). Text
/// that is not TOML may be misread, or rejected.
class TomlScanner {
  public:
    explicit TomlScanner(std::string_view text) : text_(text) {}

    std::size_t at() const { return at_; }
    void seek(std::size_t at) { at_ = at; }
    bool at_end() const { return at_ >= text_.size(); }
    bool at_line_end() const {
        return text_.substr(at_).starts_with('\n') || text_.substr(at_).starts_with("\r\n");
    }
    /// Returns the next character; 0 at the end.
    char peek() const { return at_end() ? '\0' : text_[at_]; }
    void skip(std::size_t bytes) { at_ += bytes; }
    /// Consumes the character, if it is the next one.
    bool consume(char c);
    void skip_blanks();
    /// Moves to the beginning of the next line.
    void skip_line();

    /// Reads `a . "b"`, up to the text that follows.
    std::optional<TomlPath> read_key();
    /// Reads `a.b = 1`.
    std::optional<TomlItem> read_pair();
    std::optional<TomlValueSpan> read_value();

  private:
    void skip_blanks_and_lines();
    std::optional<std::string> read_key_part();
    bool skip_string();
    bool read_items(TomlValueSpan& value_span, char close);

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace gsim::base
