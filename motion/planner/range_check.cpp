#include "motion/planner/range_check.h"

#include <fmt/format.h>

namespace gsim::motion {

namespace {

constexpr double kRangeRounding = 1e-9;  // mm or rad

tl::unexpected<PlanError> out_of_range(const PlannerSetup& setup, const Overtravel& overtravel,
                                       const char* where) {
    const auto [joint, value, limit] = overtravel;
    const bool prismatic = setup.joints[static_cast<std::size_t>(joint)].kind == rrs::JointKind::prismatic;
    return tl::unexpected(PlanError{
        .status = rrs::Status::RRS_JOINT_LIMIT,
        .message =
            fmt::format("Joint {} (counted from 0) would be at {} {unit} {}; its range ends at {} {unit}.",
                        joint, value, where, limit, fmt::arg("unit", prismatic ? "mm" : "rad")),
        .joint = joint,
        .value = value,
        .limit = limit});
}

PlanResult check_excursion(const PlannerSetup& setup, const Overtravel& overtravel, const char* where) {
    if (setup.overtravel_log == nullptr || !setup.overtravel_log->accepts_excursions())
        return out_of_range(setup, overtravel, where);
    setup.overtravel_log->note(overtravel);
    return {};
}

bool within(const JointSetup& range, const Range& travel) {
    return travel.min >= range.min - kRangeRounding && travel.max <= range.max + kRangeRounding;
}

PlanResult check_travel(const PlannerSetup& setup, int joint, const Range& travel, const char* where) {
    const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
    if (travel.min < range.min - kRangeRounding) {
        if (PlanResult verdict = check_excursion(setup, {joint, travel.min, range.min}, where); !verdict)
            return verdict;
    }
    if (travel.max > range.max + kRangeRounding)
        return check_excursion(setup, {joint, travel.max, range.max}, where);
    return {};
}

}  // namespace

PlanResult check_target_ranges(const PlannerSetup& setup, const rrs::JointPos& joints) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const Range travel{joints[joint], joints[joint]};
        if (within(setup.joints[static_cast<std::size_t>(joint)], travel)) continue;
        if (PlanResult checked = check_travel(setup, joint, travel, "at the target"); !checked)
            return checked;
    }
    return {};
}

PlanResult check_path_ranges(const PlannerSetup& setup, const Segment& segment) {
    rrs::JointPos min = segment.start;
    rrs::JointPos max = segment.start;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const Range travel = segment.joint_range(joint);
        min[joint] = travel.min;
        max[joint] = travel.max;
    }
    PlanResult checked = check_target_ranges(setup, min);
    return checked ? check_target_ranges(setup, max) : checked;
}

PlanResult check_arc_ranges(const PlannerSetup& setup, const Arc& arc) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) continue;
        const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
        const Range wide = arc.bounds(axis);
        if (wide.min >= range.min && wide.max <= range.max) continue;
        PlanResult checked = check_travel(setup, joint, arc.range(axis), "along the arc");
        if (!checked) return checked;
    }
    return {};
}

PlanResult check_tilt_range(const PlannerSetup& setup, const OrientationArc& arc) {
    return check_travel(setup, arc.tilt_joint(), arc.tilt_range(), "along the great circle");
}

}  // namespace gsim::motion
