#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/toml/toml_layout.h"

namespace gsim::base {

/// Reads where keys and values begin and end in a text of TOML within its bounds (toml_bounds.h). What is no
/// TOML it may take for something else, or refuse.
class TomlScanner {
  public:
    explicit TomlScanner(std::string_view text) : text_(text) {}

    std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }
    bool at_end() const { return at_ >= text_.size(); }
    bool at_line_end() const {
        return text_.substr(at_).starts_with('\n') || text_.substr(at_).starts_with("\r\n");
    }
    /// The next character; 0 at the end.
    char peek() const { return at_end() ? '\0' : text_[at_]; }
    void skip(std::size_t bytes) { at_ += bytes; }
    /// Past a character, where it is there.
    bool take(char c);
    void skip_blanks();
    /// To the beginning of the next line.
    void skip_line();

    /// `a . "b"` up to what follows it.
    std::optional<TomlPath> read_key();
    /// `a.b = 1`
    std::optional<TomlItem> read_pair();
    std::optional<TomlSpot> read_value();

  private:
    void skip_blanks_and_lines();
    std::optional<std::string> read_key_part();
    bool skip_string();
    bool read_items(TomlSpot& spot, char close);

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace gsim::base
