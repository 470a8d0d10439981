#pragma once

#include <cstddef>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/held_piece.h"
#include "motion/planner/motion_model.h"

namespace gsim::motion::linuxcnc {

/// Writer of timed sub-segments as segments. Two motions at the same time are written as a segment of both.
class Writer {
  public:
    Writer(const Axes& axes, SegmentOutput& output) : axes_(axes), output_(output) {}

    /// Outputs what it can of the first `ready` sub-segments, removes those that are done from the queue, and
    /// returns their number. The end of a group that is shared waits for the sub-segments that share it,
    /// unless the queue `ended`.
    std::size_t write(PieceQueue& queue, std::size_t ready, bool ended);

  private:
    // Times of a sub-segment between which it moves along one line or arc.
    struct Span {
        HeldPiece* held;
        double from_s;
        double to_s;
        const HeldPiece* next;  ///< The sub-segment after it, if any.
    };

    // Writes the front sub-segment. Returns true if it is done.
    bool write_front(PieceQueue& queue, std::size_t ready, bool ended);
    void write_alone(PieceQueue& queue, double until_s);
    void write_shared(PieceQueue& queue, std::size_t head_index, const rrs::JointPos& corner);
    void write_to_rest(PieceQueue& queue, std::size_t standing_index, const rrs::JointPos& corner);
    void put(const Span& span);
    void put_both(const Span& tail, const Span& head, const rrs::JointPos& corner);
    void fill(const Span& span, Segment& segment) const;

    const Axes& axes_;
    SegmentOutput& output_;
};

}  // namespace gsim::motion::linuxcnc
