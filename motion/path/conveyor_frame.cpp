#include "motion/path/conveyor_frame.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/path/master_path.h"
#include "motion/planner/range_check.h"
#include "motion/profile/ramp.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kSmallestShare = 1e-12;  // of a unit vector: less is rounding

TimeLaw constant_speed(double speed, double duration_s) {
    const std::array sections{LawSection{duration_s, 0, speed, 0, 0}};
    return TimeLaw::from_sections(sections);
}

}  // namespace

tl::expected<ConveyorFrame, PlanError> ConveyorFrame::of(const PlannerSetup& setup, const AxisSpace* space,
                                                         const ConveyorMotion& conveyor) {
    if (space == nullptr) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Only a machine whose position joints move the tool along three perpendicular "
                               "directions can track a conveyor.");
    }
    const Eigen::Vector3d along = space->point(conveyor.direction) - space->point(Eigen::Vector3d::Zero());
    rrs::JointPos joints = rrs::JointPos::Zero(setup.joint_count());
    write_position(setup.position_joints, along, joints);
    joints = (joints.array().abs() < kSmallestShare).select(0, joints);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double speed = std::abs(conveyor.speed_mm_s * joints[joint]);
        const double limit = setup.joints[static_cast<std::size_t>(joint)].max_speed;
        if (speed == 0 || speed < limit) continue;
        return tl::unexpected(PlanError{
            .status = Status::RRS_JOINT_LIMIT,
            .message = fmt::format(
                "The conveyor needs {} mm/s of joint {} (counted from 0), whose max speed is {} mm/s.", speed,
                joint, limit)});
    }
    return ConveyorFrame(conveyor, joints);
}

PlannerSetup ConveyorFrame::remaining_setup(const PlannerSetup& setup) const {
    PlannerSetup within = setup;
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        within.joints[static_cast<std::size_t>(joint)].max_speed -=
            std::abs(conveyor_.speed_mm_s * joints_per_mm_[joint]);
    return within;
}

void ConveyorFrame::superimpose(Segment& segment) const {
    const rrs::JointPos start = shift(segment.start_s);
    segment.start += start;
    segment.end += start;
    if (segment.kind == SegmentKind::circular) {
        for (int axis = 0; axis < 3; ++axis) {
            const int joint = segment.position_joints[static_cast<std::size_t>(axis)];
            if (joint >= 0) segment.arc.center[axis] += start[joint];
        }
    }
    if (!(segment.duration_s > 0) || conveyor_.speed_mm_s == 0) return;
    auto conveyor_segment = std::make_shared<Segment>();
    conveyor_segment->kind = SegmentKind::linear;
    conveyor_segment->duration_s = segment.duration_s;
    conveyor_segment->start = rrs::JointPos::Zero(joints_per_mm_.size());
    conveyor_segment->end = conveyor_.speed_mm_s * segment.duration_s * joints_per_mm_;
    conveyor_segment->master = constant_speed(std::abs(conveyor_.speed_mm_s), segment.duration_s);
    conveyor_segment->position_joints = segment.position_joints;
    segment.superimposed = std::move(conveyor_segment);
}

PlanResult ConveyorFrame::plan_ramp(const PlannerSetup& setup, bool up, Segment& segment) const {
    const double speed = std::abs(conveyor_.speed_mm_s);
    MasterPath master;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (joints_per_mm_[joint] != 0)
            master.limit_by_joint(joint, law_limits(setup, joint), std::abs(joints_per_mm_[joint]));
    }
    LawLimits& limits = master.limits;
    const double rate = up ? limits.acceleration : limits.deceleration;
    const double length = ramp_length(0, speed, rate, limits.jerk);
    segment.kind = SegmentKind::linear;
    segment.limited_by = master.acceleration_limit;
    segment.master_limits = limits;
    segment.end = segment.start + std::copysign(length, conveyor_.speed_mm_s) * joints_per_mm_;
    segment.master = TimeLaw::between(length, up ? 0 : speed, up ? speed : 0, limits);
    segment.duration_s = segment.master.duration_s();
    segment.length_mm = length;
    return check_target_ranges(setup, segment.end);
}

rrs::JointPos ConveyorFrame::shift(double time_s) const {
    return conveyor_.position_mm_at(time_s) * joints_per_mm_;
}

}  // namespace gsim::motion
