#include "motion/linuxcnc/writer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "motion/linuxcnc/way.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kTimeRounding_s = 1e-12;  // of times that are cut out of others

bool done(const HeldPiece& held) {
    return held.left_s() <= kTimeRounding_s;
}

// Returns the end time of the part of the path on which the sub-segment is at `from_s`.
double part_end_s(const HeldPiece& held, double from_s) {
    if (held.piece.lead_in > 0) {
        const double lead_in_s = held.law.time_at(held.piece.lead_in);
        if (from_s < lead_in_s - kTimeRounding_s) return lead_in_s;
    }
    return held.law.duration_s();
}

// Returns the distance at an instant. An instant near to one of the ends, or to the end of the lead-in,
// counts as exactly there.
double way_at(const HeldPiece& held, double t_s) {
    const double end_s = held.law.duration_s();
    if (t_s <= 0) return 0;
    if (t_s >= end_s - kTimeRounding_s) return held.piece.length;
    if (held.piece.lead_in > 0 && std::abs(t_s - held.law.time_at(held.piece.lead_in)) <= kTimeRounding_s) {
        return held.piece.lead_in;
    }
    return std::min(held.law.at(t_s), held.piece.length);
}

// Sub-segment of the next group that moves while the front one stops.
struct Partner {
    std::optional<std::size_t> head = std::nullopt;     // nullopt: not timed yet
    const rrs::JointPos* corner = nullptr;              // start of that group
    std::optional<std::size_t> at_rest = std::nullopt;  // its last sub-segment, if all of it has been output
};

Partner partner(PieceQueue& queue, std::size_t ready) {
    std::size_t last = 0;
    while (last < ready && !queue[last].ends_group) ++last;
    for (std::size_t index = last + 1; index < ready; ++index) {
        if (!done(queue[index])) return {index, &queue[last].piece.end, std::nullopt};
        if (queue[index].ends_group) return {std::nullopt, &queue[last].piece.end, index};
    }
    return {};
}

bool leads_in(const HeldPiece& held, double to_s) {
    return held.piece.lead_in > 0 && way_at(held, to_s) <= held.piece.lead_in;
}

// A blend arc belongs to the later move; the line on which it begins belongs to the earlier one.
rrs::TargetId target_of(const HeldPiece& held, double to_s) {
    return leads_in(held, to_s) ? held.piece.lead_in_id : held.piece.target_id;
}

// True if a sub-segment's target is reached at an instant: at its end or at the start of the next move,
// unless a blend arc leads in on its line.
bool ends_target(const HeldPiece& held, double to_s, const HeldPiece* next) {
    if (leads_in(held, to_s)) return way_at(held, to_s) >= held.piece.lead_in;
    if (to_s < held.law.duration_s() - held.shared_s - kTimeRounding_s) return false;
    if (next == nullptr) return true;
    const Piece& behind = next->piece;
    return (behind.lead_in > 0 ? behind.lead_in_id : behind.target_id) != held.piece.target_id;
}

const HeldPiece* behind(const PieceQueue& queue, std::size_t index) {
    return index + 1 < queue.size() ? &queue[index + 1] : nullptr;
}

bool ends_piece(const HeldPiece& held, double to_s) {
    return to_s >= held.law.duration_s() - kTimeRounding_s;
}

bool ends_group(const HeldPiece& held, double to_s) {
    return held.ends_group && ends_piece(held, to_s);
}

void shift_by(const rrs::JointPos& way, const Axes& axes, Segment& segment) {
    segment.start += way;
    segment.end += way;
    if (segment.kind == SegmentKind::circular) segment.arc.center += axes.point(way);
}

// Finds how near the tool comes to the corner while two motions overlap.
void look_for_nearest(const Segment& segment, const Axes& axes, const rrs::JointPos& corner,
                      HeldPiece& tail) {
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
        const rrs::JointPos at = segment.position_at(segment.duration_s * i / kSteps);
        const double distance_mm = axes.point(at - corner).norm();
        if (!tail.shares_end || distance_mm < tail.nearest_mm) tail.nearest_mm = distance_mm;
        tail.shares_end = true;
    }
}

}  // namespace

std::size_t Writer::write(PieceQueue& queue, std::size_t ready, bool ended) {
    std::size_t dropped = 0;
    while (dropped < ready && write_front(queue, ready - dropped, ended)) {
        queue.pop();
        ++dropped;
    }
    return dropped;
}

bool Writer::write_front(PieceQueue& queue, std::size_t ready, bool ended) {
    const HeldPiece& held = queue.front();
    write_alone(queue, held.law.duration_s() - held.shared_s);
    while (!done(held)) {
        const Partner next = partner(queue, ready);
        if (next.head) {
            write_shared(queue, *next.head, *next.corner);
        } else if (next.at_rest) {
            write_to_rest(queue, *next.at_rest, *next.corner);
        } else if (ended) {
            write_alone(queue, held.law.duration_s());
        } else {
            return false;
        }
    }
    return true;
}

