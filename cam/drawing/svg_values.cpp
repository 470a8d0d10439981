#include "cam/drawing/svg_values.h"

#include <array>
#include <numbers>
#include <vector>

#include "base/text/digits.h"
#include "base/text/read_number.h"
#include "base/units.h"

namespace gsim::drawing {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::optional<Affine> transform_matrix(std::string_view name, const std::vector<double>& v) {
    const std::size_t count = v.size();
    const auto value = [&](std::size_t i, double fallback) { return i < count ? v[i] : fallback; };
    const auto radians = [&] { return v[0] * kRadPerDeg; };
    if (name == "matrix" && count == 6) return Affine{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
    if (count == 0) return {};
    if (name == "translate" && count <= 2) return moved({v[0], value(1, 0)});
    if (name == "scale" && count <= 2) return scaled(v[0], value(1, v[0]));
    if (name == "rotate" && (count == 1 || count == 3)) {
        const geometry::Point about{value(1, 0), value(2, 0)};
        return moved(about) * turned(radians()) * moved(-1.0 * about);
    }
    if (name == "skewX" && count == 1) return Affine{{1, 0}, {std::tan(radians()), 1}, {}};
    if (name == "skewY" && count == 1) return Affine{{1, std::tan(radians())}, {0, 1}, {}};
    return {};
}

}  // namespace

void SvgScanner::skip_blanks() {
    while (offset_ < text_.size() && (is_blank(text_[offset_]) || text_[offset_] == ',')) ++offset_;
}

bool SvgScanner::at_end() {
    skip_blanks();
    return offset_ >= text_.size();
}

std::optional<double> SvgScanner::number() {
    skip_blanks();
    std::size_t first = offset_;
    if (first < text_.size() && text_[first] == '+') ++first;
    // read_number would accept "inf" and "nan", too.
    std::size_t digit = first;
    while (digit < text_.size() && (text_[digit] == '-' || text_[digit] == '.')) ++digit;
    if (digit >= text_.size() || !text::is_digit(text_[digit])) return {};
    double value = 0;
    const auto [end, error] = text::read_number(text_.data() + first, text_.data() + text_.size(), value);
    if (error != std::errc{}) return {};
    offset_ = static_cast<std::size_t>(end - text_.data());
    return value;
}

std::optional<bool> SvgScanner::flag() {
    skip_blanks();
    if (offset_ >= text_.size() || (text_[offset_] != '0' && text_[offset_] != '1')) return {};
    return text_[offset_++] == '1';
}

std::optional<char> SvgScanner::letter() {
    skip_blanks();
    if (offset_ >= text_.size() || !is_letter(text_[offset_])) return {};
    return text_[offset_++];
}

std::string_view SvgScanner::word() {
    skip_blanks();
    const std::size_t first = offset_;
    while (offset_ < text_.size() && is_letter(text_[offset_])) ++offset_;
    return text_.substr(first, offset_ - first);
}

bool SvgScanner::consume(char c) {
    skip_blanks();
    if (offset_ >= text_.size() || text_[offset_] != c) return false;
    ++offset_;
    return true;
}

std::optional<double> svg_length_px(std::string_view text) {
    SvgScanner scanner(text);
    const std::optional<double> value = scanner.number();
    const std::string_view unit = scanner.word();
    if (!value || !scanner.at_end()) return {};
    constexpr std::array<std::pair<std::string_view, double>, 8> kUnits{{{"", 1},
                                                                         {"px", 1},
                                                                         {"mm", 96 / 25.4},
                                                                         {"cm", 96 / 2.54},
                                                                         {"in", 96},
                                                                         {"pt", 96.0 / 72},
                                                                         {"pc", 16},
                                                                         {"Q", 24 / 25.4}}};
    for (const auto& [name, px] : kUnits) {
        if (unit == name) return *value * px;
    }
    return {};
}

std::optional<Affine> svg_transform(std::string_view text) {
    SvgScanner scanner(text);
    Affine result;
    while (!scanner.at_end()) {
        const std::string_view name = scanner.word();
        if (name.empty() || !scanner.consume('(')) return {};
        std::vector<double> values;
        while (const auto value = scanner.number()) values.push_back(*value);
        if (!scanner.consume(')')) return {};
        const std::optional<Affine> matrix = transform_matrix(name, values);
        if (!matrix) return {};
        result = result * *matrix;
    }
    return result;
}

}  // namespace gsim::drawing
