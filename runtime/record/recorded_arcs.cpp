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

constexpr double kMaxTurns = 900;  // of one arc; paths accept 1000
constexpr double kMaxArcs = 1e6;   // of one move
constexpr int kSamples = 16;       // at which an arc with turning axes is looked at
constexpr double kFullTurn_rad = 2 * std::numbers::pi;

}  // namespace

void PathRecorder::arc(const AxisVector& from, const ArcMove& move) {
    if (is_full()) return;
    moves(from);
    depend_on_start(from);
    const AxisPath axis_path = arc_path(from, move);
    if (arcs(from, move, axis_path)) return;
    const double quarters = std::ceil(4 * move.sweep_rad / kFullTurn_rad - 1e-9);
    if (!(quarters <= kMaxArcs)) {
        error_ = fmt::format("an arc of {:.6g} turns is too long for a path", quarters / 4);
        return;
    }
    const double length_mm = move.length_mm(tool_position_.xyz(from), tool_position_.xyz(move.target));
    const double total_s =
        move.feed.motion_s.value_or(kSecondsPerMinute * length_mm / move.feed.linear_mm_min);
    for (double i = 0; i < quarters; ++i) {
        lines(axis_path, i / quarters, (i + 1) / quarters, move.feed, total_s, 0);
    }
}

PathRecorder::AxisPath PathRecorder::arc_path(const AxisVector& from, const ArcMove& move) const {
    const Vector3d start = tool_position_.xyz(from);
    const Vector3d end = tool_position_.xyz(move.target);
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
            if (tool_position_.axis(i) >= 0) axes[tool_position_.axis(i)] = at[i];
        }
        return axes;
    };
}

// Writes the move as arcs of the TCP, if it is that. More than one if radii differ by more than an arc of a
// path may have, or for very many turns.
bool PathRecorder::arcs(const AxisVector& from, const ArcMove& move, const AxisPath& axis_path) {
    if (!tool_position_.has_xyz()) return false;
    const auto shifted_by = [&](const Vector3d& by) {
        AxisVector axes = from;
        for (Eigen::Index i = 0; i < 3; ++i) axes[tool_position_.axis(i)] += by[i];
        return tool_position_.tcp(axes);
    };
    const Vector3d tcp = tool_position_.tcp(from);
    const Vector3d tcp_center = shifted_by(-move.radius_to(tool_position_.xyz(from)));
    const Vector3d first = move.normal.unitOrthogonal();
    const Vector3d second = move.normal.cross(first);
    const Vector3d up = (shifted_by(first) - tcp).cross(shifted_by(second) - tcp).normalized();
    const double start_mm = (tcp - tcp_center).norm();
    const AxisVector& target = move.target;
    const double end_mm = move.radius_to(tool_position_.xyz(target)).norm();
    const double parts =
        std::max({1.0, std::ceil(std::abs(end_mm - start_mm) / (0.8 * path::kArcTolerance_mm)),
                  std::ceil(move.sweep_rad / (kFullTurn_rad * kMaxTurns))});
    if (!(parts <= kMaxArcs)) return false;

    const ActiveSettings before = active_settings_;
    std::vector<Point> points;
    path::Vector start = tool_position_.position(from);
    const bool turns = !tool_position_.only_xyz_moves(from, target);
    for (double i = 1; i <= parts; ++i) {
        Point point = point_at(axis_path(i / parts), MotionType::circular);
        const Vector3d sense = move.kind == MoveKind::arc_ccw ? up : Vector3d(-up);
        point.arc = path::CenterArc{to_path(tcp_center), to_path(sense),
                                    rounded(move.sweep_rad / parts * kDegPerRad)};
        Feed feed = move.feed;
        if (feed.motion_s) *feed.motion_s /= parts;
        set_feed(point, feed, false);
        if (!path::arc_shape(start, point) ||
            (turns && !is_on(start, point, axis_path, (i - 1) / parts, i / parts))) {
            active_settings_ = before;
            return false;
        }
        start = point.position_mm;
        points.push_back(std::move(point));
    }
    for (Point& point : points) builder_.add(std::move(point));
    return true;
}

// Returns true if the TCP moves along that arc while axes turn.
bool PathRecorder::is_on(const path::Vector& start_mm, const Point& arc, const AxisPath& axis_path,
                         double from, double to) const {
    const path::ArcShape shape = path::arc_shape(start_mm, arc).value();
    for (int i = 1; i < kSamples; ++i) {
        const double share = static_cast<double>(i) / kSamples;
        if ((shape.at(share) - tool_position_.tcp(axis_path(from + share * (to - from)))).norm() >
            kTolerance_mm)
            return false;
    }
    return true;
}

void PathRecorder::arc(const AxisVector& from, const ViaMove& move) {
    if (is_full()) return;
    moves(from);
    depend_on_start(from);
    const ActiveSettings before = active_settings_;
    Point point = point_at(move.target, MotionType::circular);
    point.arc = path::ViaPoint{tool_position_.position(move.via)};
    set_feed(point, move.feed, false);
    if (path::arc_shape(tool_position_.position(from), point)) return builder_.add(std::move(point));
    active_settings_ = before;  // through points on a line
    Point via = point_at(move.via, MotionType::linear);
    set_feed(via, move.feed, false);
    builder_.add(std::move(via));
    Point end = point_at(move.target, MotionType::linear);
    set_feed(end, move.feed, false);
    builder_.add(std::move(end));
}

}  // namespace gsim::record
