#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/diagnostic.h"
#include "lexer/source.h"

namespace gsim::lexer {

/// Position in a source: the start of its line (byte offset), the line and the column, both from 1.
struct Location {
    std::uint64_t line_begin = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

using text::DiagnosticKind;

/// Collector of the errors and warnings of one source.
class Diagnostics {
  public:
    using DiagnosticHandler = std::function<void(const text::Diagnostic&)>;

    /// Passes each diagnostic to `on_diagnostic` as soon as it is known, with the line and a caret as its
    /// excerpt. Once there are `max_errors` errors, one more says so and full() is true.
    Diagnostics(const Source& source, std::size_t max_errors, DiagnosticHandler on_diagnostic)
        : source_(source), max_errors_(max_errors), handler_(std::move(on_diagnostic)) {}

    void error(const Location& location, DiagnosticKind kind, std::string_view message,
               std::string_view hint = {});
    void warning(const Location& location, DiagnosticKind kind, std::string_view message,
                 std::string_view hint = {});

    std::size_t error_count() const { return errors_; }
    bool full() const { return errors_ >= max_errors_; }
    /// Returns the first error; no value if no error occurred.
    const std::optional<text::Diagnostic>& first_error() const { return first_error_; }

  private:
    text::Diagnostic make_diagnostic(const Location& location, text::Severity severity, DiagnosticKind kind,
                                     std::string_view message, std::string_view hint) const;

    const Source& source_;
    std::size_t max_errors_;
    DiagnosticHandler handler_;
    std::size_t errors_ = 0;
    std::optional<text::Diagnostic> first_error_;
};

/// Returns `text` with control characters (a lone CR, NUL, escapes) written as \xNN. So it is safe in a
/// message or after `--` in Lua, where a CR would end the comment.
std::string printable(std::string_view text);

}  // namespace gsim::lexer
