#include "base/toml/toml_writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::base {

std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string toml_number(double value) {
    std::string text = fmt::format("{}", value);
    if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

void TomlWriter::section(std::string_view header) {
    if (!text_.empty()) text_ += '\n';
    text_ += header;
    text_ += '\n';
}

void TomlWriter::line(std::string_view key, std::string_view value) {
    text::append_format(text_, "{} = {}\n", key, value);
}

void TomlWriter::limit(std::string_view key, double value) {
    if (std::isfinite(value)) number(key, value);
}

}  // namespace gsim::base
