#include "toolpath/rotary/arc_blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::path {

namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kMinHeightSteps = 4;  // of the third point above the chord
constexpr double kMinSteps = 20;       // of a program's numbers, in an arc's radius and between its ends
constexpr double kMaxArcRadius_mm = 1e5;
constexpr double kEndTolerance_mm = 1e-6;

// Returns the gap between the ends of an arc of that many turns, as if it were a circle.
double gap_mm(const ArcShape& arc, double turns) {
    return std::abs(turns - std::round(turns)) * kFullTurn_rad * arc.radius_mm();
}

bool closes(const ArcShape& arc, double turns) {
    return gap_mm(arc, turns) < kEndTolerance_mm &&
           std::abs(arc.radius_mm() - arc.end_radius_mm) < kEndTolerance_mm;
}

}  // namespace

bool is_representable_arc(const ArcShape& arc, const MoveOptions& options) {
    const double min = kMinSteps * options.resolution_mm;
    const double radius = arc.radius_mm();
    return radius >= min && radius <= kMaxArcRadius_mm && radius * arc.turn_rad >= min;
}

// Returns 1 for an arc that nearly closes, because rounding might add or remove a circle.
int turns_per_block(const ArcShape& arc, const MoveOptions& options) {
    const double turns = arc.turn_rad / kFullTurn_rad;
    if (!options.multi_turn_arcs) return 1;
    if (closes(arc, turns)) return static_cast<int>(std::round(turns));
    const bool is_nearly_closed = gap_mm(arc, turns) < kMinSteps * options.resolution_mm;
    return is_nearly_closed ? 1 : static_cast<int>(std::ceil(turns));
}

// Halves an arc that nearly closes, because rounding might close it.
int planar_block_count(const ArcShape& arc, const MoveOptions& options) {
    const double turns = arc.turn_rad / kFullTurn_rad;
    const int parts = std::max(1, static_cast<int>(std::ceil(turns - 1e-9)));
    const double share = turns / parts;
    const bool is_nearly_closed = share > 0.5 && gap_mm(arc, share) < kMinSteps * options.resolution_mm;
    return is_nearly_closed && !closes(arc, share) ? 2 * parts : parts;
}

// Halves an arc that nearly closes, if it would leave the tolerance. Its printed ends say little about its
// plane: rounded by a digit, they tilt it about the third point.
int three_point_block_count(const ArcShape& arc, const MoveOptions& options) {
    const double min_gap = std::min(2.0, options.resolution_mm / options.tolerance_mm);  // in radii
    const double max_sweep_rad = kFullTurn_rad - 2 * std::asin(min_gap / 2);
    const int parts = std::max(1, static_cast<int>(std::ceil(arc.turn_rad / max_sweep_rad - 1e-9)));
    const double height_mm = arc.radius_mm() * (1 - std::cos(arc.turn_rad / parts / 2));
    return height_mm >= kMinHeightSteps * options.resolution_mm ? parts : 0;
}

}  // namespace gsim::path
