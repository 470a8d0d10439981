#pragma once

#include <Eigen/Core>

#include "runtime/motion/segment.h"
#include "runtime/simulation/part_tip.h"

namespace gsim::simulation {

/// The least parts in which the way of the tip is looked at; a whole number.
double least_parts(const motion::Segment& segment);

/// The distance of a point from the line between two others.
double distance_from_line(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to);

/// Gives points of the tip's way on the part over a part of a segment, the one at `from_s` left out, such
/// that lines between them stay within `tolerance_mm` of it. `add(point_mm, t_s)`, with times since the
/// segment's start. Halves what is not straight, twelve times at most.
template <typename Add>
void add_tip_curve(const motion::Segment& segment, const PartTip& tip, double tolerance_mm, double from_s,
                   double to_s, const Add& add, int depth = 0) {
    constexpr int kMostHalvings = 12;
    const auto at = [&](double t_s) { return tip.at(segment.position_at(t_s)); };
    const Eigen::Vector3d from = at(from_s);
    const Eigen::Vector3d to = at(to_s);
    const double middle_s = (from_s + to_s) / 2;
    const auto close = [&](double t_s) { return distance_from_line(at(t_s), from, to) < tolerance_mm / 2; };
    const bool straight = close(middle_s) && close((from_s + middle_s) / 2) && close((middle_s + to_s) / 2);
    if (straight || depth == kMostHalvings) return add(to, to_s);
    add_tip_curve(segment, tip, tolerance_mm, from_s, middle_s, add, depth + 1);
    add_tip_curve(segment, tip, tolerance_mm, middle_s, to_s, add, depth + 1);
}

}  // namespace gsim::simulation
