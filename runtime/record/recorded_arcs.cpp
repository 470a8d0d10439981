// Arcs of the axes as arcs of the TCP.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "runtime/record/path_recorder.h"
#include "toolpath/model/arc_shape.h"

namespace gsim::record {

using Eigen::Vector3d;
using path::MotionType;
using path::Point;
using simulation::ArcMove;
using simulation::AxisVector;
using simulation::Feed;
using simulation::MoveKind;
using simulation::ViaMove;

namespace {

constexpr double kMostTurns = 900;   // of one arc; paths accept 1000
constexpr double kMostPieces = 1e6;  // of one move
constexpr int kSamples = 16;         // at which an arc with turning axes is looked at
constexpr double kFullTurn_rad = 2 * std::numbers::pi;

}  // namespace

void PathRecorder::arc(const AxisVector& from, const ArcMove& move) {
    if (is_full()) return;
    moves(from);
    start_from(from);
    const Way way = way_of(from, move);
    if (arcs(from, move, way)) return;
    const double quarters = std::ceil(4 * move.sweep_rad / kFullTurn_rad - 1e-9);
    if (!(quarters <= kMostPieces)) {
        fault_ = fmt::format("an arc of {:.6g} turns is too long for a path", quarters / 4);
        return;
    }
    const double length_mm = move.length_mm(place_.xyz(from), place_.xyz(move.target));
    const double whole_s =
        move.feed.motion_s.value_or(kSecondsPerMinute * length_mm / move.feed.linear_mm_min);
    for (double i = 0; i < quarters; ++i) {
        lines(way, i / quarters, (i + 1) / quarters, move.feed, whole_s, 0);
    }
}

PathRecorder::Way PathRecorder::way_of(const AxisVector& from, const ArcMove& move) const {
    const Vector3d start = place_.xyz(from);
    const Vector3d end = place_.xyz(move.target);
    const Vector3d radius = move.radius_to(start);
    const Vector3d foot = start - radius;  // on the arc's axis
    const Vector3d rise = move.normal.dot(end - start) * move.normal;
    const double growth = move.radius_to(end).norm() / radius.norm() - 1;
    return [=, this, axis = move.axis(), target = move.target, sweep_rad = move.sweep_rad](double share) {
        if (share >= 1) return target;
        AxisVector axes = from + share * (target - from);
        const Vector3d at = foot + share * rise +
                            (1 + share * growth) * (Eigen::AngleAxisd(share * sweep_rad, axis) * radius);
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (place_.axis(i) >= 0) axes[place_.axis(i)] = at[i];
        }
        return axes;
    };
}

// Writes the move as arcs of the TCP, if it is that. More than one if radii differ by more than an arc of a
// path may have, or for very many turns.
bool PathRecorder::arcs(const AxisVector& from, const ArcMove& move, const Way& way) {
    if (!place_.has_xyz()) return false;
    const auto shifted = [&](const Vector3d& by) {
        AxisVector axes = from;
        for (Eigen::Index i = 0; i < 3; ++i) axes[place_.axis(i)] += by[i];
        return place_.tip(axes);
    };
    const Vector3d tip = place_.tip(from);
    const Vector3d tip_center = shifted(-move.radius_to(place_.xyz(from)));
    const Vector3d first = move.normal.unitOrthogonal();
    const Vector3d second = move.normal.cross(first);
    const Vector3d up = (shifted(first) - tip).cross(shifted(second) - tip).normalized();
    const double start_mm = (tip - tip_center).norm();
    const AxisVector& target = move.target;
    const double end_mm = move.radius_to(place_.xyz(target)).norm();
    const double pieces =
        std::max({1.0, std::ceil(std::abs(end_mm - start_mm) / (0.8 * path::kArcTolerance_mm)),
                  std::ceil(move.sweep_rad / (kFullTurn_rad * kMostTurns))});
    if (!(pieces <= kMostPieces)) return false;

    const InForce before = in_force_;
    std::vector<Point> points;
    path::Vector start = place_.position(from);
    const bool turns = !place_.is_xyz_alone(from, target);
    for (double i = 1; i <= pieces; ++i) {
        Point point = point_at(way(i / pieces), MotionType::circular);
        const Vector3d sense = move.kind == MoveKind::arc_ccw ? up : Vector3d(-up);
        point.arc = path::CenterArc{to_path(tip_center), to_path(sense),
                                    rounded(move.sweep_rad / pieces * kDegPerRad)};
        Feed feed = move.feed;
        if (feed.motion_s) *feed.motion_s /= pieces;
        set_feed(point, feed, false);
        if (!path::arc_shape(start, point) ||
            (turns && !is_on(start, point, way, (i - 1) / pieces, i / pieces))) {
            in_force_ = before;
            return false;
        }
        start = point.position_mm;
        points.push_back(std::move(point));
    }
    for (Point& point : points) builder_.add(std::move(point));
    return true;
}

// Returns true if the TCP moves along that arc while axes turn.
bool PathRecorder::is_on(const path::Vector& start_mm, const Point& arc, const Way& way, double from,
                         double to) const {
    const path::ArcShape shape = path::arc_shape(start_mm, arc).value();
    for (int i = 1; i < kSamples; ++i) {
        const double share = static_cast<double>(i) / kSamples;
        if ((shape.at(share) - place_.tip(way(from + share * (to - from)))).norm() > kTolerance_mm)
            return false;
    }
    return true;
}

void PathRecorder::arc(const AxisVector& from, const ViaMove& move) {
    if (is_full()) return;
    moves(from);
    start_from(from);
    const InForce before = in_force_;
    Point point = point_at(move.target, MotionType::circular);
    point.arc = path::ViaPoint{place_.position(move.via)};
    set_feed(point, move.feed, false);
    if (path::arc_shape(place_.position(from), point)) return builder_.add(std::move(point));
    in_force_ = before;  // through points on a line
    Point via = point_at(move.via, MotionType::linear);
    set_feed(via, move.feed, false);
    builder_.add(std::move(via));
    Point end = point_at(move.target, MotionType::linear);
    set_feed(end, move.feed, false);
    builder_.add(std::move(end));
}

}  // namespace gsim::record
