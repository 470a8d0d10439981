#include "lexer/diagnostics.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::lexer {

namespace {

/// How much of a long line a message shows, in bytes.
constexpr std::size_t kShownBytes = 160;

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

/// The part of the line around the column and the caret under it.
std::string excerpt(const std::string& line, std::size_t column) {
    const std::size_t index = std::min(column > 0 ? column - 1 : 0, line.size());
    const std::size_t begin = index > kShownBytes - 20 ? index - (kShownBytes - 20) : 0;
    std::string shown = line.substr(begin, kShownBytes);
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return is_control(c) && c != '\t'; }, '?');
    std::string caret;
    for (std::size_t i = 0; i < index - begin; ++i) caret += shown[i] == '\t' ? '\t' : ' ';
    return fmt::format("  {}{}\n  {}{}^\n", begin > 0 ? "..." : "", shown, begin > 0 ? "   " : "", caret);
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

void Diagnostics::render(const Location& location, std::string_view severity, std::string_view message) {
    const std::string head = fmt::format("{}:{}:{}: ", source_.name(), location.line, location.column);
    if (severity == "error" && first_error_.empty()) first_error_ = head + std::string(message);
    print_(fmt::format("{}{}: {}\n{}", head, severity, message,
                       excerpt(source_.line_at(location.line_begin), location.column)));
}

void Diagnostics::error(const Location& location, std::string_view message) {
    if (full()) return;
    ++errors_;
    render(location, "error", message);
    if (full()) print_(fmt::format("{}: {} errors, giving up\n", source_.name(), errors_));
}

void Diagnostics::warning(const Location& location, std::string_view message) {
    if (!full()) render(location, "warning", message);
}

}  // namespace gsim::lexer
