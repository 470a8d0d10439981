#include "motion/linuxcnc/sub_segment_path.h"

#include <optional>

#include "motion/path/arc_part.h"

namespace gsim::motion::linuxcnc {

namespace {

double arc_scale(const SubSegment& sub_segment) {
    return sub_segment.arc.length_mm() / (sub_segment.length - sub_segment.lead_in.length);
}

// Applies to the lead-in, or to a full line.
rrs::JointPos on_line(const SubSegment& sub_segment, const Axes& axes, double length) {
    if (sub_segment.lead_in.length <= 0)
        return sub_segment.start + length / sub_segment.length * (sub_segment.end - sub_segment.start);
    rrs::JointPos joints = sub_segment.start;
    axes.set_point(axes.point(sub_segment.start) + length * sub_segment.direction, joints);
    return joints;
}

rrs::JointPos is_on_arc(const SubSegment& sub_segment, const Axes& axes, double length) {
    const double distance = length - sub_segment.lead_in.length;
    rrs::JointPos joints = sub_segment.start + distance / (sub_segment.length - sub_segment.lead_in.length) *
                                                   (sub_segment.end - sub_segment.start);
    axes.set_point(sub_segment.arc.at(sub_segment.arc.phi_at(distance * arc_scale(sub_segment))), joints);
    return joints;
}

}  // namespace

rrs::JointPos joints_at(const SubSegment& sub_segment, const Axes& axes, double length) {
    if (length <= 0) return sub_segment.start;
    if (length >= sub_segment.length) return sub_segment.end;
    const bool is_straight = !sub_segment.curved || length < sub_segment.lead_in.length;
    return is_straight ? on_line(sub_segment, axes, length) : is_on_arc(sub_segment, axes, length);
}

PathPart path_part(const SubSegment& sub_segment, const Axes& axes, double from, double to) {
    PathPart part;
    part.start = joints_at(sub_segment, axes, from);
    part.end = joints_at(sub_segment, axes, to);
    if (sub_segment.curved && from >= sub_segment.lead_in.length) {
        part.scale = arc_scale(sub_segment);
        const bool is_full_arc = from <= sub_segment.lead_in.length && to >= sub_segment.length;
        const std::optional<Arc> arc =
            is_full_arc ? sub_segment.arc
                        : arc_part(sub_segment.arc, (from - sub_segment.lead_in.length) * part.scale,
                                   (to - sub_segment.lead_in.length) * part.scale);
        part.curved = arc.has_value();
        if (arc) part.arc = *arc;
    }
    part.length_mm = sub_segment.limits.path_limited ? (to - from) * part.scale : 0;
    return part;
}

}  // namespace gsim::motion::linuxcnc
