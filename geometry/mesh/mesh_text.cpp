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

std::string_view TextWords::next_in_line() {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
    const auto end = std::find_if(begin, rest_.end(), [](char c) { return is_blank(c) || c == '\n'; });
    const std::string_view word =
        rest_.substr(static_cast<std::size_t>(begin - rest_.begin()), static_cast<std::size_t>(end - begin));
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.begin()));
    return word;
}

bool TextWords::skip_line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) {
        rest_ = {};
        return false;
    }
    rest_.remove_prefix(end + 1);
    ++line_;
    return true;
}

std::string_view TextWords::next() {
    do {
        if (const std::string_view word = next_in_line(); !word.empty()) return word;
    } while (skip_line());
    return {};
}

std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = text::read_number(word.data(), word.data() + word.size(), value);
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    if (fault == std::errc::result_out_of_range && end == word.data() + word.size() && tiny) return 0;
    if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace gsim::cell
