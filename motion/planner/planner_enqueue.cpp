// Conversion of a move into segments: its request in joint space, then a separate motion or one of the model.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/exact_stop/arc_move.h"
#include "motion/exact_stop/joint_move.h"
#include "motion/exact_stop/line_move.h"
#include "motion/exact_stop/uncoordinated_move.h"
#include "motion/kinematics/pose.h"
#include "motion/lookahead/block.h"
#include "motion/path/circle.h"
#include "motion/path/limited_path.h"
#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"
#include "motion/planner/planner.h"
#include "motion/planner/range_check.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

using rrs::MotionType;
using rrs::Status;

namespace {

constexpr double kMaxValue = 1e12;           // mm or rad; what is computed from it stays far from overflow
constexpr double kRelativeTolerance = 1e-9;  // relative
constexpr double kMinTime_s = 1e-6;

/// A model takes moves before it can report their times. This is the minimum time of the move by the
/// machine's speeds. It is 0 if the program requests no time, or if the controller uses the time of an arc
/// differently.
double min_time_s(const PathMove& move, const PlannerSetup& setup) {
    const bool is_per_chord = move.kind == SegmentKind::circular && setup.controller.inverse_time_per_chord;
    if (move.rules.min_duration_s <= 0 || is_per_chord) return 0;
    const auto block = make_block(move, setup);
    if (!block || !*block) return 0;
    return (*block)->master.length / (*block)->max_speed * (1 - kRelativeTolerance);
}

std::optional<TimeRaised> raised_time(double actual_s, double requested_s, bool at_least) {
    if (requested_s <= 0 || actual_s <= requested_s) return std::nullopt;
    return TimeRaised{actual_s, requested_s, at_least};
}

}  // namespace

PlanError time_raised(const TimeRaised& raised_time) {
    return {.status = Status::RRS_MOTION_TIME_RAISED,
            .message = fmt::format("The move takes {}{} s, not {} s: the machine can do it no faster.",
                                   raised_time.at_least ? "at least " : "", raised_time.actual_s,
                                   raised_time.requested_s)};
}

PlanResult check_positive(double value, std::string_view what) {
    if (value > 0) return {};
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           fmt::format("The {} must be greater than 0; {} was asked for.", what, value));
}

PlanResult check_motion_time(double motion_s) {
    if (motion_s >= kMinTime_s && motion_s <= kMaxDuration_s) return {};
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           fmt::format("A motion time is from {} to {} s; {} was asked for.", kMinTime_s,
                                       kMaxDuration_s, motion_s));
}

PlanResult Planner::check_ramps() const {
    const rrs::PlannerKind planner = machine_.controller.planner;
    if (planner != rrs::PlannerKind::linuxcnc && planner != rrs::PlannerKind::klipper) return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "This controller has ramps of its own, which a program cannot change.");
}

PlanResult Planner::set_position(const Goal& goal) {
    rrs::JointPos position;
    if (PlanResult solved = solve(goal, position); !solved) return solved;
    flush();
    if (model_) model_->clear();
    independent_motion_.reset();
    position_ = position;
    has_position_ = true;
    return {};
}

EnqueueResult Planner::enqueue(const Move& move) {
    if (PlanResult ready = check_ready_for_move(); !ready) return tl::unexpected(std::move(ready.error()));
    if (PlanResult free_slots = reserve_segments(move.dwell_s > 0 ? 2 : 1); !free_slots)
        return tl::unexpected(std::move(free_slots.error()));
    if (move.move_parameters.motion_time_s != 0) {
        if (PlanResult checked = check_motion_time(move.move_parameters.motion_time_s); !checked)
            return tl::unexpected(std::move(checked.error()));
    }
    if (PlanResult checked = check_independent(move); !checked)
        return tl::unexpected(std::move(checked.error()));
    use(move.move_parameters);
    EnqueueResult enqueue = moves_tool(move)                 ? enqueue_tool_move(move)
                            : move.type == MotionType::joint ? enqueue_joint_move(move)
                            : buffers_moves()                ? enqueue_pending_move(move)
                                                             : enqueue_path_move(move);
    if (enqueue && move.dwell_s > 0) append_dwell(move.target_id, counted_dwell_s(move.dwell_s));
    return enqueue;
}

PlanResult Planner::enqueue_dwell(rrs::TargetId id, double dwell_s) {
    if (PlanResult ready = check_ready_for_move(); !ready) return ready;
    if (PlanResult free_slots = reserve_segments(1); !free_slots) return free_slots;
    if (!(dwell_s >= 0 && dwell_s <= kMaxDuration_s)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("A rest takes from 0 to {} s; {} was asked for.", kMaxDuration_s, dwell_s));
    }
    plan_to_standstill(true);
    append_dwell(id, counted_dwell_s(dwell_s));
    return {};
}

/// Returns the active setup; for a move with its own accelerations, the one in limited_setup_.
tl::expected<const PlannerSetup*, PlanError> Planner::setup_for_move(const PathMove& path) {
    if (!setup_.move_limits) return &setup_for_motion();
    auto limited = setup_for_path(path, setup_, current_overrides());
    if (!limited) return tl::unexpected(std::move(limited.error()));
    limited_setup_ = *std::move(limited);
    return &limited_setup_;
}