void Writer::write_alone(PieceQueue& queue, double until_s) {
    HeldPiece& held = queue.front();
    while (held.written_s < until_s - kTimeRounding_s) {
        const double to_s = std::min(until_s, part_end_s(held, held.written_s));
        put({&held, held.written_s, to_s, behind(queue, 0)});
        held.written_s = to_s;
    }
}

void Writer::write_shared(PieceQueue& queue, std::size_t head_index, const rrs::JointPos& corner) {
    HeldPiece& tail = queue.front();
    HeldPiece& head = queue[head_index];
    while (!done(head) && !done(tail)) {
        const double tail_s = part_end_s(tail, tail.written_s) - tail.written_s;
        const double head_s = part_end_s(head, head.written_s) - head.written_s;
        const double step_s = std::min(tail_s, head_s);
        put_both({&tail, tail.written_s, tail.written_s + step_s, behind(queue, 0)},
                 {&head, head.written_s, head.written_s + step_s, behind(queue, head_index)}, corner);
        tail.written_s += step_s;
        head.written_s += step_s;
    }
}

// The next group, which started at the corner, is already at its end. The front one stops there.
void Writer::write_to_rest(PieceQueue& queue, std::size_t standing_index, const rrs::JointPos& corner) {
    HeldPiece& tail = queue.front();
    const HeldPiece& standing = queue[standing_index];
    while (!done(tail)) {
        const double to_s = part_end_s(tail, tail.written_s);
        Segment& segment = output_.begin(standing.piece.target_id);
        fill({&tail, tail.written_s, to_s, nullptr}, segment);
        shift_by(standing.piece.end - corner, axes_, segment);
        segment.off_way = OffWay::yes;
        segment.reaches_target = ends_group(tail, to_s) && ends_target(standing, standing.law.duration_s(),
                                                                       behind(queue, standing_index));
        look_for_nearest(segment, axes_, corner, tail);
        if (ends_piece(tail, to_s)) segment.deviation_mm = std::max(segment.deviation_mm, tail.nearest_mm);
        output_.finish();
        tail.written_s = to_s;
    }
}

void Writer::put(const Span& span) {
    Segment& segment = output_.begin(target_of(*span.held, span.to_s));
    fill(span, segment);
    segment.reaches_target = ends_target(*span.held, span.to_s, span.next);
    output_.finish();
}

// The earlier motion is shifted by the later one, which has moved on since it started at the corner.
void Writer::put_both(const Span& tail, const Span& head, const rrs::JointPos& corner) {
    const rrs::TargetId id = target_of(*head.held, head.to_s);
    Segment& segment = output_.begin(id);
    fill(tail, segment);
    auto beside = std::make_shared<Segment>();
    beside->target_id = id;
    beside->start_s = segment.start_s;
    beside->position_joints = segment.position_joints;
    fill(head, *beside);
    shift_by(beside->start - corner, axes_, segment);
    const bool stands_first = ends_group(*head.held, head.to_s) && !ends_group(*tail.held, tail.to_s);
    segment.reaches_target = !stands_first && ends_target(*head.held, head.to_s, head.next);
    segment.beside = std::move(beside);
    segment.off_way = OffWay::yes;
    segment.length_mm = segment.blended_length_mm();
    look_for_nearest(segment, axes_, corner, *tail.held);
    if (ends_piece(*tail.held, tail.to_s))
        segment.deviation_mm = std::max(segment.deviation_mm, tail.held->nearest_mm);
    output_.finish();
}

void Writer::fill(const Span& span, Segment& segment) const {
    const HeldPiece& held = *span.held;
    const WayPart part = way_part(held.piece, axes_, way_at(held, span.from_s), way_at(held, span.to_s));
    segment.kind = part.curved ? SegmentKind::circular : SegmentKind::linear;
    segment.start = part.start;
    segment.end = part.end;
    if (part.curved) segment.arc = part.arc;
    segment.length_mm = part.length_mm;
    segment.duration_s = span.to_s - span.from_s;
    segment.lead = held.law.part(span.from_s, span.to_s).scaled(part.scale);
    segment.lead_limits.max_speed = target_speed(held.piece) * part.scale;
    segment.lead_limits.acceleration = acceleration(held.piece) * part.scale;
    segment.lead_limits.deceleration = segment.lead_limits.acceleration;
    segment.lead_limits.jerk = held.piece.jerk * part.scale;
    segment.limited_by = held.limited_by;
    segment.off_way = held.piece.off_way;
    segment.deviation_mm = part.curved && ends_piece(held, span.to_s) ? held.piece.deviation_mm : 0;
}

}  // namespace gsim::motion::linuxcnc
