#include "runtime/record/path_recorder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "runtime/path/arc_shape.h"
#include "runtime/path/validate.h"
#include "runtime/record/action_name.h"

namespace gsim::record {

using Eigen::Vector3d;
using path::MotionType;
using path::Point;
using simulation::ArcMove;
using simulation::AxisVector;
using simulation::Feed;
using simulation::LineMove;
using simulation::MoveKind;
using simulation::ViaMove;

namespace {

constexpr double kSamePlace = 1e-9;       // mm or deg; as the Simulator has it
constexpr double kTolerance_mm = 0.0005;  // of lines in place of another motion of the tip
constexpr std::array<double, 3> kQuarters = {0.25, 0.5, 0.75};
constexpr int kMostHalvings = 12;    // of such a motion, or of a quarter turn
constexpr double kMostTurns = 900;   // of one arc; paths take 1000
constexpr double kMostPieces = 1e6;  // of one move
constexpr int kSamples = 16;         // at which an arc with turning axes is looked at
constexpr std::size_t kMostTargets = 4'000'000;
constexpr double kGreatestRate = 1e9;  // that paths take
constexpr double kSecondsPerMinute = 60;
constexpr double kDegPerRad = 180 / std::numbers::pi;

std::optional<double> rate(double value) {
    if (!(value > 0)) return std::nullopt;
    return std::min(value, kGreatestRate);
}

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

bool PathRecorder::is_full() {
    if (builder_.target_count() < kMostTargets) return false;
    fault_ = fmt::format("the path would have more than {} targets", kMostTargets);
    return true;
}

Point PathRecorder::point_at(const AxisVector& axes, MotionType motion) {
    Point point;
    point.motion = motion;
    point.position_mm = place_.position(axes);
    std::optional<path::Orientation> orientation = place_.orientation(axes);
    if (orientation != in_force_.orientation) {
        point.orientation = orientation;
        in_force_.orientation = std::move(orientation);
    }
    return point;
}

void PathRecorder::set_feed(Point& point, const Feed& feed, bool rotary_alone) {
    if (feed.motion_s) {
        point.duration_s = rate(*feed.motion_s);
        return;
    }
    std::optional<double>& in_force = rotary_alone ? in_force_.feed_deg_min : in_force_.feed_mm_min;
    const std::optional<double> wanted = rate(rotary_alone ? feed.rotary_deg_min : feed.linear_mm_min);
    if (!wanted || wanted == in_force) return;
    in_force = wanted;
    (rotary_alone ? point.feed_deg_min : point.feed_mm_min) = wanted;
}

// The motion that follows depends on where it starts.
void PathRecorder::start_from(const AxisVector& from) {
    if (!builder_.at_beginning()) return;
    if (!builder_.has_targets()) return builder_.add(point_at(from, MotionType::rapid));
    builder_.depends_on({place_.position(from), place_.orientation(from)});
}

// A point where the program has come to, for what is done there.
void PathRecorder::hold(const AxisVector& at) {
    builder_.add(point_at(at, in_force_.feed_mm_min ? MotionType::linear : MotionType::rapid));
}

void PathRecorder::line(const AxisVector& from, const LineMove& move, bool rotary_alone) {
    if (is_full()) return;
    if ((move.target - from).cwiseAbs().maxCoeff() < kSamePlace) return;
    if (move.kind == MoveKind::thread) {
        notes_.insert("recorded path: threads are lines, no longer in step with the spindle");
    }
    if (move.kind == MoveKind::probe) {
        notes_.insert("recorded path: probing moves are lines to where this run ended them");
    }
    if (move.kind == MoveKind::rapid) {
        builder_.add(point_at(move.target, MotionType::rapid));
    } else {
        line_or_lines(from, move, rotary_alone);
    }
}

void PathRecorder::line_or_lines(const AxisVector& from, const LineMove& move, bool rotary_alone) {
    const Way way = [&](double share) { return AxisVector(from + share * (move.target - from)); };
    if (rotary_alone || move.feed.motion_s) start_from(from);
    if (place_.is_xyz_alone(from, move.target) || is_straight(way, 0, 1)) {
        Point point = point_at(move.target, MotionType::linear);
        set_feed(point, move.feed, rotary_alone);
        return builder_.add(std::move(point));
    }
    start_from(from);
    const double whole_mm = (place_.xyz(move.target) - place_.xyz(from)).norm();
    const double whole_deg = (move.target - from).norm();
    const double whole_s =
        move.feed.motion_s.value_or(kSecondsPerMinute * (rotary_alone ? whole_deg / move.feed.rotary_deg_min
                                                                      : whole_mm / move.feed.linear_mm_min));
    lines(way, 0, 1, move.feed, whole_s, 0);
}

// Looked at in its quarters.
bool PathRecorder::is_straight(const Way& way, double from, double to) const {
    const Vector3d first = place_.tip(way(from));
    const Vector3d last = place_.tip(way(to));
    return std::all_of(kQuarters.begin(), kQuarters.end(), [&](double share) {
        const Vector3d tip = place_.tip(way(from + share * (to - from)));
        return (tip - first - share * (last - first)).norm() <= kTolerance_mm;
    });
}

// Each line takes its share of the time: its length is not that of the axes' way.
void PathRecorder::lines(const Way& way, double from, double to, const Feed& feed, double whole_s,
                         int halvings) {
    if (is_full()) return;
    if (halvings < kMostHalvings && !is_straight(way, from, to)) {
        const double middle = (from + to) / 2;
        lines(way, from, middle, feed, whole_s, halvings + 1);
        lines(way, middle, to, feed, whole_s, halvings + 1);
        return;
    }
    Point point = point_at(way(to), MotionType::linear);
    if (place_.has_xyz()) {
        point.duration_s = rate(whole_s * (to - from));
    } else {
        set_feed(point, feed, false);
    }
    builder_.add(std::move(point));
}

void PathRecorder::arc(const AxisVector& from, const ArcMove& move) {
    if (is_full()) return;
    start_from(from);
    const Way way = way_of(from, move);
    if (arcs(from, move, way)) return;
    const double quarters = std::ceil(4 * move.sweep_rad / (2 * std::numbers::pi) - 1e-9);
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
                  std::ceil(move.sweep_rad / (2 * std::numbers::pi * kMostTurns))});
    if (!(pieces <= kMostPieces)) return false;

