#include "motion/linuxcnc/way.h"

#include <optional>

#include "motion/path/arc_part.h"

namespace gsim::motion::linuxcnc {

namespace {

double arc_scale(const Piece& piece) {
    return piece.arc.length_mm() / (piece.length - piece.lead_in);
}

// Applies to the lead-in, or to a full line.
rrs::JointPos on_line(const Piece& piece, const Axes& axes, double length) {
    if (piece.lead_in <= 0) return piece.start + length / piece.length * (piece.end - piece.start);
    rrs::JointPos joints = piece.start;
    axes.put(axes.point(piece.start) + length * piece.direction, joints);
    return joints;
}

rrs::JointPos on_arc(const Piece& piece, const Axes& axes, double length) {
    const double way = length - piece.lead_in;
    rrs::JointPos joints = piece.start + way / (piece.length - piece.lead_in) * (piece.end - piece.start);
    axes.put(piece.arc.at(piece.arc.phi_at(way * arc_scale(piece))), joints);
    return joints;
}

}  // namespace

rrs::JointPos joints_at(const Piece& piece, const Axes& axes, double length) {
    if (length <= 0) return piece.start;
    if (length >= piece.length) return piece.end;
    const bool straight = !piece.curved || length < piece.lead_in;
    return straight ? on_line(piece, axes, length) : on_arc(piece, axes, length);
}

WayPart way_part(const Piece& piece, const Axes& axes, double from, double to) {
    WayPart part;
    part.start = joints_at(piece, axes, from);
    part.end = joints_at(piece, axes, to);
    if (piece.curved && from >= piece.lead_in) {
        part.scale = arc_scale(piece);
        const bool whole = from <= piece.lead_in && to >= piece.length;
        const std::optional<Arc> arc = whole ? piece.arc
                                             : arc_part(piece.arc, (from - piece.lead_in) * part.scale,
                                                        (to - piece.lead_in) * part.scale);
        part.curved = arc.has_value();
        if (arc) part.arc = *arc;
    }
    part.length_mm = piece.path_limited ? (to - from) * part.scale : 0;
    return part;
}

}  // namespace gsim::motion::linuxcnc
