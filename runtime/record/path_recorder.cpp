#include "runtime/record/path_recorder.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "runtime/record/action_name.h"
#include "toolpath/model/validate.h"

namespace gsim::record {

using Eigen::Vector3d;
using path::MotionType;
using path::Point;
using simulation::AxisVector;
using simulation::Feed;
using simulation::LineMove;
using simulation::MoveKind;

namespace {

constexpr double kSamePlace = 1e-9;  // mm or deg; as the Simulator has it
constexpr std::array<double, 3> kQuarters = {0.25, 0.5, 0.75};
constexpr int kMostHalvings = 12;  // of such a motion, or of a quarter turn
constexpr std::size_t kMostTargets = 4'000'000;
constexpr double kGreatestRate = 1e9;  // that paths accept

std::optional<double> rate(double value) {
    if (!(value > 0)) return std::nullopt;
    return std::min(value, kGreatestRate);
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
    if (work_offset_ != in_force_.work_offset) {
        point.work_offset = work_offset_;
        in_force_.work_offset = work_offset_;
    }
    return point;
}

// Adds the first point of the program: the machine is already there, and no move leads to it.
void PathRecorder::begin(const AxisVector& at) {
    if (!builder_.has_targets() && builder_.at_beginning()) builder_.add(point_at(at, MotionType::none));
}

// Prepares for a move, which is reported next.
void PathRecorder::moves(const AxisVector& from) {
    begin(from);
    tell_rest(from);
    time_has_passed_ = true;
}

void PathRecorder::set_feed(Point& point, const Feed& feed, bool rotary_alone) {
    if (feed.motion_s) {
        point.duration_s = rate(*feed.motion_s);
        return;
    }
    if (rotary_alone) {
        const std::optional<double> wanted = rate(feed.rotary_deg_min);
        if (wanted == in_force_.feed_deg_min) return;
        in_force_.feed_deg_min = wanted;
        point.feed_deg_min = wanted;
        return;
    }
    const std::optional<double> wanted = rate(feed.linear_mm_min);
    const std::optional<double> per_rev = rate(feed.linear_mm_rev.value_or(0));
    if (!wanted || (wanted == in_force_.feed_mm_min && per_rev == in_force_.feed_mm_rev)) return;
    in_force_.feed_mm_min = point.feed_mm_min = wanted;
    in_force_.feed_mm_rev = point.feed_mm_rev = per_rev;
}

// Records that the motion that follows depends on its start.
void PathRecorder::start_from(const AxisVector& from) {
    if (builder_.at_beginning()) builder_.depends_on({place_.position(from), place_.orientation(from)});
}

// Adds a point that the program has reached, for the actions there.
void PathRecorder::hold(const AxisVector& at) {
    builder_.add(point_at(at, MotionType::none));
}

void PathRecorder::line(const AxisVector& from, const LineMove& move, bool rotary_alone) {
    if (is_full()) return;
    if ((move.target - from).cwiseAbs().maxCoeff() < kSamePlace) return;
    moves(from);
    if (move.kind == MoveKind::probe) {
        notes_.insert("recorded path: probing moves are lines to where this run ended them");
    }
    if (place_.moves_other_linear_axes(from, move.target)) {
        notes_.insert(
            "recorded path: what axes beside X, Y and Z carry the tool is in its positions; programs written "
            "from the path move X, Y and Z in their place");
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
        Feed feed = move.feed;
        if (move.kind == MoveKind::thread) point.lead_mm = std::exchange(feed.linear_mm_rev, std::nullopt);
        set_feed(point, feed, rotary_alone);
        return builder_.add(std::move(point));
    }
    if (move.kind == MoveKind::thread)
        notes_.insert(
            "recorded path: threads with turning axes are lines, no longer in step with the spindle");
    start_from(from);
    const double whole_mm = (place_.xyz(move.target) - place_.xyz(from)).norm();
    const double whole_deg = (move.target - from).norm();
    const double whole_s =
        move.feed.motion_s.value_or(kSecondsPerMinute * (rotary_alone ? whole_deg / move.feed.rotary_deg_min
                                                                      : whole_mm / move.feed.linear_mm_min));
    lines(way, 0, 1, move.feed, whole_s, 0);
}

// Checks its quarters.
bool PathRecorder::is_straight(const Way& way, double from, double to) const {
    const Vector3d first = place_.tip(way(from));
    const Vector3d last = place_.tip(way(to));
    return std::all_of(kQuarters.begin(), kQuarters.end(), [&](double share) {
        const Vector3d tip = place_.tip(way(from + share * (to - from)));
        return (tip - first - share * (last - first)).norm() <= kTolerance_mm;
    });
}

// Gives each line its share of the time: its length is not that of the axes' path, and its feed another one.
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
    if (!place_.has_xyz()) {
        set_feed(point, feed, false);
    } else if (feed.motion_s) {
        point.duration_s = rate(whole_s * (to - from));
    } else {
        const double minutes = whole_s * (to - from) / kSecondsPerMinute;
        const double way_mm = (place_.tip(way(to)) - place_.tip(way(from))).norm();
        const double turn_deg = (way(to) - way(from)).norm();
        const bool stands = way_mm < kDegPerMm * turn_deg;
        set_feed(point, {way_mm / minutes, turn_deg / minutes, std::nullopt}, stands);
    }
    builder_.add(std::move(point));
}

void PathRecorder::dwell(const AxisVector& at, double seconds) {
    if (is_full()) return;
    if (!(seconds > 0)) return rest(at);
    begin(at);
    const Point* last = builder_.last_point();
    if (last == nullptr || last->dwell_s > 0 || !last->actions.empty()) hold(at);
    builder_.last_point()->dwell_s = seconds;
    rests_ = false;
    time_has_passed_ = true;
}

// Records that the next motion begins at standstill, which no dwell or switch says.
void PathRecorder::tell_rest(const AxisVector& at) {
    if (std::exchange(rests_, false)) act(at, "rest");
}

void PathRecorder::act(const AxisVector& at, std::string action) {
    if (is_full()) return;
    tell_rest(at);
    begin(at);
    if (builder_.last_point() == nullptr) hold(at);
    builder_.last_point()->actions.push_back(std::move(action));
}

void PathRecorder::event(const AxisVector& at, const simulation::Event& event, bool at_rest) {
    std::optional<std::string> name = action_name(event);
    if (!name) {
        if (at_rest) rest(at);
        return;
    }
    if (at_rest) time_has_passed_ = rests_ = false;
    act(at, *std::move(name));
}

void PathRecorder::enter_program(const std::string& name) {
    in_force_ = {};
    builder_.begin_call(name);
}

void PathRecorder::leave_program() {
    builder_.end_call();
}

void PathRecorder::untold_motion(std::string_view why) {
    if (fault_.empty()) fault_ = why;
}

tl::expected<path::Program, std::string> PathRecorder::finish(const std::string& name) {
    if (builder_.has_targets()) tell_rest(rest_at_);
    if (fault_.empty() && !builder_.has_targets()) fault_ = "the program neither moves nor switches anything";
    if (!fault_.empty()) return tl::unexpected(fault_);
    path::Program program = builder_.finish(name);
    program.work_offsets = std::move(work_offsets_);
    if (const auto fault = path::validate(program)) return tl::unexpected(fault->sentence);
    return program;
}

}  // namespace gsim::record
