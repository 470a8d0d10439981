// Conversion of a move into segments: its request in joint space, then a separate motion or one of the model.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/exact_stop/apart_move.h"
#include "motion/exact_stop/arc_move.h"
#include "motion/exact_stop/joint_move.h"
#include "motion/exact_stop/line_move.h"
#include "motion/kinematics/pose.h"
#include "motion/lookahead/block.h"
#include "motion/path/circle.h"
#include "motion/path/lead_path.h"
#include "motion/path/limited_way.h"
#include "motion/path/orientation_path.h"
#include "motion/planner/planner.h"
#include "motion/planner/range_check.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

using rrs::MotionType;
using rrs::Status;

namespace {

constexpr double kLargestValue = 1e12;  // mm or rad; what is computed from it stays far from overflow
constexpr double kSameTime = 1e-9;      // relative
constexpr double kLeastTime_s = 1e-6;

/// A model takes moves before it can report their times. This is the minimum time of the move by the
/// machine's speeds. It is 0 if the program requests no time, or if the controller uses the time of an arc
/// differently.
double least_s(const PathMove& move, const PlannerSetup& setup) {
    const bool of_chords = move.kind == SegmentKind::circular && setup.controller.inverse_time_of_chords;
    if (move.rules.least_duration_s <= 0 || of_chords) return 0;
    const auto block = block_of(move, setup);
    if (!block || !*block) return 0;
    return (*block)->lead.length / (*block)->max_speed * (1 - kSameTime);
}

std::optional<TimeRaised> raised(double takes_s, double asked_s, bool at_least) {
    if (asked_s <= 0 || takes_s <= asked_s) return std::nullopt;
    return TimeRaised{takes_s, asked_s, at_least};
}

}  // namespace

PlanError time_raised(const TimeRaised& raised) {
    return {.status = Status::RRS_MOTION_TIME_RAISED,
            .message = fmt::format("The move takes {}{} s, not {} s: the machine can do it no faster.",
                                   raised.at_least ? "at least " : "", raised.takes_s, raised.asked_s)};
}

Planned check_positive(double value, std::string_view what) {
    if (value > 0) return {};
    return refused(Status::RRS_INVALID_PARAMETER,
                   fmt::format("The {} must be greater than 0; {} was asked for.", what, value));
}

Planned check_motion_time(double motion_s) {
    if (motion_s >= kLeastTime_s && motion_s <= kLongest_s) return {};
    return refused(Status::RRS_INVALID_PARAMETER,
                   fmt::format("A motion time is from {} to {} s; {} was asked for.", kLeastTime_s,
                               kLongest_s, motion_s));
}

Planned Planner::check_ramps() const {
    const rrs::PlannerKind planner = machine_.controller.planner;
    if (planner != rrs::PlannerKind::linuxcnc && planner != rrs::PlannerKind::klipper) return {};
    return refused(Status::RRS_MODE_NOT_SUPPORTED,
                   "This controller has ramps of its own, which a program cannot change.");
}

Planned Planner::stand_at(const Goal& goal) {
    rrs::JointPos position;
    if (Planned solved = solve(goal, position); !solved) return solved;
    flush();
    if (model_) model_->clear();
    own_.reset();
    position_ = position;
    has_position_ = true;
    return {};
}

Put Planner::put(const Move& move) {
    if (Planned ready = ready_for_move(); !ready) return tl::unexpected(std::move(ready.error()));
    if (Planned room = make_room(move.rest_s > 0 ? 2 : 1); !room)
        return tl::unexpected(std::move(room.error()));
    if (move.terms.motion_time_s != 0) {
        if (Planned checked = check_motion_time(move.terms.motion_time_s); !checked)
            return tl::unexpected(std::move(checked.error()));
    }
    if (Planned checked = check_own(move); !checked) return tl::unexpected(std::move(checked.error()));
    use(move.terms);
    Put put = moves_tool(move)                 ? put_tool_move(move)
              : move.type == MotionType::joint ? put_joint_move(move)
              : holds_back()                   ? put_held_move(move)
                                               : put_path_move(move);
    if (put && move.rest_s > 0) append_rest(move.target_id, dwell_s(move.rest_s));
    return put;
}

Planned Planner::put_rest(rrs::TargetId id, double rest_s) {
    if (Planned ready = ready_for_move(); !ready) return ready;
    if (Planned room = make_room(1); !room) return room;
    if (!(rest_s >= 0 && rest_s <= kLongest_s)) {
        return refused(Status::RRS_INVALID_PARAMETER,
                       fmt::format("A rest takes from 0 to {} s; {} was asked for.", kLongest_s, rest_s));
    }
    come_to_rest(true);
    append_rest(id, dwell_s(rest_s));
    return {};
}

/// Returns the active setup; for a move with its own accelerations, the one in limited_.
tl::expected<const PlannerSetup*, PlanError> Planner::setup_on(const PathMove& path) {
    if (!setup_.move_limits) return &setup_for_motion();
    auto limited = setup_on_way(path, setup_, overrides_now());
    if (!limited) return tl::unexpected(std::move(limited.error()));
    limited_ = *std::move(limited);
    return &limited_;
}

