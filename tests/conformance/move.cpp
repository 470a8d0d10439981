#include "tests/conformance/move.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gsim::conformance {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kKinds{"rapid"sv, "linear"sv, "arc_cw"sv, "arc_ccw"sv,
                            "probe"sv, "thread"sv, "spline"sv, "dwell"sv};

template <typename Value, std::size_t count>
std::optional<Value> value_of(const std::array<std::string_view, count>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Value>(found - names.begin());
}

}  // namespace

std::string_view name(Kind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

std::optional<Kind> kind_of(std::string_view name) {
    return value_of<Kind>(kKinds, name);
}

std::string describe(const Move& move) {
    std::string text(name(move.kind));
    const auto out = std::back_inserter(text);
    if (move.kind == Kind::dwell) {
        fmt::format_to(out, " {:.4f} s", move.dwell_s);
        return text;
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const bool always = axis < kLinearAxes;
        if (always || move.to[axis] != 0) fmt::format_to(out, " {}{:.5f}", kAxes[axis], move.to[axis]);
    }
    if (move.arc) {
        fmt::format_to(out, ", normal {:.6f}, centre", fmt::join(move.arc->normal, " "));
        for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
            fmt::format_to(out, " {}{:.5f}", kAxes[axis], move.arc->center_mm[axis]);
        }
        fmt::format_to(out, ", turns {}", move.arc->turns);
    }
    if (move.feed_per_min) fmt::format_to(out, ", feed {:.6g}", *move.feed_per_min);
    return text;
}

}  // namespace gsim::conformance
