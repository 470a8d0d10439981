#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/diagnostic.h"
#include "lexer/source.h"

namespace gsim::lexer {

/// A place in a source: where its line begins (byte offset), the line and the column, both from 1.
struct Location {
    std::uint64_t line_begin = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

using text::DiagnosticKind;

/// Collects what is wrong with one source.
class Diagnostics {
  public:
    using Take = std::function<void(const text::Diagnostic&)>;

    /// `take` gets each diagnostic as soon as it is known, with the line and a caret as its excerpt. After
    /// `max_errors` errors, one more says so and full() is true.
    Diagnostics(const Source& source, std::size_t max_errors, Take take)
        : source_(source), max_errors_(max_errors), take_(std::move(take)) {}

    void error(const Location& location, DiagnosticKind kind, std::string_view message,
               std::string_view hint = {});
    void warning(const Location& location, DiagnosticKind kind, std::string_view message,
                 std::string_view hint = {});

    std::size_t error_count() const { return errors_; }
    bool full() const { return errors_ >= max_errors_; }
    /// The first error; nothing where there was none.
    const std::optional<text::Diagnostic>& first_error() const { return first_error_; }

  private:
    text::Diagnostic made(const Location& location, text::Severity severity, DiagnosticKind kind,
                          std::string_view message, std::string_view hint) const;

    const Source& source_;
    std::size_t max_errors_;
    Take take_;
    std::size_t errors_ = 0;
    std::optional<text::Diagnostic> first_error_;
};

/// `text` with control characters (a lone CR, NUL, escapes) written as \xNN, so that it is safe in a message
/// or behind `--` in Lua, where a CR would end the comment.
std::string printable(std::string_view text);

}  // namespace gsim::lexer
