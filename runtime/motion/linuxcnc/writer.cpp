#include "runtime/motion/linuxcnc/writer.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "runtime/motion/linuxcnc/way.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kNoTime_s = 1e-12;  // rounding of times that are cut out of others

bool done(const HeldPiece& held) {
    return held.left_s() <= kNoTime_s;
}

// The end of the part of the way on which the piece is at `from_s`.
double part_end_s(const HeldPiece& held, double from_s) {
    if (held.piece.lead_in > 0) {
        const double lead_in_s = held.law.time_at(held.piece.lead_in);
        if (from_s < lead_in_s - kNoTime_s) return lead_in_s;
    }
    return held.law.duration_s();
}

// The piece at an instant near to one of its ends or to the end of its lead-in is there.
double way_at(const HeldPiece& held, double t_s) {
    const double end_s = held.law.duration_s();
    if (t_s <= 0) return 0;
    if (t_s >= end_s - kNoTime_s) return held.piece.length;
    if (held.piece.lead_in > 0 && std::abs(t_s - held.law.time_at(held.piece.lead_in)) <= kNoTime_s) {
        return held.piece.lead_in;
    }
    return std::min(held.law.at(t_s), held.piece.length);
}

// The piece of the next group that moves while the front one comes to rest.
struct Partner {
    HeldPiece* head = nullptr;              // none: not timed yet
    const rrs::JointPos* corner = nullptr;  // where that group starts
    bool at_rest = false;                   // the whole group has been put out
};

Partner partner(PieceQueue& queue, std::size_t ready) {
    std::size_t last = 0;
    while (last < ready && !queue[last].ends_group) ++last;
    for (std::size_t index = last + 1; index < ready; ++index) {
        if (!done(queue[index])) return {&queue[index], &queue[last].piece.end, false};
        if (queue[index].ends_group) return {.at_rest = true};
    }
    return {};
}

// A blend arc is the later move's; the line on which it begins is the earlier one's.
rrs::TargetId target_of(const HeldPiece& held, double to_s) {
    const Piece& piece = held.piece;
    const bool leads_in = piece.lead_in > 0 && way_at(held, to_s) <= piece.lead_in;
    return leads_in ? piece.lead_in_id : piece.target_id;
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
    HeldPiece& held = queue.front();
    write_alone(held, held.law.duration_s() - held.shared_s);
    while (!done(held)) {
        const Partner next = partner(queue, ready);
        if (next.head != nullptr) {
            write_shared(held, *next.head, *next.corner);
        } else if (next.at_rest || ended) {
            write_alone(held, held.law.duration_s());
        } else {
            return false;
        }
    }
    return true;
}

void Writer::write_alone(HeldPiece& held, double until_s) {
    while (held.written_s < until_s - kNoTime_s) {
        const double to_s = std::min(until_s, part_end_s(held, held.written_s));
        put({&held, held.written_s, to_s});
        held.written_s = to_s;
    }
}

void Writer::write_shared(HeldPiece& tail, HeldPiece& head, const rrs::JointPos& corner) {
    while (!done(head) && !done(tail)) {
        const double tail_s = part_end_s(tail, tail.written_s) - tail.written_s;
        const double head_s = part_end_s(head, head.written_s) - head.written_s;
        const double step_s = std::min(tail_s, head_s);
        put_both({&tail, tail.written_s, tail.written_s + step_s},
                 {&head, head.written_s, head.written_s + step_s}, corner);
        tail.written_s += step_s;
        head.written_s += step_s;
    }
}

void Writer::put(const Span& span) {
    fill(span, output_.begin(target_of(*span.held, span.to_s)));
    output_.finish();
}

// The earlier motion carries the later one, which has moved on since it started at the corner.
void Writer::put_both(const Span& tail, const Span& head, const rrs::JointPos& corner) {
    const rrs::TargetId id = target_of(*head.held, head.to_s);
    Segment& segment = output_.begin(id);
    fill(tail, segment);
    auto beside = std::make_shared<Segment>();
    beside->target_id = id;
    beside->start_s = segment.start_s;
    beside->position_joints = segment.position_joints;
    fill(head, *beside);
    const rrs::JointPos moved = beside->start - corner;
    segment.start += moved;
    segment.end += moved;
    if (segment.kind == SegmentKind::circular) segment.arc.center += axes_.point(moved);
    segment.beside = std::move(beside);
    segment.length_mm = segment.blended_length_mm();
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
    segment.limited_by = held.limited_by;
}

}  // namespace gsim::motion::linuxcnc
