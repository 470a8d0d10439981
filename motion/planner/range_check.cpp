#include "motion/planner/range_check.h"

#include <fmt/format.h>

namespace gsim::motion {

namespace {

constexpr double kRangeRounding = 1e-9;  // mm or rad

tl::unexpected<PlanError> out_of_range(const PlannerSetup& setup, const Excursion& excursion,
                                       const char* where) {
    const auto [joint, value, limit] = excursion;
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

Planned judge(const PlannerSetup& setup, const Excursion& excursion, const char* where) {
    if (setup.range_notes == nullptr || !setup.range_notes->passing())
        return out_of_range(setup, excursion, where);
    setup.range_notes->note(excursion);
    return {};
}

bool within(const JointSetup& range, const Range& way) {
    return way.min >= range.min - kRangeRounding && way.max <= range.max + kRangeRounding;
}

Planned check_way(const PlannerSetup& setup, int joint, const Range& way, const char* where) {
    const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
    if (way.min < range.min - kRangeRounding) {
        if (Planned judged = judge(setup, {joint, way.min, range.min}, where); !judged) return judged;
    }
    if (way.max > range.max + kRangeRounding) return judge(setup, {joint, way.max, range.max}, where);
    return {};
}

}  // namespace

Planned check_target_ranges(const PlannerSetup& setup, const rrs::JointPos& joints) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const Range way{joints[joint], joints[joint]};
        if (within(setup.joints[static_cast<std::size_t>(joint)], way)) continue;
        if (Planned checked = check_way(setup, joint, way, "at the target"); !checked) return checked;
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

Planned check_arc_ranges(const PlannerSetup& setup, const Arc& arc) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) continue;
        const JointSetup& range = setup.joints[static_cast<std::size_t>(joint)];
        const Range wide = arc.bounds(axis);
        if (wide.min >= range.min && wide.max <= range.max) continue;
        Planned checked = check_way(setup, joint, arc.range(axis), "on the way along the arc");
        if (!checked) return checked;
    }
    return {};
}

Planned check_tilt_range(const PlannerSetup& setup, const OrientationArc& arc) {
    return check_way(setup, arc.tilt_joint(), arc.tilt_range(), "on the way along the great circle");
}

}  // namespace gsim::motion
