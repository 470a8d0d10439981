#include "toolpath/rotary/arc_blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::path {

namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kLeastHeightSteps = 4;  // of the third point above the chord
constexpr double kLeastSteps = 20;       // of a program's numbers, in an arc's radius and between its ends
constexpr double kGreatestRadius_mm = 1e5;
constexpr double kSameEnd_mm = 1e-6;

// Returns the gap between the ends of an arc of that many turns, as if it were a circle.
double gap_mm(const ArcShape& arc, double turns) {
    return std::abs(turns - std::round(turns)) * kFullTurn_rad * arc.radius_mm();
}

bool closes(const ArcShape& arc, double turns) {
    return gap_mm(arc, turns) < kSameEnd_mm && std::abs(arc.radius_mm() - arc.end_radius_mm) < kSameEnd_mm;
}

}  // namespace

bool is_worth_an_arc(const ArcShape& arc, const MoveOptions& options) {
    const double least = kLeastSteps * options.resolution_mm;
    const double radius = arc.radius_mm();
    return radius >= least && radius <= kGreatestRadius_mm && radius * arc.turn_rad >= least;
}

// Returns 1 for an arc that nearly closes, because rounding might add or remove a circle.
int turns_in_one(const ArcShape& arc, const MoveOptions& options) {
    const double turns = arc.turn_rad / kFullTurn_rad;
    if (!options.arcs_of_turns) return 1;
    if (closes(arc, turns)) return static_cast<int>(std::round(turns));
    const bool nearly = gap_mm(arc, turns) < kLeastSteps * options.resolution_mm;
    return nearly ? 1 : static_cast<int>(std::ceil(turns));
}

// Halves an arc that nearly closes, because rounding might close it.
int pieces_in_plane(const ArcShape& arc, const MoveOptions& options) {
    const double turns = arc.turn_rad / kFullTurn_rad;
    const int pieces = std::max(1, static_cast<int>(std::ceil(turns - 1e-9)));
    const double share = turns / pieces;
    const bool nearly = share > 0.5 && gap_mm(arc, share) < kLeastSteps * options.resolution_mm;
    return nearly && !closes(arc, share) ? 2 * pieces : pieces;
}

// Halves an arc that nearly closes, if it would leave the tolerance. Its printed ends say little about its
// plane: rounded by a digit, they tilt it about the third point.
int pieces_through_points(const ArcShape& arc, const MoveOptions& options) {
    const double least_gap = std::min(2.0, options.resolution_mm / options.tolerance_mm);  // in radii
    const double widest_rad = kFullTurn_rad - 2 * std::asin(least_gap / 2);
    const int pieces = std::max(1, static_cast<int>(std::ceil(arc.turn_rad / widest_rad - 1e-9)));
    const double height_mm = arc.radius_mm() * (1 - std::cos(arc.turn_rad / pieces / 2));
    return height_mm >= kLeastHeightSteps * options.resolution_mm ? pieces : 0;
}

}  // namespace gsim::path
