#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace gsim::conformance {

/// The axes that are compared; the reference does not print U, V and W.
inline constexpr std::string_view kAxes = "XYZABC";
inline constexpr std::size_t kAxisCount = kAxes.size();
inline constexpr std::size_t kLinearAxes = 3;  ///< The first of them, in mm; the others are in degrees.

using AxisValues = std::array<double, kAxisCount>;

enum class Kind { rapid, linear, arc_cw, arc_ccw, probe, thread, spline, dwell };

enum class Plane { xy, zx, yz };

/// The two axes of a plane, as indices into kAxes, in the order in which a turn from the first to the second
/// is counter-clockwise.
constexpr std::array<std::size_t, 2> plane_axes(Plane plane) {
    if (plane == Plane::zx) return {2, 0};
    if (plane == Plane::yz) return {1, 2};
    return {0, 1};
}

constexpr bool is_arc(Kind kind) {
    return kind == Kind::arc_cw || kind == Kind::arc_ccw;
}

using Vector = std::array<double, 3>;  ///< X, Y, Z

/// About which arcs of a plane are counter-clockwise.
constexpr Vector plane_normal(Plane plane) {
    if (plane == Plane::zx) return {0, 1, 0};
    if (plane == Plane::yz) return {1, 0, 0};
    return {0, 0, 1};
}

/// Values that only arcs have.
struct ArcPart {
    Vector normal = plane_normal(Plane::xy);  ///< Unit; the kind is the sense as seen against it.
    Vector center_mm{};                       ///< Irrelevant along the arc's own axis.
    int turns = 1;                            ///< 1 up to a full circle, 2 for one more.
};

/// One move or dwell of a run of gsim, in machine coordinates.
struct Move {
    Kind kind = Kind::rapid;
    AxisValues to{};  ///< mm and deg
    std::optional<ArcPart> arc = {};
    std::optional<double> feed_per_min = {};  ///< mm/min, or deg/min if only rotary axes move.
    double dwell_s = 0;
    long line = 0;  ///< Line of the part program; 0 if unknown.
};

std::string_view name(Kind kind);
std::optional<Kind> parse_kind(std::string_view name);

/// The move for people, without its line.
std::string describe(const Move& move);

}  // namespace gsim::conformance