/// Returns a dwell as the controller counts it.
double Planner::counted_dwell_s(double programmed_s) const {
    const double step_s = setup_.controller.dwell_step_s;
    if (step_s <= 0) return programmed_s;
    return step_s * std::ceil(programmed_s / step_s * (1 - 1e-12));
}

PlanResult Planner::check_ready_for_move() const {
    if (!has_position_) {
        return make_plan_error(
            Status::RRS_NO_INITIAL_POSITION,
            "The robot has no position yet; call SetInitialPosition before the first target.");
    }
    if (stopped_) {
        return make_plan_error(
            Status::RRS_QUEUE_FULL,
            "The motion is stopped; ContinueMotion or CancelMotion comes before another target.");
    }
    return {};
}

PlanResult Planner::reserve_segments(std::size_t segments) {
    while (queue_.free_slots() < segments && !keeps_all_segments_) {
        if (sink_ == nullptr) {
            return make_plan_error(
                Status::RRS_QUEUE_FULL,
                fmt::format("{} targets are waiting; call GetNextStep before more are put.",
                            setup_.queue_capacity));
        }
        emit_front();
    }
    return {};
}

PlanResult Planner::solve(const Goal& goal, rrs::JointPos& joints) const {
    PlanResult solved = goal.pose ? solve_pose(*goal.pose, joints) : check_joints(goal.joints);
    if (!goal.pose) joints = goal.joints;
    if (!solved || tracking_) return solved;  // in the frame of a conveyor: ranges are checked along the path
    return check_target_ranges(setup_, joints);
}

PlanResult Planner::check_joints(const rrs::JointPos& joints) const {
    if (joints.size() != setup_.joint_count()) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The target has {} joint values; the machine has {} joints.",
                                           joints.size(), setup_.joint_count()));
    }
    if (!(joints.array().abs() <= kMaxValue).all()) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The target holds a joint value that is not a number within +-{}.", kMaxValue));
    }
    return {};
}

PlanResult Planner::solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const {
    if (auto checked = kinematics::check_pose(goal.pose); !checked)
        return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    rrs::JointPos near = position_;
    for (const GroupJoint& one : goal.group_joints) near[one.joint] = one.value;
    auto solution = setup_.kinematics->inverse(goal.tcp_pose(), near);
    if (!solution) return make_plan_error(Status::RRS_NO_SOLUTION, std::move(solution.error()));
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
    slot.master_limits = {};
    slot.limited_by = {};
    slot.superimposed.reset();
    slot.orientation.reset();
    slot.deviation_mm = 0;
    slot.uncoordinated = 0;
    slot.path_deviation = PathDeviation::no;
    return slot;
}

/// Joint motion does not use the model, and none runs along a conveyor.
void Planner::leave_model() {
    if (!model_) return;
    end_model();
    position_ = standstill_position();
    model_->clear();
}

