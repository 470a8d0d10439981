#include "cam/solid/occ/file_check.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::solid {

namespace {

constexpr std::string_view kWhitespace = " \t\r\n\v\f";
constexpr std::size_t kIgesSectionColumn = 72;  // the column that says the section

std::string_view trim_end(std::string_view text) {
    return text.substr(0, text.find_last_not_of(kWhitespace) + 1);
}

// ISO 10303-21, clause 5: comments are allowed before the first word and after the last one.
std::optional<Error> find_step_error(std::string_view text) {
    if (text.substr(0, 1000).find("ISO-10303-21") == std::string_view::npos)
        return "this is not a STEP file: it does not begin with 'ISO-10303-21;'";
    const std::size_t tail = text.size() - std::min<std::size_t>(text.size(), 1000);
    if (text.substr(tail).find("END-ISO-10303-21") == std::string_view::npos)
        return "the file is truncated: it does not end with 'END-ISO-10303-21;'";
    return std::nullopt;
}

// IGES 5.3, 2.2: lines of 80 columns, the section's letter in column 73; S comes first and T last.
std::optional<Error> find_iges_error(std::string_view text) {
    const std::string_view first = text.substr(0, text.find('\n'));
    if (first.size() <= kIgesSectionColumn || first[kIgesSectionColumn] != 'S')
        return "this is not an IGES file (fixed format): the first line has no 'S' in column 73";
    const std::size_t line = text.find_last_of('\n');
    const std::string_view last = line == std::string_view::npos ? text : text.substr(line + 1);
    if (last.size() <= kIgesSectionColumn || last[kIgesSectionColumn] != 'T')
        return "the file is truncated: the last line has no 'T' in column 73";
    return std::nullopt;
}

}  // namespace

FileFormat format_by_name(std::string_view name) {
    const std::size_t dot = name.find_last_of('.');
    const bool iges = dot != std::string_view::npos && dot + 1 < name.size() &&
                      (name[dot + 1] == 'i' || name[dot + 1] == 'I');
    return iges ? FileFormat::iges : FileFormat::step;
}

std::optional<Error> find_file_error(std::string_view text, FileFormat format) {
    const std::string_view body = trim_end(text);
    if (body.empty()) return "the file is empty";
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n') + 1;
        return fmt::format("line {} contains a NUL byte", line);
    }
    return format == FileFormat::step ? find_step_error(body) : find_iges_error(body);
}

}  // namespace gsim::solid
