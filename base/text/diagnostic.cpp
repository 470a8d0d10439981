#include "base/text/diagnostic.h"

#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace gsim::text {

namespace {

/// Returns an integer at the end of `text` after a colon, and removes both from `text`.
std::optional<std::uint32_t> take_last_number(std::string_view& text) {
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
bool take_place(std::string_view head, Diagnostic& diagnostic) {
    const std::optional<std::uint32_t> last = take_last_number(head);
    if (!last) return false;
    const std::optional<std::uint32_t> line = take_last_number(head);
    if (head.empty()) return false;
    diagnostic.file = head;
    diagnostic.line = line.value_or(*last);
    diagnostic.column = line ? *last : 0;
    return true;
}

bool take_severity(std::string_view& rest, Diagnostic& diagnostic) {
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
        const std::string_view word = name(severity);
        if (!rest.starts_with(word) || !rest.substr(word.size()).starts_with(": ")) continue;
        diagnostic.severity = severity;
        rest.remove_prefix(word.size() + 2);
        return true;
    }
    return false;
}

/// Returns the file of "cannot read 'name': why"; empty if the message is another one.
std::string_view unreadable_file(std::string_view sentence) {
    constexpr std::string_view kHead = "cannot read '";
    const std::size_t end = sentence.find("': ");
    if (!sentence.starts_with(kHead) || end == std::string_view::npos) return {};
    return sentence.substr(kHead.size(), end - kHead.size());
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

std::string place_of(const Diagnostic& diagnostic) {
    std::string place = diagnostic.file;
    if (place.empty()) return place;
    if (diagnostic.line > 0) place += fmt::format(":{}", diagnostic.line);
    if (diagnostic.line > 0 && diagnostic.column > 0) place += fmt::format(":{}", diagnostic.column);
    return place;
}

std::string to_text(const Diagnostic& diagnostic) {
    const std::string place = place_of(diagnostic);
    return fmt::format("{}{}{}: {}{}{}\n{}", place, place.empty() ? "" : ": ", name(diagnostic.severity),
                       diagnostic.text, diagnostic.hint.empty() ? "" : "; ", diagnostic.hint,
                       diagnostic.excerpt);
}

Diagnostic diagnostic_of(DiagnosticKind kind, std::string_view sentence) {
    Diagnostic diagnostic;
    diagnostic.kind = kind;
    // A name may contain ": ", so each occurrence is tried; the first one that ends a source location is
    // used.
    for (std::size_t end = sentence.find(": "); end != std::string_view::npos;
         end = sentence.find(": ", end + 1)) {
        if (!take_place(sentence.substr(0, end), diagnostic)) continue;
        sentence.remove_prefix(end + 2);
        break;
    }
    take_severity(sentence, diagnostic);
    diagnostic.text = sentence;
    if (diagnostic.file.empty()) diagnostic.file = unreadable_file(sentence);
    return diagnostic;
}

}  // namespace gsim::text
