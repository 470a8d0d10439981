#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "lexer/source.h"

namespace gsim::lexer {

/// A place in a source: where its line begins (byte offset), the line and the column, both from 1.
struct Location {
    std::uint64_t line_begin = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

/// Collects what is wrong with one source and renders it: `part.nc:12:7: error: ...`, the line, a caret.
class Diagnostics {
  public:
    using Print = std::function<void(std::string_view)>;

    /// `print` takes each finished message. After `max_errors` errors, one message says so and full() is
    /// true.
    Diagnostics(const Source& source, std::size_t max_errors, Print print)
        : source_(source), max_errors_(max_errors), print_(std::move(print)) {}

    void error(const Location& location, std::string_view message);
    void warning(const Location& location, std::string_view message);

    std::size_t error_count() const { return errors_; }
    bool full() const { return errors_ >= max_errors_; }
    /// The first error as "part.nc:12:7: ..." without the line; empty where there was none.
    const std::string& first_error() const { return first_error_; }

  private:
    void render(const Location& location, std::string_view severity, std::string_view message);

    const Source& source_;
    std::size_t max_errors_;
    Print print_;
    std::size_t errors_ = 0;
    std::string first_error_;
};

/// `text` with control characters (a lone CR, NUL, escapes) written as \xNN, so that it is safe in a message
/// or behind `--` in Lua, where a CR would end the comment.
std::string printable(std::string_view text);

}  // namespace gsim::lexer