/// Returns a dwell as the controller counts it.
double Planner::dwell_s(double programmed_s) const {
    const double step_s = setup_.controller.dwell_step_s;
    if (step_s <= 0) return programmed_s;
    return step_s * std::ceil(programmed_s / step_s * (1 - 1e-12));
}

Planned Planner::ready_for_move() const {
    if (!has_position_) {
        return refused(Status::RRS_NO_INITIAL_POSITION,
                       "The robot has no position yet; call SetInitialPosition before the first target.");
    }
    if (stopped_) {
        return refused(Status::RRS_QUEUE_FULL,
                       "The motion is stopped; ContinueMotion or CancelMotion comes before another target.");
    }
    return {};
}

Planned Planner::make_room(std::size_t segments) {
    while (queue_.room() < segments && !keeps_all_) {
        if (sink_ == nullptr) {
            return refused(Status::RRS_QUEUE_FULL,
                           fmt::format("{} targets are waiting; call GetNextStep before more are put.",
                                       setup_.queue_capacity));
        }
        emit_front();
    }
    return {};
}

Planned Planner::solve(const Goal& goal, rrs::JointPos& joints) const {
    Planned solved = goal.pose ? solve_pose(*goal.pose, joints) : check_joints(goal.joints);
    if (!goal.pose) joints = goal.joints;
    if (!solved || tracked_) return solved;  // in the frame of a conveyor: ranges are checked along the path
    return check_target_ranges(setup_, joints);
}

