#include "motion/segment/move_part.h"

#include <algorithm>
#include <cmath>

#include "motion/path/arc_part.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

rrs::JointPos place_on(const PathMove& move, double share, const std::array<int, 3>& position_joints) {
    if (share <= 0) return move.start;
    if (share >= 1) return move.end;
    rrs::JointPos place = move.start + share * (move.end - move.start);
    if (move.kind == SegmentKind::circular)
        put_position(position_joints, move.arc.at(move.arc.phi_at(share * move.arc.length_mm())), place);
    if (move.orientation) {
        const OrientationArc& way = *move.orientation;
        const HeadAngles angles = way.at(share * way.length_rad()).angles;
        place[way.turn_joint()] = angles.turn;
        place[way.tilt_joint()] = angles.tilt;
    }
    return place;
}

}  // namespace

PathMove move_part(const PathMove& move, double length, double from, double to,
                   const std::array<int, 3>& position_joints) {
    const double first = from / length, last = to / length;
    PathMove part = move;
    part.start = place_on(move, first, position_joints);
    part.end = place_on(move, last, position_joints);
    part.length_mm *= last - first;
    part.rules.least_duration_s *= last - first;
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
    if (move.piece) {
        part.piece = std::make_shared<const ToolPiece>(
            ToolPiece{move.piece->role, move.piece->length * (last - first), move.piece->bend});
    }
    return part;
}

void set_way(const PathMove& move, Segment& segment) {
    segment.kind = move.kind;
    segment.start = move.start;
    segment.end = move.end;
    if (move.kind == SegmentKind::circular) segment.arc = move.arc;
    segment.orientation = move.orientation;
    segment.length_mm = move.length_mm;
    segment.reaches_target = move.reaches_target;
}

double turning_s(const TimeLaw& law, double t_s, double jerk) {
    constexpr double kNoAcceleration = 1e-9;  // of the law's greatest
    if (std::isinf(jerk)) return t_s;
    const double none = kNoAcceleration * law.peak_acceleration();
    double end_s = 0;
    for (const LawPiece& piece : law.pieces()) {
        end_s += piece.duration_s;
        if (end_s < t_s) continue;
        if (std::abs(piece.a0) <= none && piece.jerk == 0) return std::max(t_s, end_s - piece.duration_s);
        if (std::abs(piece.a0 + piece.jerk * piece.duration_s) <= none) return end_s;
    }
    return law.duration_s();
}

}  // namespace gsim::motion
