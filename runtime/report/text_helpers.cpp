#include "runtime/report/text_helpers.h"

#include <fmt/format.h>

namespace gsim::simulation {

std::string sanitized(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    return out;
}

std::string truncated(std::string_view text, std::size_t width) {
    std::string out = sanitized(text);
    return out.size() <= width ? out : "..." + out.substr(out.size() - width + 3);
}

std::string location_text(const Report& report, const SourceLocation& location, std::size_t width) {
    const std::string file =
        location.file < report.source.files.size() ? report.source.files[location.file] : "?";
    const std::string line = location.line > 0 ? fmt::format(":{}", location.line) : "";
    return truncated(file, width - line.size()) + line;
}

}  // namespace gsim::simulation