    const InForce before = in_force_;
    std::vector<Point> points;
    path::Vector start = place_.position(from);
    const bool turns = !place_.is_xyz_alone(from, target);
    for (double i = 1; i <= pieces; ++i) {
        Point point = point_at(way(i / pieces), MotionType::circular);
        const Vector3d sense = move.kind == MoveKind::arc_ccw ? up : Vector3d(-up);
        point.arc =
            path::CenterArc{to_path(tip_center), to_path(sense), move.sweep_rad / pieces * kDegPerRad};
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

void PathRecorder::dwell(const AxisVector& at, double seconds) {
    if (!(seconds > 0) || is_full()) return;
    const Point* last = builder_.last_point();
    if (last == nullptr || last->dwell_s > 0 || !last->actions.empty()) hold(at);
    builder_.last_point()->dwell_s = seconds;
}

void PathRecorder::event(const AxisVector& at, const simulation::Event& event) {
    std::optional<std::string> name = action_name(event);
    if (!name || is_full()) return;
    if (builder_.last_point() == nullptr) hold(at);
    builder_.last_point()->actions.push_back(*std::move(name));
}

void PathRecorder::enter_program(const std::string& name) {
    in_force_ = {};
    builder_.begin_call(name);
}

void PathRecorder::leave_program() {
    builder_.end_call();
}

void PathRecorder::service_motion() {
    fault_ =
        "the script moves by services of the controller (SetNextTarget and its kin), which tell no path; use "
        "words such as G1, or move";
}

tl::expected<path::Program, std::string> PathRecorder::finish(const std::string& name) {
    if (fault_.empty() && !builder_.has_targets()) fault_ = "the program neither moves nor switches anything";
    if (!fault_.empty()) return tl::unexpected(fault_);
    path::Program program = builder_.finish(name);
    if (const auto fault = path::validate(program)) return tl::unexpected(fault->sentence);
    return program;
}

}  // namespace gsim::record
