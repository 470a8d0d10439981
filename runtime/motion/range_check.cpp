#include "runtime/motion/range_check.h"

#include <fmt/format.h>

namespace gsim::motion {

namespace {

constexpr double kRounding = 1e-9;

tl::unexpected<PlanError> out_of_range(const PlannerSetup& setup, int joint, double value, double limit,
                                       const char* where) {
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

}  // namespace

Planned check_target_ranges(const PlannerSetup& setup, const rrs::JointPos& joints) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
        const double value = joints[joint];
        const char* where = "at the target";
        if (value < range.min - kRounding) return out_of_range(setup, joint, value, range.min, where);
        if (value > range.max + kRounding) return out_of_range(setup, joint, value, range.max, where);
    }
    return {};
}

Planned check_way_ranges(const PlannerSetup& setup, const Segment& segment) {
    rrs::JointPos least = segment.start;
    rrs::JointPos most = segment.start;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const Range way = segment.joint_range(joint);
        least[joint] = way.min;
        most[joint] = way.max;
    }
    Planned checked = check_target_ranges(setup, least);
    return checked ? check_target_ranges(setup, most) : checked;
}

Planned check_arc_ranges(const PlannerSetup& setup, const Segment& segment) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) continue;
        const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
        const Range wide = segment.arc.bounds(axis);
        if (wide.min >= range.min && wide.max <= range.max) continue;
        const Range way = segment.arc.range(axis);
        const char* where = "on the way along the arc";
        if (way.min < range.min - kRounding) return out_of_range(setup, joint, way.min, range.min, where);
        if (way.max > range.max + kRounding) return out_of_range(setup, joint, way.max, range.max, where);
    }
    return {};
}

Planned check_tilt_range(const PlannerSetup& setup, const OrientationArc& arc) {
    const int joint = arc.tilt_joint();
    const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
    const Range way = arc.tilt_range();
    const char* where = "on the way along the great circle";
    if (way.min < range.min - kRounding) return out_of_range(setup, joint, way.min, range.min, where);
    if (way.max > range.max + kRounding) return out_of_range(setup, joint, way.max, range.max, where);
    return {};
}

}  // namespace gsim::motion
