#include "tests/fuzz/promises.h"

#include <cctype>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"

namespace gsim::fuzz {
namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Returns the text after the first ":NUMBER:" of a text, and further numbers, or none if it has none.
std::optional<std::string_view> behind_line_number(std::string_view text) {
    for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
         colon = text.find(':', colon + 1)) {
        std::size_t end = colon + 1;
        while (end < text.size() && is_digit(text[end])) ++end;
        if (end > colon + 1 && end < text.size() && text[end] == ':') return text.substr(end + 1);
    }
    return std::nullopt;
}

}  // namespace

std::string name_beside(std::string_view extension) {
    return tests::source_path("tests/fuzz/beside/fuzz").append(extension);
}

std::optional<std::string> fault_of_sentence(std::string_view error) {
    if (error.find_first_not_of(' ') == std::string_view::npos) return "an error without a sentence";
    if (error.find('\n') != std::string_view::npos)
        return fmt::format("an error of several lines: {}", error);
    return std::nullopt;
}

std::optional<std::string> fault_of_error(std::string_view error, std::string_view file) {
    if (auto violation = fault_of_sentence(error)) return violation;
    const std::string_view folder = file.substr(0, file.rfind('/') + 1);
    if (!error.starts_with(folder) || error.size() == folder.size())
        return fmt::format("an error that does not begin with its file: {}", error);
    const auto message = behind_line_number(error.substr(folder.size()));
    if (!message) return fmt::format("an error without a line: {}", error);
    return fault_of_sentence(*message);
}

Outcome refused_with(std::string_view error, std::string_view file) {
    return {.accepted = false, .broken = fault_of_error(error, file)};
}

}  // namespace gsim::fuzz
