#include "geometry/mesh/mesh_text.h"

#include <algorithm>
#include <cmath>

#include "base/text/read_number.h"

namespace gsim::cell {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

void TriangleSoup::add(const std::array<Eigen::Vector3d, 3>& corners) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    triangles.push_back({first, first + 1, first + 2});
}

std::string_view WordReader::next_in_line() {
    const auto begin = std::find_if_not(remaining_.begin(), remaining_.end(), is_blank);
    const auto end = std::find_if(begin, remaining_.end(), [](char c) { return is_blank(c) || c == '\n'; });
    const std::string_view word = remaining_.substr(static_cast<std::size_t>(begin - remaining_.begin()),
                                                    static_cast<std::size_t>(end - begin));
    remaining_.remove_prefix(static_cast<std::size_t>(end - remaining_.begin()));
    return word;
}

bool WordReader::skip_line() {
    const std::size_t end = remaining_.find('\n');
    if (end == std::string_view::npos) {
        remaining_ = {};
        return false;
    }
    remaining_.remove_prefix(end + 1);
    ++line_;
    return true;
}

std::string_view WordReader::next() {
    do {
        if (const std::string_view word = next_in_line(); !word.empty()) return word;
    } while (skip_line());
    return {};
}

std::optional<double> parse_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = text::read_number(word.data(), word.data() + word.size(), value);
    const bool has_negative_exponent =
        word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    if (error == std::errc::result_out_of_range && end == word.data() + word.size() && has_negative_exponent)
        return 0;
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace gsim::cell
