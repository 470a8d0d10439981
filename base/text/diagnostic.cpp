#include "base/text/diagnostic.h"

#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace gsim::text {

namespace {

/// Returns an integer that follows a colon at the end of `text`, and removes both from `text`.
std::optional<std::uint32_t> consume_last_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon + 1 == text.size()) return std::nullopt;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    text = text.substr(0, colon);
    return value;
}

/// Reads "name:12:7" or "name:12" into the diagnostic. Returns false if the text is not such a source
/// location.
bool consume_location(std::string_view head, Diagnostic& diagnostic) {
    const std::optional<std::uint32_t> last = consume_last_number(head);
    if (!last) return false;
    const std::optional<std::uint32_t> line = consume_last_number(head);
    if (head.empty()) return false;
    diagnostic.file = head;
    diagnostic.line = line.value_or(*last);
    diagnostic.column = line ? *last : 0;
    return true;
}

bool consume_severity(std::string_view& remainder, Diagnostic& diagnostic) {
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
        const std::string_view word = name(severity);
        if (!remainder.starts_with(word) || !remainder.substr(word.size()).starts_with(": ")) continue;
        diagnostic.severity = severity;
        remainder.remove_prefix(word.size() + 2);
        return true;
    }
    return false;
}

/// Returns the file of "cannot read 'name': why"; empty if the message is another one.
std::string_view unreadable_file(std::string_view message) {
    constexpr std::string_view kReadErrorPrefix = "cannot read '";
    const std::size_t end = message.find("': ");
    if (!message.starts_with(kReadErrorPrefix) || end == std::string_view::npos) return {};
    return message.substr(kReadErrorPrefix.size(), end - kReadErrorPrefix.size());
}

}  // namespace

std::string_view name(Severity severity) {
    // clang-format off
    switch (severity) {
#define GSIM_SEVERITY(name, number, constant) case Severity::name: return #name;
#include "base/kinds/severity.def"
    }
    // clang-format on
    return "";
}

std::string location_text(const Diagnostic& diagnostic) {
    std::string location = diagnostic.file;
    if (location.empty()) return location;
    if (diagnostic.line > 0) location += fmt::format(":{}", diagnostic.line);
    if (diagnostic.line > 0 && diagnostic.column > 0) location += fmt::format(":{}", diagnostic.column);
    return location;
}

std::string to_text(const Diagnostic& diagnostic) {
    const std::string location = location_text(diagnostic);
    return fmt::format("{}{}{}: {}{}{}\n{}", location, location.empty() ? "" : ": ",
                       name(diagnostic.severity), diagnostic.text, diagnostic.hint.empty() ? "" : "; ",
                       diagnostic.hint, diagnostic.excerpt);
}

Diagnostic to_diagnostic(DiagnosticKind kind, std::string_view message) {
    Diagnostic diagnostic;
    diagnostic.kind = kind;
    // A name may contain ": ", so each occurrence is tried; the first one that ends a source location is
    // used.
    for (std::size_t end = message.find(": "); end != std::string_view::npos;
         end = message.find(": ", end + 1)) {
        if (!consume_location(message.substr(0, end), diagnostic)) continue;
        message.remove_prefix(end + 2);
        break;
    }
    consume_severity(message, diagnostic);
    diagnostic.text = message;
    if (diagnostic.file.empty()) diagnostic.file = unreadable_file(message);
    return diagnostic;
}

}  // namespace gsim::text
