#pragma once

#include <Eigen/Core>

#include "motion/segment/segment.h"
#include "runtime/monitors/workpiece_tcp.h"

namespace gsim::simulation {

/// Max number of parts in which the path of a segment is checked: 8,192 turns. For more turns the path is
/// drawn coarser, as chords over these parts.
inline constexpr double kMaxParts = 65'536;

/// Returns the number of parts in which the path of the TCP is checked, so that none turns by more than an
/// eighth of a turn; an integer, at most kMaxParts.
double min_part_count(const motion::Segment& segment, const WorkpieceTcp& tcp);

/// Returns the distance of a point from the line between two others.
double point_line_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to);

/// Adds points of the TCP path on the part over a part of a segment, without the one at `from_s`. Lines
/// between them stay within `tolerance_mm` of the path. Calls `add(point_mm, t_s)`, with times since the
/// segment's start. Halves parts that are not straight, `halvings` times at most.
template <typename Add>
void add_tcp_curve(const motion::Segment& segment, const WorkpieceTcp& tcp, double tolerance_mm,
                   double from_s, double to_s, const Add& add, int halvings) {
    const auto at = [&](double t_s) { return tcp.at(segment.position_at(t_s)); };
    const Eigen::Vector3d from = at(from_s);
    const Eigen::Vector3d to = at(to_s);
    const double middle_s = (from_s + to_s) / 2;
    const auto close = [&](double t_s) { return point_line_distance(at(t_s), from, to) < tolerance_mm / 2; };
    const bool straight = close(middle_s) && close((from_s + middle_s) / 2) && close((middle_s + to_s) / 2);
    if (straight || halvings == 0) return add(to, to_s);
    add_tcp_curve(segment, tcp, tolerance_mm, from_s, middle_s, add, halvings - 1);
    add_tcp_curve(segment, tcp, tolerance_mm, middle_s, to_s, add, halvings - 1);
}

/// Does the same over the complete segment. `continues()`: false if no more points are wanted.
template <typename Add, typename GoesOn>
void add_tcp_path(const motion::Segment& segment, const WorkpieceTcp& tcp, double tolerance_mm,
                  const Add& add, const GoesOn& continues) {
    constexpr int kMaxHalvings = 12;
    const double parts = min_part_count(segment, tcp);
    const int halvings = parts < kMaxParts ? kMaxHalvings : 0;
    for (double i = 0; i < parts && continues(); ++i) {
        add_tcp_curve(segment, tcp, tolerance_mm, segment.duration_s * i / parts,
                      segment.duration_s * (i + 1) / parts, add, halvings);
    }
}

}  // namespace gsim::simulation
