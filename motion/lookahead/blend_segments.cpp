// The segments of a blend.

#include <memory>

#include "motion/lookahead/blend.h"

namespace gsim::motion {

namespace {

/// Speed along each of the two paths in one half of a blend, a polynomial each.
struct HalfLaws {
    TimeLaw leaving;
    TimeLaw entering;
};

TimeLaw make_law(const LawSection& section) {
    return TimeLaw::from_sections({&section, 1});
}

HalfLaws first_half(bool smooth, double speed, double half_s) {
    const double a0 = smooth ? 0 : speed / (2 * half_s);
    const double jerk = smooth ? speed / (half_s * half_s) : 0;
    return {make_law({half_s, 0, speed, -a0, -jerk}), make_law({half_s, 0, 0, a0, jerk})};
}

HalfLaws second_half(bool smooth, double speed, double half_s) {
    const double a0 = speed / half_s / (smooth ? 1 : 2);
    const double jerk = smooth ? speed / (half_s * half_s) : 0;
    return {make_law({half_s, 0, speed / 2, -a0, jerk}), make_law({half_s, 0, speed / 2, a0, -jerk})};
}

/// Ends of the parts of both lines that are passed in one half, as path lengths.
struct BlendHalfRanges {
    double leaving_from, exit_to;
    double entering_from, entry_to;
};

double length_mm(const Block& from, const Segment& segment, double cut) {
    if (from.master.role == JointRole::position) return segment.blended_length_mm();
    return from.master.role == JointRole::secondary ? cut : 0;
}

void fill(const Block& from, const Block& to, const BlendHalfRanges& ranges, const HalfLaws& laws,
          Segment& segment) {
    auto superimposed = std::make_shared<Segment>();
    superimposed->kind = segment.kind = SegmentKind::linear;
    superimposed->target_id = segment.target_id;
    superimposed->start_s = segment.start_s;
    superimposed->position_joints = segment.position_joints;
    superimposed->duration_s = segment.duration_s = laws.leaving.duration_s();
    superimposed->start = to.line_at(ranges.entering_from);
    superimposed->end = to.line_at(ranges.entry_to);
    superimposed->master = laws.entering;
    const rrs::JointPos moved = superimposed->start - to.move.start;
    segment.start = from.line_at(ranges.leaving_from) + moved;
    segment.end = from.line_at(ranges.exit_to) + moved;
    segment.master = laws.leaving;
    segment.master_limits = {};
    segment.path_deviation = PathDeviation::corner;
    segment.superimposed = std::move(superimposed);
    segment.length_mm = length_mm(from, segment, to.entry_blend.cut);
}

}  // namespace

void emit_blend(const Block& from, const Block& to, double speed, LimitCause limited_by,
                SegmentOutput& output) {
    const Blend& blend = to.entry_blend;
    const double half_s = blend.cut / speed;
    const double near = blend.cut * corner_distance_share(blend.smooth);
    const double length = from.master.length;
    Segment& first = output.begin(from.move.target_id);
    fill(from, to, {length - blend.cut, length - near, 0, near}, first_half(blend.smooth, speed, half_s),
         first);
    first.limited_by = limited_by;
    first.reaches_target = from.move.reaches_target;
    output.finish();
    Segment& second = output.begin(to.move.target_id);
    fill(from, to, {length - near, length, near, blend.cut}, second_half(blend.smooth, speed, half_s),
         second);
    second.limited_by = limited_by;
    second.reaches_target = false;
    second.deviation_mm = blend.deviation_mm;
    output.finish();
}

}  // namespace gsim::motion
