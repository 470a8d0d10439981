#include "motion/linuxcnc/segment_writer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "motion/linuxcnc/sub_segment_path.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kTimeRounding_s = 1e-12;  // of times that are cut out of others

bool done(const QueuedSubSegment& queued) {
    return queued.remaining_s() <= kTimeRounding_s;
}

// Returns the end time of the part of the path on which the sub-segment is at `from_s`.
double path_part_end_s(const QueuedSubSegment& queued, double from_s) {
    if (queued.sub_segment.lead_in.length > 0) {
        const double lead_in_s = queued.law.time_at(queued.sub_segment.lead_in.length);
        if (from_s < lead_in_s - kTimeRounding_s) return lead_in_s;
    }
    return queued.law.duration_s();
}

// Returns the distance at an instant. An instant near to one of the ends, or to the end of the lead-in,
// counts as exactly there.
double distance_at(const QueuedSubSegment& queued, double t_s) {
    const double end_s = queued.law.duration_s();
    if (t_s <= 0) return 0;
    if (t_s >= end_s - kTimeRounding_s) return queued.sub_segment.length;
    if (queued.sub_segment.lead_in.length > 0 &&
        std::abs(t_s - queued.law.time_at(queued.sub_segment.lead_in.length)) <= kTimeRounding_s) {
        return queued.sub_segment.lead_in.length;
    }
    return std::min(queued.law.at(t_s), queued.sub_segment.length);
}

// Sub-segment of the next group that moves while the front one stops.
struct OverlapPartner {
    std::optional<std::size_t> head = std::nullopt;  // nullopt: not timed yet
    const rrs::JointPos* corner = nullptr;           // start of that group
    std::optional<std::size_t> stopped_index =
        std::nullopt;  // its last sub-segment, if all of it has been output
};

OverlapPartner find_overlap_partner(SubSegmentQueue& queue, std::size_t ready) {
    std::size_t last = 0;
    while (last < ready && !queue[last].is_group_end) ++last;
    for (std::size_t index = last + 1; index < ready; ++index) {
        if (!done(queue[index])) return {index, &queue[last].sub_segment.end, std::nullopt};
        if (queue[index].is_group_end) return {std::nullopt, &queue[last].sub_segment.end, index};
    }
    return {};
}

bool is_on_lead_in(const QueuedSubSegment& queued, double to_s) {
    return queued.sub_segment.lead_in.length > 0 &&
           distance_at(queued, to_s) <= queued.sub_segment.lead_in.length;
}

// A blend arc belongs to the later move; the line where it begins belongs to the earlier one.
rrs::TargetId target_id_at(const QueuedSubSegment& queued, double to_s) {
    return is_on_lead_in(queued, to_s) ? queued.sub_segment.lead_in.target_id : queued.sub_segment.target_id;
}

// True if a sub-segment's target is reached at an instant: at its end or at the start of the next move,
// unless a blend arc leads in on its line.
bool reaches_target_at(const QueuedSubSegment& queued, double to_s, const QueuedSubSegment* next) {
    if (is_on_lead_in(queued, to_s)) return distance_at(queued, to_s) >= queued.sub_segment.lead_in.length;
    if (to_s < queued.law.duration_s() - queued.overlap_time_s - kTimeRounding_s) return false;
    if (next == nullptr) return true;
    const SubSegment& following = next->sub_segment;
    return (following.lead_in.length > 0 ? following.lead_in.target_id : following.target_id) !=
           queued.sub_segment.target_id;
}

const QueuedSubSegment* following(const SubSegmentQueue& queue, std::size_t index) {
    return index + 1 < queue.size() ? &queue[index + 1] : nullptr;
}

bool is_sub_segment_end(const QueuedSubSegment& queued, double to_s) {
    return to_s >= queued.law.duration_s() - kTimeRounding_s;
}

bool is_group_end(const QueuedSubSegment& queued, double to_s) {
    return queued.is_group_end && is_sub_segment_end(queued, to_s);
}

void translate_segment(const rrs::JointPos& displacement, const Axes& axes, Segment& segment) {
    segment.start += displacement;
    segment.end += displacement;
    if (segment.kind == SegmentKind::circular) segment.arc.center += axes.point(displacement);
}

// Finds how near the tool comes to the corner while two motions overlap.
void update_nearest(const Segment& segment, const Axes& axes, const rrs::JointPos& corner,
                    QueuedSubSegment& tail) {
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
        const rrs::JointPos at = segment.position_at(segment.duration_s * i / kSteps);
        const double distance_mm = axes.point(at - corner).norm();
        if (!tail.is_nearest_known || distance_mm < tail.nearest_mm) tail.nearest_mm = distance_mm;
        tail.is_nearest_known = true;
    }
}

}  // namespace

std::size_t Writer::write(SubSegmentQueue& queue, std::size_t ready, bool ended) {
    std::size_t dropped = 0;
    while (dropped < ready && write_front(queue, ready - dropped, ended)) {
        queue.pop();
        ++dropped;
    }
    return dropped;
}

bool Writer::write_front(SubSegmentQueue& queue, std::size_t ready, bool ended) {
    const QueuedSubSegment& queued = queue.front();
    write_single(queue, queued.law.duration_s() - queued.overlap_time_s);
    while (!done(queued)) {
        const OverlapPartner next = find_overlap_partner(queue, ready);
        if (next.head) {
            write_overlap(queue, *next.head, *next.corner);
        } else if (next.stopped_index) {
            write_to_standstill(queue, *next.stopped_index, *next.corner);
        } else if (ended) {
            write_single(queue, queued.law.duration_s());
        } else {
            return false;
        }
    }
    return true;
}

