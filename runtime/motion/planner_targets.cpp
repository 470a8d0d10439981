// The services of DefaultPlanner that put targets.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/kinematics/pose.h"
#include "runtime/motion/arc_move.h"
#include "runtime/motion/block.h"
#include "runtime/motion/circle.h"
#include "runtime/motion/joint_move.h"
#include "runtime/motion/lead_path.h"
#include "runtime/motion/line_move.h"
#include "runtime/motion/orientation_path.h"
#include "runtime/motion/planner.h"
#include "runtime/motion/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kLargestValue = 1e12;  // mm or rad; what is computed from it stays far from overflow
constexpr double kSameTime = 1e-9;      // relative

/// A model takes moves before it can tell their times. By the machine's speeds this one takes so long at
/// least; 0 where the program asks for no time, or the controller takes that of an arc for another thing.
double least_s(const Move& move, const PlannerSetup& setup) {
    const bool of_chords = move.kind == SegmentKind::circular && setup.controller.inverse_time_of_chords;
    if (move.rules.least_duration_s <= 0 || of_chords) return 0;
    const auto block = block_of(move, setup);
    if (!block || !*block) return 0;
    return (*block)->lead.length / (*block)->max_speed * (1 - kSameTime);
}

}  // namespace

Status DefaultPlanner::SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                          std::string_view) {
    if (!initialized_) return not_initialized();
    if (tracked_)
        return refuse(Status::RRS_INVALID_PARAMETER,
                      "The position cannot be set while a conveyor is tracked.");
    rrs::JointPos position;
    if (Planned solved = solve_target(cartesian, joints, position); !solved)
        return tell(std::move(solved.error()));
    flush();
    if (model_) model_->clear();
    position_ = position;
    has_position_ = true;
    via_.reset();
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                     const rrs::JointPos& joints, std::string_view, double param_value) {
    if (Planned ready = ready_for_target(); !ready) return tell(std::move(ready.error()));
    if (!std::isfinite(param_value))
        return refuse(Status::RRS_INVALID_PARAMETER, "The target's parameter is not finite.");
    if (param == rrs::TargetParam::via) return keep_via(cartesian, joints);
    if (param != rrs::TargetParam::end) {
        return refuse(Status::RRS_INVALID_PARAMETER, "A target is the end of a motion or a via point.");
    }
    const bool along_path = programmed_.motion_type != rrs::MotionType::joint;
    if (moves_tool(along_path)) return put_tool_move(id, cartesian, joints, std::nullopt);
    Segment& segment = begin_target(id, along_path);
    Planned planned = solve_target(cartesian, joints, segment.end);
    if (planned) planned = plan_selected(segment);
    return finish_target(segment, std::move(planned));
}

Status DefaultPlanner::SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param,
                                          const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                          std::string_view configuration, double param_value,
                                          std::string_view target_name) {
    const Status status = SetNextTarget(id, param, cartesian, joints, configuration, param_value);
    if (status != Status::RRS_SUCCESS)
        error_.message = fmt::format("Target {}: {}", target_name, error_.message);
    return status;
}

Status DefaultPlanner::SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                        const Eigen::Vector3d& axis, double sweep_rad,
                                        const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (Planned ready = ready_for_target(); !ready) return tell(std::move(ready.error()));
    if (moves_tool(true)) return put_tool_move(id, cartesian, joints, Circle{center_mm, axis, sweep_rad});
    Segment& segment = begin_target(id, true);
    Planned planned = solve_target(cartesian, joints, segment.end);
    if (planned) planned = plan_center_arc(center_mm, axis, sweep_rad, segment);
    return finish_target(segment, std::move(planned));
}

Status DefaultPlanner::SetNextRest(rrs::TargetId id, double rest_s) {
    if (Planned ready = ready_for_target(); !ready) return tell(std::move(ready.error()));
    if (!(rest_s >= 0 && rest_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("A rest takes from 0 to {} s; {} was asked for.", kLongest_s, rest_s));
    }
    come_to_rest(true);
    append_rest(id, dwell_s(rest_s));
    return Status::RRS_SUCCESS;
}

/// A dwell as the controller counts it.
double DefaultPlanner::dwell_s(double programmed_s) const {
    const double step_s = setup_.controller.dwell_step_s;
    if (step_s <= 0) return programmed_s;
    return step_s * std::ceil(programmed_s / step_s * (1 - 1e-12));
}

