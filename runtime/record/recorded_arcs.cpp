// Arcs of the axes as arcs of the tool's tip.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "runtime/path/arc_shape.h"
#include "runtime/record/path_recorder.h"

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

constexpr double kMostTurns = 900;   // of one arc; paths take 1000
constexpr double kMostPieces = 1e6;  // of one move
constexpr int kSamples = 16;         // at which an arc with turning axes is looked at
constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kDegPerRad = 180 / std::numbers::pi;
constexpr double kSecondsPerMinute = 60;

// Axes of a plane in the order that its arcs are counted in: first, second, normal.
std::array<Eigen::Index, 3> plane_axes(simulation::Plane plane) {
    switch (plane) {
        case simulation::Plane::xy: return {0, 1, 2};
        case simulation::Plane::zx: return {2, 0, 1};
        case simulation::Plane::yz: return {1, 2, 0};
    }
    return {0, 1, 2};
}

}  // namespace

void PathRecorder::arc(const AxisVector& from, const ArcMove& move) {
    if (is_full()) return;
    start_from(from);
    const Way way = way_of(from, move);
    if (arcs(from, move, way)) return;
    const double quarters = std::ceil(4 * move.sweep_rad / kFullTurn_rad - 1e-9);
    if (!(quarters <= kMostPieces)) {
        fault_ = fmt::format("an arc of {:.6g} turns is too long for a path", quarters / 4);
        return;
    }
    const auto [first, second, normal] = plane_axes(move.plane);
    const Vector3d start = place_.xyz(from);
    const double radius_mm =
        std::hypot(start[first] - move.center_first_mm, start[second] - move.center_second_mm);
    const double length_mm =
        std::hypot(radius_mm * move.sweep_rad, place_.xyz(move.target)[normal] - start[normal]);
    const double whole_s =
        move.feed.motion_s.value_or(kSecondsPerMinute * length_mm / move.feed.linear_mm_min);
    for (double i = 0; i < quarters; ++i) {
        lines(way, i / quarters, (i + 1) / quarters, move.feed, whole_s, 0);
    }
}

PathRecorder::Way PathRecorder::way_of(const AxisVector& from, const ArcMove& move) const {
    const auto [first, second, normal] = plane_axes(move.plane);
    const Eigen::Index x = place_.axis(first);
    const Eigen::Index y = place_.axis(second);
    const Eigen::Vector2d center(move.center_first_mm, move.center_second_mm);
    const auto in_plane = [x, y](const AxisVector& axes) {
        return Eigen::Vector2d(x < 0 ? 0 : axes[x], y < 0 ? 0 : axes[y]);
    };
    const Eigen::Vector2d radius = in_plane(from) - center;
    const double growth = (in_plane(move.target) - center).norm() / radius.norm() - 1;
    const double sense = move.kind == MoveKind::arc_ccw ? 1 : -1;
    return [=, target = move.target, sweep_rad = sense * move.sweep_rad](double share) {
        if (share >= 1) return target;
        AxisVector axes = from + share * (target - from);
        const Eigen::Vector2d at =
            center + (1 + share * growth) * (Eigen::Rotation2Dd(share * sweep_rad) * radius);
        if (x >= 0) axes[x] = at[0];
        if (y >= 0) axes[y] = at[1];
        return axes;
    };
}

// The move as arcs of the tip, if it is that. More than one where radii differ by more than an arc of a path
// may have, or of very many turns.
bool PathRecorder::arcs(const AxisVector& from, const ArcMove& move, const Way& way) {
    if (!place_.has_xyz()) return false;
    const auto [first, second, normal] = plane_axes(move.plane);
    const auto shifted = [&](Eigen::Index direction) {
        AxisVector axes = from;
        axes[place_.axis(direction)] += 1;
        return Vector3d(place_.tip(axes) - place_.tip(from));
    };
    AxisVector center = from;
    center[place_.axis(first)] = move.center_first_mm;
    center[place_.axis(second)] = move.center_second_mm;
    const Vector3d tip_center = place_.tip(center);
    const Vector3d up = shifted(first).cross(shifted(second)).normalized();
    const double start_mm = (place_.tip(from) - tip_center).norm();
    const AxisVector& target = move.target;
    const double end_mm = std::hypot(target[place_.axis(first)] - move.center_first_mm,
                                     target[place_.axis(second)] - move.center_second_mm);
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

// Whether the tip goes that arc while axes turn.
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
