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

constexpr double kPositionTolerance = 1e-9;  // mm or deg; as ProgramPosition has it
constexpr std::array<double, 3> kQuarters = {0.25, 0.5, 0.75};
constexpr int kMaxHalvings = 12;  // of such a motion, or of a quarter turn
constexpr std::size_t kMaxTargets = 4'000'000;
constexpr double kMaxRate = 1e9;  // that paths accept

std::optional<double> rate(double value) {
    if (!(value > 0)) return std::nullopt;
    return std::min(value, kMaxRate);
}

}  // namespace

bool PathRecorder::is_full() {
    if (builder_.target_count() < kMaxTargets) return false;
    error_ = fmt::format("the path would have more than {} targets", kMaxTargets);
    return true;
}

Point PathRecorder::point_at(const AxisVector& axes, MotionType motion) {
    Point point;
    point.motion = motion;
    point.position_mm = tool_position_.position(axes);
    std::optional<path::Orientation> orientation = tool_position_.orientation(axes);
    if (orientation != active_settings_.orientation) {
        point.orientation = orientation;
        active_settings_.orientation = std::move(orientation);
    }
    if (work_offset_ != active_settings_.work_offset) {
        point.work_offset = work_offset_;
        active_settings_.work_offset = work_offset_;
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
    record_standstill(from);
    moved_since_standstill_ = true;
}

void PathRecorder::set_feed(Point& point, const Feed& feed, bool is_rotary_only) {
    if (feed.motion_s) {
        point.duration_s = rate(*feed.motion_s);
        return;
    }
    if (is_rotary_only) {
        const std::optional<double> requested = rate(feed.rotary_deg_min);
        if (requested == active_settings_.feed_deg_min) return;
        active_settings_.feed_deg_min = requested;
        point.feed_deg_min = requested;
        return;
    }
    const std::optional<double> requested = rate(feed.linear_mm_min);
    const std::optional<double> per_rev = rate(feed.linear_mm_rev.value_or(0));
    if (!requested || (requested == active_settings_.feed_mm_min && per_rev == active_settings_.feed_mm_rev))
        return;
    active_settings_.feed_mm_min = point.feed_mm_min = requested;
    active_settings_.feed_mm_rev = point.feed_mm_rev = per_rev;
}

// Records that the motion that follows depends on its start.
void PathRecorder::depend_on_start(const AxisVector& from) {
    if (builder_.at_beginning())
        builder_.depends_on({tool_position_.position(from), tool_position_.orientation(from)});
}

// Adds a point that the program has reached, for the actions there.
void PathRecorder::add_action_point(const AxisVector& at) {
    builder_.add(point_at(at, MotionType::none));
}

void PathRecorder::line(const AxisVector& from, const LineMove& move, bool is_rotary_only) {
    if (is_full()) return;
    if ((move.target - from).cwiseAbs().maxCoeff() < kPositionTolerance) return;
    moves(from);
    if (move.kind == MoveKind::probe) {
        notes_.insert("recorded path: probing moves are lines to the point where they ended in this run");
    }
    if (tool_position_.moves_other_linear_axes(from, move.target)) {
        notes_.insert(
            "recorded path: axes other than X, Y and Z that carry the tool are included in its positions; "
            "programs written from the path move X, Y and Z instead");
    }
    if (move.kind == MoveKind::rapid) {
        builder_.add(point_at(move.target, MotionType::rapid));
    } else {
        record_line(from, move, is_rotary_only);
    }
}

void PathRecorder::record_line(const AxisVector& from, const LineMove& move, bool is_rotary_only) {
    const AxisPath axis_path = [&](double share) { return AxisVector(from + share * (move.target - from)); };
    if (is_rotary_only || move.feed.motion_s) depend_on_start(from);
    if (tool_position_.only_xyz_moves(from, move.target) || is_straight(axis_path, 0, 1)) {
        Point point = point_at(move.target, MotionType::linear);
        Feed feed = move.feed;
        if (move.kind == MoveKind::thread) point.lead_mm = std::exchange(feed.linear_mm_rev, std::nullopt);
        set_feed(point, feed, is_rotary_only);
        return builder_.add(std::move(point));
    }
    if (move.kind == MoveKind::thread)
        notes_.insert(
            "recorded path: threads with rotating axes are lines, no longer in step with the spindle");
    depend_on_start(from);
    const double full_length_mm = (tool_position_.xyz(move.target) - tool_position_.xyz(from)).norm();
    const double total_deg = (move.target - from).norm();
    const double total_s = move.feed.motion_s.value_or(
        kSecondsPerMinute *
        (is_rotary_only ? total_deg / move.feed.rotary_deg_min : full_length_mm / move.feed.linear_mm_min));
    lines(axis_path, 0, 1, move.feed, total_s, 0);
}

// Checks its quarters.
bool PathRecorder::is_straight(const AxisPath& axis_path, double from, double to) const {
    const Vector3d first = tool_position_.tcp(axis_path(from));
    const Vector3d last = tool_position_.tcp(axis_path(to));
    return std::all_of(kQuarters.begin(), kQuarters.end(), [&](double share) {
        const Vector3d tcp = tool_position_.tcp(axis_path(from + share * (to - from)));
        return (tcp - first - share * (last - first)).norm() <= kTolerance_mm;
    });
}

// Gives each line its share of the time: its length is not that of the axes' path, and its feed another one.
void PathRecorder::lines(const AxisPath& axis_path, double from, double to, const Feed& feed, double total_s,
                         int halvings) {
    if (is_full()) return;
    if (halvings < kMaxHalvings && !is_straight(axis_path, from, to)) {
        const double middle = (from + to) / 2;
        lines(axis_path, from, middle, feed, total_s, halvings + 1);
        lines(axis_path, middle, to, feed, total_s, halvings + 1);
        return;
    }
    Point point = point_at(axis_path(to), MotionType::linear);
    if (!tool_position_.has_xyz()) {
        set_feed(point, feed, false);
    } else if (feed.motion_s) {
        point.duration_s = rate(total_s * (to - from));
    } else {
        const double minutes = total_s * (to - from) / kSecondsPerMinute;
        const double distance_mm =
            (tool_position_.tcp(axis_path(to)) - tool_position_.tcp(axis_path(from))).norm();
        const double turn_deg = (axis_path(to) - axis_path(from)).norm();
        const bool is_stationary = distance_mm < kDegPerMm * turn_deg;
        set_feed(point, {distance_mm / minutes, turn_deg / minutes, std::nullopt}, is_stationary);
    }
    builder_.add(std::move(point));
}

void PathRecorder::dwell(const AxisVector& at, double seconds) {
    if (is_full()) return;
    if (!(seconds > 0)) return standstill(at);
    begin(at);
    const Point* last = builder_.last_point();
    if (last == nullptr || last->dwell_s > 0 || !last->actions.empty()) add_action_point(at);
    builder_.last_point()->dwell_s = seconds;
    standstill_pending_ = false;
    moved_since_standstill_ = true;
}

// Records that the next motion begins at standstill, which no dwell or switch says.
void PathRecorder::record_standstill(const AxisVector& at) {
    if (std::exchange(standstill_pending_, false)) add_action(at, "rest");
}

void PathRecorder::add_action(const AxisVector& at, std::string action) {
    if (is_full()) return;
    record_standstill(at);
    begin(at);
    if (builder_.last_point() == nullptr) add_action_point(at);
    builder_.last_point()->actions.push_back(std::move(action));
}

void PathRecorder::event(const AxisVector& at, const simulation::Event& event, bool at_standstill) {
    std::optional<std::string> name = action_name(event);
    if (!name) {
        if (at_standstill) standstill(at);
        return;
    }
    if (at_standstill) moved_since_standstill_ = standstill_pending_ = false;
    add_action(at, *std::move(name));
}

void PathRecorder::enter_program(const std::string& name) {
    active_settings_ = {};
    builder_.begin_call(name);
}

void PathRecorder::leave_program() {
    builder_.end_call();
}

void PathRecorder::on_unrecordable_motion(std::string_view reason) {
    if (error_.empty()) error_ = reason;
}

Result<path::Program> PathRecorder::finish(const std::string& name) {
    if (builder_.has_targets()) record_standstill(standstill_position_);
    if (error_.empty() && !builder_.has_targets()) error_ = "the program neither moves nor switches anything";
    if (!error_.empty()) return tl::unexpected(error_);
    path::Program program = builder_.finish(name);
    program.work_offsets = std::move(work_offsets_);
    if (const auto error = path::validate(program)) return tl::unexpected(error->message);
    return program;
}

}  // namespace gsim::record
