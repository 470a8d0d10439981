#include "runtime/report/report_words.h"

#include <fmt/format.h>

namespace gsim::simulation {

std::string clean(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    return out;
}

std::string shortened(std::string_view text, std::size_t width) {
    std::string out = clean(text);
    return out.size() <= width ? out : "..." + out.substr(out.size() - width + 3);
}

std::string place_text(const Report& report, const Place& place, std::size_t width) {
    const std::string file = place.file < report.files.size() ? report.files[place.file] : "?";
    const std::string line = place.line > 0 ? fmt::format(":{}", place.line) : "";
    return shortened(file, width - line.size()) + line;
}

}  // namespace gsim::simulation