Planned Planner::check_joints(const rrs::JointPos& joints) const {
    if (joints.size() != setup_.joint_count()) {
        return refused(Status::RRS_INVALID_PARAMETER,
                       fmt::format("The target has {} joint values; the machine has {} joints.",
                                   joints.size(), setup_.joint_count()));
    }
    if (!(joints.array().abs() <= kLargestValue).all()) {
        return refused(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The target holds a joint value that is not a number within +-{}.", kLargestValue));
    }
    return {};
}

Planned Planner::solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const {
    if (auto checked = kinematics::check_pose(goal.pose); !checked)
        return refused(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    rrs::JointPos near = position_;
    for (const LedJoint& one : goal.led) near[one.joint] = one.value;
    auto solution = setup_.kinematics->inverse(goal.tool_centre(), near);
    if (!solution) return refused(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return check_joints(joints);
}

Segment& Planner::begin_segment(Segment& slot, rrs::TargetId id) {
    slot.target_id = id;
    slot.start_s = end_s_;
    slot.start = position_;
    slot.position_joints = setup_.position_joints;
    slot.clear_followers();
    slot.reaches_target = true;
    slot.lead_limits = {};
    slot.limited_by = {};
    slot.beside.reset();
    slot.orientation.reset();
    slot.deviation_mm = 0;
    slot.apart = 0;
    slot.off_way = OffWay::no;
    return slot;
}

/// Joint motion does not use the model, and none runs along a conveyor.
void Planner::leave_model() {
    if (!model_) return;
    end_model();
    position_ = standing();
    model_->clear();
}

Put Planner::put_joint_move(const Move& move) {
    leave_model();
    rrs::JointPos target;
    if (Planned solved = solve(move.goal, target); !solved) return tl::unexpected(std::move(solved.error()));
    wait_out_hold(move.target_id, position_, move.terms.obeyed, false);
    Segment& segment = begin_segment(queue_.next(), move.target_id);
    segment.end = target;
    const double share = share_now(move.terms.obeyed, false);
    PathMove way;
    way.start = position_;
    way.end = target;
    way.rapid = true;
    const auto setup = setup_on(way);
    if (!setup) return tl::unexpected(setup.error());
    Planned planned = plan_joint_move(**setup, move.terms, share, segment);
    if (planned) planned = carry(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_ = target;
    append(segment);
    return raised(segment.duration_s * share, move.terms.motion_time_s, false);
}

/// True if the joints of a move are coordinated with each other.
bool Planner::interpolates(const Move& move) const {
    return setup_.controller.interpolated_rapids || !move.terms.rapid;
}

/// Enqueues a move from standstill to standstill.
Put Planner::put_path_move(const Move& move) {
    leave_model();
    if (tracked_ && !interpolates(move)) {
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "Rapids that are not interpolated cannot follow a conveyor.");
    }
    if (Planned shaped = shape_path(move); !shaped) return tl::unexpected(std::move(shaped.error()));
    const PathMove& path = path_;
    wait_out_hold(path.target_id, position_, path.obeyed, path.rapid);
    Segment& segment = begin_segment(queue_.next(), path.target_id);
    set_way(path, segment);
    const double share = share_now(path.obeyed, path.rapid);
    const MoveRules rules = path.rules.overridden(overrides_now(), path.obeyed, path.rapid);
    const auto limited = setup_on(path);
    if (!limited) return tl::unexpected(limited.error());
    const PlannerSetup& setup = **limited;
    const bool apart = !interpolates(move);
    Planned planned = path.kind == SegmentKind::circular ? plan_arc(setup, rules, segment)
                      : apart                            ? plan_apart(setup, rules, segment)
                                                         : plan_line(setup, rules, segment);
    if (planned) planned = carry(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_ = path.end;
    const double takes_s = segment.duration_s * share;
    append_overridden(path, segment);
    return raised(takes_s, move.terms.motion_time_s, false);
}

Put Planner::put_held_move(const Move& move) {
    if (Planned shaped = shape_path(move); !shaped) return tl::unexpected(std::move(shaped.error()));
    const bool held = held_.put(path_.target_id);  // before the model outputs its motion
    if (ways_ != nullptr) ways_->programmed(path_);
    if (Planned planned = model_->add(path_); !planned) {
        if (held) held_.take_back();
        if (ways_ != nullptr) ways_->take_back();
        return tl::unexpected(std::move(planned.error()));
    }
    position_ = path_.end;
    if (move.terms.motion_time_s <= 0) return {};
    return raised(least_s(path_, setup_), move.terms.motion_time_s, true);
}

/// Sets the terms that count on a path that begins at the robot's position.
void Planner::set_terms(const Move& move, PathMove& path) const {
    const MoveTerms& terms = move.terms;
    path.target_id = move.target_id;
    path.start = position_;
    path.rules = terms.rules(setup_.path);
    path.obeyed = terms.obeyed;
    path.rapid = terms.rapid;
    const bool stops = terms.path_mode == rrs::PathMode::exact_path && setup_.controller.exact_path_stops;
    path.mode = stops ? rrs::PathMode::exact_stop : terms.path_mode;
    path.tolerance_mm = terms.tolerance_mm;
    path.merge_tolerance_mm = terms.merge_tolerance_mm;
}

/// Converts the move into a joint path, in path_.
Planned Planner::shape_path(const Move& move) {
    set_terms(move, path_);
    path_.kind = SegmentKind::linear;
    path_.orientation.reset();
    if (Planned solved = solve(move.goal, path_.end); !solved) return solved;
    if (move.type == MotionType::circular) {
        if (Planned shaped = shape_circle(move, path_); !shaped) return shaped;
    }
    if (setup_.controller.orientation != rrs::OrientationRule::joints && !path_.rapid) {
        auto way = orientation_between(setup_, path_.start, path_.end);
        if (!way) return tl::unexpected(std::move(way.error()));
        path_.orientation = *std::move(way);
    }
    if (path_.kind != SegmentKind::circular) return {};
    Planned checked = check_arc(setup_, path_.arc);
    return checked && !tracked_ ? check_arc_ranges(setup_, path_.arc) : checked;
}

Planned Planner::shape_circle(const Move& move, PathMove& path) const {
    path.kind = SegmentKind::circular;
    if (Planned allowed = circular_allowed(move.terms.rapid); !allowed) return allowed;
    const Eigen::Vector3d start = position_of(setup_, path.start);
    const Eigen::Vector3d end = position_of(setup_, path.end);
    if (!move.circle) {
        if (!move.via) return no_via_point();
        rrs::JointPos via;
        if (Planned solved = solve(*move.via, via); !solved) return solved;
        return arc_through(start, position_of(setup_, via), end, path.arc);
    }
    const Circle& circle = *move.circle;
    if (!move.goal.pose) {
        return arc_about(start, end, circle.center_mm, circle.axis, circle.sweep_rad, setup_.arc_tolerance_mm,
                         path.arc);
    }
    if (!axis_space_) {
        return refused(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "This machine takes the centre of an arc only with joint targets: its position joints do not "
            "span the space of the work frame.");
    }
    // The tool does not turn here, so its centre point follows the same circle next to that of the tool
    // frame.
    const rrs::CartPos tool = setup_.kinematics->forward(position_);
    const Eigen::Vector3d center = circle.center_mm - tool.linear() * move.goal.pose->tool.translation();
    return arc_about(start, end, axis_space_->point(center), axis_space_->turn_axis(circle.axis),
                     circle.sweep_rad, setup_.arc_tolerance_mm, path.arc);
}

tl::unexpected<PlanError> Planner::no_via_point() {
    return refused(Status::RRS_INVALID_PARAMETER,
                   "Circular motion needs a via point before its target, which tells the circle.");
}

Planned Planner::circular_allowed(bool rapid) const {
    if (!setup_.has_position_joints()) {
        return refused(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Circular motion needs joints that carry the position of the tool; this machine has none.");
    }
    if (rapid) {
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "There is no rapid circular motion; switch SetRapid off.");
    }
    return {};
}

void Planner::append(const Segment& segment) {
    if (own_) own_->carry(queue_.next());
    end_s_ = segment.end_s();
    queue_.push();
}

/// A dwell waits for the program's next block, so motion that was queued before it ends at standstill.
void Planner::append_rest(rrs::TargetId id, double rest_s) {
    end_model();
    Segment& segment = output_.begin(id);
    segment.kind = SegmentKind::rest;
    segment.start = segment.end = standing();
    plan_stay(segment, rest_s);
    if (tracked_) tracked_->frame.carry(segment);
    output_.finish();
}

}  // namespace gsim::motion
