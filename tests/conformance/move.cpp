#include "tests/conformance/move.h"

#include <algorithm>

#include "base/text/format.h"

namespace gsim::conformance {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kKinds{"rapid"sv, "linear"sv, "arc_cw"sv, "arc_ccw"sv,
                            "probe"sv, "thread"sv, "spline"sv, "dwell"sv};

template <typename Value, std::size_t count>
std::optional<Value> find_value(const std::array<std::string_view, count>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Value>(found - names.begin());
}

}  // namespace

std::string_view name(Kind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

std::optional<Kind> parse_kind(std::string_view name) {
    return find_value<Kind>(kKinds, name);
}

std::string describe(const Move& move) {
    std::string text(name(move.kind));
    if (move.kind == Kind::dwell) {
        text::append_format(text, " {:.4f} s", move.dwell_s);
        return text;
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const bool always = axis < kLinearAxes;
        if (always || move.to[axis] != 0) text::append_format(text, " {}{:.5f}", kAxes[axis], move.to[axis]);
    }
    if (move.arc) {
        const auto& normal = move.arc->normal;
        text::append_format(text, ", normal {:.6f} {:.6f} {:.6f}, centre", normal[0], normal[1], normal[2]);
        for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
            text::append_format(text, " {}{:.5f}", kAxes[axis], move.arc->center_mm[axis]);
        }
        text::append_format(text, ", turns {}", move.arc->turns);
    }
    if (move.feed_per_min) text::append_format(text, ", feed {:.6g}", *move.feed_per_min);
    return text;
}

}  // namespace gsim::conformance
