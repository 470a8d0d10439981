#include "motion/segment/move_part.h"

#include <algorithm>
#include <cmath>

#include "motion/path/arc_part.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

rrs::JointPos position_on_move(const PathMove& move, double share,
                               const std::array<int, 3>& position_joints) {
    if (share <= 0) return move.start;
    if (share >= 1) return move.end;
    rrs::JointPos position = move.start + share * (move.end - move.start);
    if (move.kind == SegmentKind::circular)
        write_position(position_joints, move.arc.at(move.arc.phi_at(share * move.arc.length_mm())), position);
    if (move.orientation) {
        const OrientationArc& orientation_arc = *move.orientation;
        const HeadAngles angles = orientation_arc.at(share * orientation_arc.length_rad()).angles;
        position[orientation_arc.turn_joint()] = angles.turn;
        position[orientation_arc.tilt_joint()] = angles.tilt;
    }
    return position;
}

}  // namespace

PathMove move_part(const PathMove& move, double length, double from, double to,
                   const std::array<int, 3>& position_joints) {
    const double first = from / length, last = to / length;
    PathMove part = move;
    part.start = position_on_move(move, first, position_joints);
    part.end = position_on_move(move, last, position_joints);
    part.length_mm *= last - first;
    part.rules.min_duration_s *= last - first;
    part.reaches_target = last >= 1 && move.reaches_target;
    if (move.kind == SegmentKind::circular) {
        const double arc_mm = move.arc.length_mm();
        const auto arc = arc_part(move.arc, first * arc_mm, last * arc_mm);
        part.kind = arc ? SegmentKind::circular : SegmentKind::linear;
        if (arc) part.arc = *arc;
    }
    if (move.orientation) {
        const double turn_rad = move.orientation->length_rad();
        part.orientation =
            std::make_shared<const OrientationArc>(move.orientation->part(first * turn_rad, last * turn_rad));
    }
    if (move.sub_segment) {
        part.sub_segment = std::make_shared<const ToolSubSegment>(
            ToolSubSegment{move.sub_segment->role, move.sub_segment->length * (last - first),
                           move.sub_segment->joint_curvature});
    }
    return part;
}

void set_path(const PathMove& move, Segment& segment) {
    segment.kind = move.kind;
    segment.start = move.start;
    segment.end = move.end;
    if (move.kind == SegmentKind::circular) segment.arc = move.arc;
    segment.orientation = move.orientation;
    segment.length_mm = move.length_mm;
    segment.reaches_target = move.reaches_target;
}

double switchable_s(const TimeLaw& law, double t_s, double jerk) {
    constexpr double kNegligibleShare = 1e-9;  // of the law's greatest
    if (std::isinf(jerk)) return t_s;
    const double none = kNegligibleShare * law.peak_acceleration();
    double end_s = 0;
    for (const LawSection& sub_segment : law.sections()) {
        end_s += sub_segment.duration_s;
        if (end_s < t_s) continue;
        if (std::abs(sub_segment.a0) <= none && sub_segment.jerk == 0)
            return std::max(t_s, end_s - sub_segment.duration_s);
        if (std::abs(sub_segment.a0 + sub_segment.jerk * sub_segment.duration_s) <= none) return end_s;
    }
    return law.duration_s();
}

}  // namespace gsim::motion
