#pragma once

#include <cstddef>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/queued_sub_segment.h"
#include "motion/planner/motion_model.h"

namespace gsim::motion::linuxcnc {

/// Writer of timed sub-segments as segments. Two motions at the same time are written as a segment of both.
class Writer {
  public:
    Writer(const Axes& axes, SegmentOutput& output) : axes_(axes), output_(output) {}

    /// Outputs what it can of the first `ready` sub-segments, removes those that are done from the queue, and
    /// returns their number. The end of a group that is shared waits for the sub-segments that share it,
    /// unless the queue `ended`.
    std::size_t write(SubSegmentQueue& queue, std::size_t ready, bool ended);

  private:
    // Times of a sub-segment between which it moves along one line or arc.
    struct Span {
        QueuedSubSegment* queued;
        double from_s;
        double to_s;
        const QueuedSubSegment* next;  ///< The next sub-segment, if any.
    };

    // Writes the front sub-segment. Returns true if it is done.
    bool write_front(SubSegmentQueue& queue, std::size_t ready, bool ended);
    void write_single(SubSegmentQueue& queue, double until_s);
    void write_overlap(SubSegmentQueue& queue, std::size_t head_index, const rrs::JointPos& corner);
    void write_to_standstill(SubSegmentQueue& queue, std::size_t stopped_index, const rrs::JointPos& corner);
    void append_span(const Span& span);
    void write_both(const Span& tail, const Span& head, const rrs::JointPos& corner);
    void fill(const Span& span, Segment& segment) const;

    const Axes& axes_;
    SegmentOutput& output_;
};

}  // namespace gsim::motion::linuxcnc