Planned DefaultPlanner::ready_for_target() {
    if (!initialized_) {
        return refused(Status::RRS_NOT_INITIALIZED, "The planner is not initialized; call Initialize first.");
    }
    if (!has_position_) {
        return refused(Status::RRS_NO_INITIAL_POSITION,
                       "The robot has no position yet; call SetInitialPosition before the first target.");
    }
    if (stopped_) {
        return refused(Status::RRS_QUEUE_FULL,
                       "The motion is stopped; ContinueMotion or CancelMotion comes before another target.");
    }
    return make_room(programmed_.rest_s > 0 ? 2 : 1);
}

Planned DefaultPlanner::make_room(std::size_t segments) {
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

Planned DefaultPlanner::solve_target(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                     rrs::JointPos& target) const {
    Planned solved = programmed_.target_type == rrs::TargetType::joint ? solve_joints(joints, target)
                                                                       : solve_pose(cartesian, target);
    if (!solved || tracked_) return solved;  // in the frame of a conveyor: ranges are looked at along the way
    return check_target_ranges(setup_, target);
}

Planned DefaultPlanner::solve_joints(const rrs::JointPos& joints, rrs::JointPos& target) const {
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
    target = joints;
    return {};
}

Planned DefaultPlanner::solve_pose(const rrs::CartPos& pose, rrs::JointPos& target) const {
    if (auto checked = kinematics::check_pose(pose); !checked) {
        return refused(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    }
    auto joints = setup_.kinematics->inverse(work_frames_.tool_centre_of(pose), position_);
    if (!joints) return refused(Status::RRS_NO_SOLUTION, std::move(joints.error()));
    return solve_joints(*joints, target);
}

Status DefaultPlanner::keep_via(const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (programmed_.motion_type != rrs::MotionType::circular) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      "A via point belongs to circular motion; select that motion type first.");
    }
    rrs::JointPos via;
    if (Planned solved = solve_target(cartesian, joints, via); !solved)
        return tell(std::move(solved.error()));
    via_ = via;
    return Status::RRS_SUCCESS;
}

/// A motion along a path goes to the model, if there is one: it is put together beside the queue, whose slots
/// the model fills. Joint motion is no model's.
Segment& DefaultPlanner::begin_target(rrs::TargetId id, bool along_path) {
    if (model_ && along_path && holds_back()) return begin_segment(draft_, id);
    if (model_) {
        end_model();
        position_ = standing();
        model_->clear();
    }
    wait_out_hold(id, position_);
    return begin_segment(queue_.next(), id);
}

Segment& DefaultPlanner::begin_segment(Segment& slot, rrs::TargetId id) {
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
    slot.off_way = OffWay::no;
    return slot;
}

Status DefaultPlanner::finish_target(Segment& segment, Planned planned) {
    const bool held_back = &segment == &draft_;
    const rrs::JointPos target = segment.end;
    if (planned) planned = held_back ? add_to_model(segment) : carry(segment);
    if (!planned) return tell(std::move(planned.error()));
    position_ = target;
    double takes_s = segment.duration_s * share_now();
    if (!held_back) append_overridden(segment);
    if (held_back && programmed_.motion_time_s > 0) takes_s = least_s(move_of(segment), setup_);
    const double asked_s = std::exchange(programmed_.motion_time_s, 0);
    const double rest_s = std::exchange(programmed_.rest_s, 0);
    via_.reset();
    if (rest_s > 0) append_rest(segment.target_id, dwell_s(rest_s));
    if (asked_s <= 0 || takes_s <= asked_s) return Status::RRS_SUCCESS;
    return refuse(Status::RRS_MOTION_TIME_RAISED,
                  fmt::format("The move takes {}{} s, not {} s: the machine can do it no faster.",
                              held_back ? "at least " : "", takes_s, asked_s));
}

/// A target as a move, as the program has it now.
Move DefaultPlanner::move_of(const Segment& segment) const {
    Move move;
    move.target_id = segment.target_id;
    move.kind = segment.kind;
    move.start = segment.start;
    move.end = segment.end;
    move.arc = segment.arc;
    move.orientation = segment.orientation;
    move.rules = programmed_.rules(setup_.path);
    move.obeyed = programmed_.obeyed;
    move.rapid = programmed_.rapid;
    move.mode = programmed_.path_mode;
    move.tolerance_mm = programmed_.tolerance_mm;
    move.merge_tolerance_mm = programmed_.merge_tolerance_mm;
    return move;
}

