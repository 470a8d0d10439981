#include "runtime/machine/toml_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace gsim::machine {

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

std::string inline_frame(const Frame& frame) {
    return fmt::format(
        "{{ x_mm = {}, y_mm = {}, z_mm = {}, roll_deg = {}, pitch_deg = {}, "
        "yaw_deg = {} }}",
        toml_number(frame.x_mm), toml_number(frame.y_mm), toml_number(frame.z_mm),
        toml_number(frame.roll_deg), toml_number(frame.pitch_deg), toml_number(frame.yaw_deg));
}

bool is_printable(std::string_view text) {
    return std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

void TomlText::section(std::string_view header) {
    if (!text_.empty()) text_ += '\n';
    text_ += header;
    text_ += '\n';
}

void TomlText::line(std::string_view key, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), "{} = {}\n", key, value);
}

void TomlText::limit(std::string_view key, double value) {
    if (std::isfinite(value)) number(key, value);
}

}  // namespace gsim::machine