EnqueueResult Planner::enqueue_joint_move(const Move& move) {
    leave_model();
    rrs::JointPos target;
    if (PlanResult solved = solve(move.goal, target); !solved)
        return tl::unexpected(std::move(solved.error()));
    wait_out_hold(move.target_id, position_, move.move_parameters.enabled_overrides, false);
    Segment& segment = begin_segment(queue_.next(), move.target_id);
    segment.end = target;
    const double share = current_override_share(move.move_parameters.enabled_overrides, false);
    PathMove joint_path;
    joint_path.start = position_;
    joint_path.end = target;
    joint_path.rapid = true;
    const auto setup = setup_for_move(joint_path);
    if (!setup) return tl::unexpected(setup.error());
    PlanResult planned = plan_joint_move(**setup, move.move_parameters, share, segment);
    if (planned) planned = superimpose(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_ = target;
    append(segment);
    return raised_time(segment.duration_s * share, move.move_parameters.motion_time_s, false);
}

/// True if the joints of a move are coordinated with each other.
bool Planner::is_interpolated(const Move& move) const {
    return setup_.controller.interpolated_rapids || !move.move_parameters.rapid;
}

/// Enqueues a move from standstill to standstill.
EnqueueResult Planner::enqueue_path_move(const Move& move) {
    leave_model();
    if (tracking_ && !is_interpolated(move)) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Rapids that are not interpolated cannot follow a conveyor.");
    }
    if (PlanResult build_result = build_path(move); !build_result)
        return tl::unexpected(std::move(build_result.error()));
    const PathMove& path = path_;
    wait_out_hold(path.target_id, position_, path.enabled_overrides, path.rapid);
    Segment& segment = begin_segment(queue_.next(), path.target_id);
    set_path(path, segment);
    const double share = current_override_share(path.enabled_overrides, path.rapid);
    const MoveRules rules =
        path.rules.with_overrides(current_overrides(), path.enabled_overrides, path.rapid);
    const auto limited = setup_for_move(path);
    if (!limited) return tl::unexpected(limited.error());
    const PlannerSetup& setup = **limited;
    const bool uncoordinated = !is_interpolated(move);
    PlanResult planned = path.kind == SegmentKind::circular ? plan_arc(setup, rules, segment)
                         : uncoordinated                    ? plan_uncoordinated_move(setup, rules, segment)
                                                            : plan_line(setup, rules, segment);
    if (planned) planned = superimpose(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_ = path.end;
    const double actual_s = segment.duration_s * share;
    append_overridden(path, segment);
    return raised_time(actual_s, move.move_parameters.motion_time_s, false);
}

EnqueueResult Planner::enqueue_pending_move(const Move& move) {
    if (PlanResult build_result = build_path(move); !build_result)
        return tl::unexpected(std::move(build_result.error()));
    const bool is_pending = pending_.enqueue(path_.target_id);  // before the model outputs its motion
    if (path_sink_ != nullptr) path_sink_->on_programmed_move(path_);
    if (PlanResult planned = model_->add(path_); !planned) {
        if (is_pending) pending_.retract_last();
        if (path_sink_ != nullptr) path_sink_->retract_last();
        return tl::unexpected(std::move(planned.error()));
    }
    position_ = path_.end;
    if (move.move_parameters.motion_time_s <= 0) return {};
    return raised_time(min_time_s(path_, setup_), move.move_parameters.motion_time_s, true);
}

/// Sets the terms that count on a path that begins at the robot's position.
void Planner::set_parameters(const Move& move, PathMove& path) const {
    const MoveParameters& move_parameters = move.move_parameters;
    path.target_id = move.target_id;
    path.start = position_;
    path.rules = move_parameters.rules(setup_.path);
    path.enabled_overrides = move_parameters.enabled_overrides;
    path.rapid = move_parameters.rapid;
    const bool stops =
        move_parameters.path_mode == rrs::PathMode::exact_path && setup_.controller.exact_path_stops;
    path.mode = stops ? rrs::PathMode::exact_stop : move_parameters.path_mode;
    path.tolerance_mm = move_parameters.tolerance_mm;
    path.merge_tolerance_mm = move_parameters.merge_tolerance_mm;
}

/// Converts the move into a joint path, in path_.
PlanResult Planner::build_path(const Move& move) {
    set_parameters(move, path_);
    path_.kind = SegmentKind::linear;
    path_.orientation.reset();
    if (PlanResult solved = solve(move.goal, path_.end); !solved) return solved;
    if (move.type == MotionType::circular) {
        if (PlanResult build_result = build_circle(move, path_); !build_result) return build_result;
    }
    if (setup_.controller.orientation != rrs::OrientationRule::joints && !path_.rapid) {
        auto joint_path = orientation_between(setup_, path_.start, path_.end);
        if (!joint_path) return tl::unexpected(std::move(joint_path.error()));
        path_.orientation = *std::move(joint_path);
    }
    if (path_.kind != SegmentKind::circular) return {};
    PlanResult checked = check_arc(setup_, path_.arc);
    return checked && !tracking_ ? check_arc_ranges(setup_, path_.arc) : checked;
}

PlanResult Planner::build_circle(const Move& move, PathMove& path) const {
    path.kind = SegmentKind::circular;
    if (PlanResult allowed = check_circular(move.move_parameters.rapid); !allowed) return allowed;
    const Eigen::Vector3d start = read_position(setup_, path.start);
    const Eigen::Vector3d end = read_position(setup_, path.end);
    if (!move.circle) {
        if (!move.via) return no_via_point_error();
        rrs::JointPos via;
        if (PlanResult solved = solve(*move.via, via); !solved) return solved;
        return arc_through(start, read_position(setup_, via), end, path.arc);
    }
    const Circle& circle = *move.circle;
    if (!move.goal.pose) {
        return arc_about(start, end, circle.center_mm, circle.axis, circle.sweep_rad, setup_.arc_tolerance_mm,
                         path.arc);
    }
    if (!axis_space_) {
        return make_plan_error(
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

tl::unexpected<PlanError> Planner::no_via_point_error() {
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           "Circular motion needs a via point before its target, which tells the circle.");
}

PlanResult Planner::check_circular(bool rapid) const {
    if (!setup_.has_position_joints()) {
        return make_plan_error(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Circular motion needs joints that carry the position of the tool; this machine has none.");
    }
    if (rapid) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "There is no rapid circular motion; switch SetRapid off.");
    }
    return {};
}

void Planner::append(const Segment& segment) {
    if (independent_motion_) independent_motion_->superimpose(queue_.next());
    end_s_ = segment.end_s();
    queue_.push();
}

/// A dwell waits for the program's next block, so motion that was queued before it ends at standstill.
void Planner::append_dwell(rrs::TargetId id, double dwell_s) {
    end_model();
    Segment& segment = output_.begin(id);
    segment.kind = SegmentKind::rest;
    segment.start = segment.end = standstill_position();
    plan_standstill(segment, dwell_s);
    if (tracking_) tracking_->frame.superimpose(segment);
    output_.finish();
}

}  // namespace gsim::motion
