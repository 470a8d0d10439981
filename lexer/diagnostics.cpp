#include "lexer/diagnostics.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace gsim::lexer {

namespace {

/// Length of the part of a long line that a message shows, in bytes.
constexpr std::size_t kMaxExcerptBytes = 160;

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

/// Returns the part of the line around the column and the caret under it.
std::string excerpt(const std::string& line, std::size_t column) {
    const std::size_t index = std::min(column > 0 ? column - 1 : 0, line.size());
    const std::size_t begin = index > kMaxExcerptBytes - 20 ? index - (kMaxExcerptBytes - 20) : 0;
    std::string display_text = line.substr(begin, kMaxExcerptBytes);
    std::replace_if(
        display_text.begin(), display_text.end(), [](char c) { return is_control(c) && c != '\t'; }, '?');
    std::string caret;
    for (std::size_t i = 0; i < index - begin; ++i) caret += display_text[i] == '\t' ? '\t' : ' ';
    return fmt::format("  {}{}\n  {}{}^\n", begin > 0 ? "..." : "", display_text, begin > 0 ? "   " : "",
                       caret);
}

/// Returns the end of the word that begins at `column`: a letter or a keyword with its number, or one
/// character.
std::uint32_t word_end(std::string_view line, std::uint32_t column) {
    const std::size_t begin = column > 0 ? column - 1 : 0;
    std::size_t end = begin;
    if (end < line.size() && line[end] == ',') ++end;
    while (end < line.size() && std::isalpha(static_cast<unsigned char>(line[end])) != 0) ++end;
    while (end < line.size() && end > begin &&
           (std::isdigit(static_cast<unsigned char>(line[end])) != 0 || line[end] == '.' ||
            line[end] == '-' || line[end] == '+'))
        ++end;
    return static_cast<std::uint32_t>(std::max(end, begin + 1) + 1);
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        if (is_control(c) && c != '\t') {
            out += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out;
}

text::Diagnostic Diagnostics::make_diagnostic(const Location& location, text::Severity severity,
                                              DiagnosticKind kind, std::string_view message,
                                              std::string_view hint) const {
    const std::string line = source_.line_at(location.line_begin);
    return {.severity = severity,
            .kind = kind,
            .file = source_.name(),
            .line = location.line,
            .column = location.column,
            .end_column = word_end(line, location.column),
            .text = std::string(message),
            .hint = std::string(hint),
            .excerpt = excerpt(line, location.column)};
}

void Diagnostics::error(const Location& location, DiagnosticKind kind, std::string_view message,
                        std::string_view hint) {
    if (full()) return;
    ++errors_;
    const text::Diagnostic diagnostic = make_diagnostic(location, text::Severity::error, kind, message, hint);
    if (!first_error_) first_error_ = diagnostic;
    handler_(diagnostic);
    if (!full()) return;
    handler_({.severity = text::Severity::note,
              .kind = DiagnosticKind::too_many_errors,
              .file = source_.name(),
              .text = fmt::format("stopped after {} errors", errors_)});
}

void Diagnostics::warning(const Location& location, DiagnosticKind kind, std::string_view message,
                          std::string_view hint) {
    if (!full()) handler_(make_diagnostic(location, text::Severity::warning, kind, message, hint));
}

}  // namespace gsim::lexer
