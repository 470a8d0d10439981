#include "motion/linuxcnc/merged_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kMaxLines = 100;
constexpr double kLevelTolerance = 1e-9;  // slope of a plane that counts as that of XY
constexpr double kOneTurn_rad = 2 * std::numbers::pi + 1e-5;

// The height over the chord shows how far an arc of at most one turn deviates from it. Arcs of more turns are
// always driven: LinuxCNC's own test ignores full turns, and would leave them out if the remainder is flat.
bool flat(const PathMove& move) {
    const Arc& arc = move.arc;
    if (arc.sweep_rad > kOneTurn_rad) return false;
    const bool level = std::abs(arc.u.z()) < kLevelTolerance && std::abs(arc.v.z()) < kLevelTolerance;
    return level && arc.radius_mm * (1 - std::cos(arc.sweep_rad / 2)) < move.merge_tolerance_mm;
}

/// True if a point is within `tolerance_mm` of the line from `start` by `displacement`.
bool is_within_box(double tolerance_mm, const Vector3d& point, const Vector3d& start,
                   const Vector3d& displacement) {
    const Vector3d to_point = point - start;
    const double share = std::clamp(to_point.dot(displacement) / displacement.squaredNorm(), 0.0, 1.0);
    return (to_point - share * displacement).squaredNorm() <= tolerance_mm * tolerance_mm;
}

bool same_rules(const PathMove& a, const PathMove& b) {
    return a.rules.programmed_speed_mm_s == b.rules.programmed_speed_mm_s &&
           a.rules.max_path_speed_mm_s == b.rules.max_path_speed_mm_s &&
           a.rules.path_acceleration_mm_s2 == b.rules.path_acceleration_mm_s2 &&
           a.rules.min_duration_s <= 0 && b.rules.min_duration_s <= 0 &&
           a.enabled_overrides == b.enabled_overrides && a.rules.follows_spindle == b.rules.follows_spindle &&
           a.tolerance_mm == b.tolerance_mm && a.merge_tolerance_mm == b.merge_tolerance_mm;
}

}  // namespace

bool may_merge(const PathMove& move) {
    if (move.rapid || move.mode != rrs::PathMode::continuous || !(move.merge_tolerance_mm > 0)) return false;
    return move.kind != SegmentKind::circular || flat(move);
}

bool MergedLines::accepts(const PathMove& line) const {
    if (ends_.size() > kMaxLines || !same_rules(line, line_)) return false;
    const Vector3d start = axes_.point(line_.start);
    const Vector3d displacement = axes_.point(line.end) - start;
    if (!(displacement.squaredNorm() > 0)) return false;
    return std::all_of(ends_.begin(), ends_.end(), [&](const Vector3d& end) {
        return is_within_box(line.merge_tolerance_mm, end, start, displacement);
    });
}

void MergedLines::add(const PathMove& line) {
    const rrs::JointPos start = empty() ? line.start : line_.start;
    line_ = line;
    line_.start = start;
    ends_.push_back(axes_.point(line.end));
}

PathMove line_to_end(const PathMove& move, const rrs::JointPos& start) {
    PathMove line = move;
    line.kind = SegmentKind::linear;
    line.start = start;
    if (move.kind == SegmentKind::circular && move.rules.min_duration_s > 0) {
        line.rules.programmed_speed_mm_s = move.arc.length_mm() / move.rules.min_duration_s;
        line.rules.min_duration_s = 0;
    }
    return line;
}

PathMove line_to_middle(const PathMove& move, const Axes& axes) {
    PathMove line = line_to_end(move, move.start);
    line.end = (move.start + move.end) / 2;
    axes.set_point(move.arc.at(move.arc.sweep_rad / 2), line.end);
    return line;
}

}  // namespace gsim::motion::linuxcnc