Planned DefaultPlanner::add_to_model(const Segment& segment) {
    const Move move = move_of(segment);
    const bool held = held_.put(move.target_id);  // before the model puts its motion out
    if (ways_ != nullptr) ways_->programmed(move);
    Planned planned = model_->add(move);
    if (!planned && held) held_.take_back();
    if (!planned && ways_ != nullptr) ways_->take_back();
    return planned;
}

void DefaultPlanner::append(const Segment& segment) {
    end_s_ = segment.end_s();
    queue_.push();
}

/// A dwell waits for the program's next block: what was queued before it ends at rest.
void DefaultPlanner::append_rest(rrs::TargetId id, double rest_s) {
    end_model();
    Segment& segment = output_.begin(id);
    segment.kind = SegmentKind::rest;
    segment.start = segment.end = standing();
    plan_stay(segment, rest_s);
    if (tracked_) tracked_->frame.carry(segment);
    output_.finish();
}

Planned DefaultPlanner::plan_selected(Segment& segment) {
    switch (programmed_.motion_type) {
        case rrs::MotionType::joint:
            return plan_joint_move(setup_for_motion(), programmed_, share_now(), segment);
        case rrs::MotionType::linear:
            segment.kind = SegmentKind::linear;
            if (Planned turned = plan_orientation(segment); !turned || holds_back()) return turned;
            return plan_line(setup_for_motion(), rules_now(), segment);
        case rrs::MotionType::circular: break;
    }
    return plan_via_arc(segment);
}

Planned DefaultPlanner::plan_orientation(Segment& segment) const {
    if (setup_.controller.orientation == rrs::OrientationRule::joints || programmed_.rapid) return {};
    auto way = orientation_between(setup_, segment.start, segment.end);
    if (!way) return tl::unexpected(std::move(way.error()));
    segment.orientation = *std::move(way);
    return {};
}

Planned DefaultPlanner::plan_via_arc(Segment& segment) {
    if (Planned allowed = circular_allowed(); !allowed) return allowed;
    if (!via_) {
        return refused(Status::RRS_INVALID_PARAMETER,
                       "Circular motion needs a via point before its target, which tells the circle.");
    }
    Planned circle = arc_through(position_of(setup_, segment.start), position_of(setup_, *via_),
                                 position_of(setup_, segment.end), segment.arc);
    return circle ? plan_along_arc(segment) : circle;
}

Planned DefaultPlanner::plan_center_arc(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& axis,
                                        double sweep_rad, Segment& segment) {
    if (Planned allowed = circular_allowed(); !allowed) return allowed;
    const bool mapped = programmed_.target_type == rrs::TargetType::cartesian;
    if (mapped && !axis_space_) {
        return refused(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "This machine takes the centre of an arc only with joint targets: its position joints do not "
            "span the space of the work frame.");
    }
    // The tool does not turn here: its centre point goes the same circle beside that of the tool frame.
    const auto tool_centre = [this](const Eigen::Vector3d& point) -> Eigen::Vector3d {
        const rrs::CartPos tool = setup_.kinematics->forward(position_);
        return work_frames_.object * point - tool.linear() * work_frames_.tip_mm();
    };
    Planned circle = arc_about(position_of(setup_, segment.start), position_of(setup_, segment.end),
                               mapped ? axis_space_->point(tool_centre(center_mm)) : center_mm,
                               mapped ? axis_space_->turn_axis(work_frames_.object.linear() * axis) : axis,
                               sweep_rad, setup_.arc_tolerance_mm, segment.arc);
    return circle ? plan_along_arc(segment) : circle;
}

Planned DefaultPlanner::plan_along_arc(Segment& segment) {
    if (Planned turned = plan_orientation(segment); !turned) return turned;
    Planned planned =
        holds_back() ? shape_arc(setup_, segment) : plan_arc(setup_for_motion(), rules_now(), segment);
    return planned && !tracked_ ? check_arc_ranges(setup_, segment) : planned;
}

Planned DefaultPlanner::circular_allowed() const {
    if (!setup_.has_position_joints()) {
        return refused(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Circular motion needs joints that carry the position of the tool; this machine has none.");
    }
    if (programmed_.rapid) {
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "There is no rapid circular motion; switch SetRapid off.");
    }
    return {};
}

}  // namespace gsim::motion