void Writer::write_single(SubSegmentQueue& queue, double until_s) {
    QueuedSubSegment& queued = queue.front();
    while (queued.emitted_s < until_s - kTimeRounding_s) {
        const double to_s = std::min(until_s, path_part_end_s(queued, queued.emitted_s));
        append_span({&queued, queued.emitted_s, to_s, following(queue, 0)});
        queued.emitted_s = to_s;
    }
}

void Writer::write_overlap(SubSegmentQueue& queue, std::size_t head_index, const rrs::JointPos& corner) {
    QueuedSubSegment& tail = queue.front();
    QueuedSubSegment& head = queue[head_index];
    while (!done(head) && !done(tail)) {
        const double tail_part_s = path_part_end_s(tail, tail.emitted_s) - tail.emitted_s;
        const double head_part_s = path_part_end_s(head, head.emitted_s) - head.emitted_s;
        const double step_s = std::min(tail_part_s, head_part_s);
        write_both({&tail, tail.emitted_s, tail.emitted_s + step_s, following(queue, 0)},
                   {&head, head.emitted_s, head.emitted_s + step_s, following(queue, head_index)}, corner);
        tail.emitted_s += step_s;
        head.emitted_s += step_s;
    }
}

// The next group, which started at the corner, is already at its end. The front one stops there.
void Writer::write_to_standstill(SubSegmentQueue& queue, std::size_t stopped_index,
                                 const rrs::JointPos& corner) {
    QueuedSubSegment& tail = queue.front();
    const QueuedSubSegment& stopped_part = queue[stopped_index];
    while (!done(tail)) {
        const double to_s = path_part_end_s(tail, tail.emitted_s);
        Segment& segment = output_.begin(stopped_part.sub_segment.target_id);
        fill({&tail, tail.emitted_s, to_s, nullptr}, segment);
        translate_segment(stopped_part.sub_segment.end - corner, axes_, segment);
        segment.path_deviation = PathDeviation::other;
        segment.reaches_target =
            is_group_end(tail, to_s) &&
            reaches_target_at(stopped_part, stopped_part.law.duration_s(), following(queue, stopped_index));
        update_nearest(segment, axes_, corner, tail);
        if (is_sub_segment_end(tail, to_s))
            segment.deviation_mm = std::max(segment.deviation_mm, tail.nearest_mm);
        output_.finish();
        tail.emitted_s = to_s;
    }
}

void Writer::append_span(const Span& span) {
    Segment& segment = output_.begin(target_id_at(*span.queued, span.to_s));
    fill(span, segment);
    segment.reaches_target = reaches_target_at(*span.queued, span.to_s, span.next);
    output_.finish();
}

// The earlier motion is shifted by the later one, which has moved on since it started at the corner.
void Writer::write_both(const Span& tail, const Span& head, const rrs::JointPos& corner) {
    const rrs::TargetId id = target_id_at(*head.queued, head.to_s);
    Segment& segment = output_.begin(id);
    fill(tail, segment);
    auto superimposed = std::make_shared<Segment>();
    superimposed->target_id = id;
    superimposed->start_s = segment.start_s;
    superimposed->position_joints = segment.position_joints;
    fill(head, *superimposed);
    translate_segment(superimposed->start - corner, axes_, segment);
    const bool stops_first = is_group_end(*head.queued, head.to_s) && !is_group_end(*tail.queued, tail.to_s);
    segment.reaches_target = !stops_first && reaches_target_at(*head.queued, head.to_s, head.next);
    segment.superimposed = std::move(superimposed);
    segment.path_deviation = PathDeviation::other;
    segment.length_mm = segment.blended_length_mm();
    update_nearest(segment, axes_, corner, *tail.queued);
    if (is_sub_segment_end(*tail.queued, tail.to_s))
        segment.deviation_mm = std::max(segment.deviation_mm, tail.queued->nearest_mm);
    output_.finish();
}

void Writer::fill(const Span& span, Segment& segment) const {
    const QueuedSubSegment& queued = *span.queued;
    const PathPart part = path_part(queued.sub_segment, axes_, distance_at(queued, span.from_s),
                                    distance_at(queued, span.to_s));
    segment.kind = part.curved ? SegmentKind::circular : SegmentKind::linear;
    segment.start = part.start;
    segment.end = part.end;
    if (part.curved) segment.arc = part.arc;
    segment.length_mm = part.length_mm;
    segment.duration_s = span.to_s - span.from_s;
    segment.master = queued.law.part(span.from_s, span.to_s).scaled(part.scale);
    segment.master_limits.max_speed = target_speed(queued.sub_segment) * part.scale;
    segment.master_limits.acceleration = acceleration(queued.sub_segment) * part.scale;
    segment.master_limits.deceleration = segment.master_limits.acceleration;
    segment.master_limits.jerk = queued.sub_segment.limits.jerk * part.scale;
    segment.limited_by = queued.limited_by;
    segment.path_deviation = queued.sub_segment.path_deviation;
    segment.deviation_mm =
        part.curved && is_sub_segment_end(queued, span.to_s) ? queued.sub_segment.deviation_mm : 0;
}

}  // namespace gsim::motion::linuxcnc
