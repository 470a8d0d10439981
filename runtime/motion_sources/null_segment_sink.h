#pragma once

#include "motion/segment/segment.h"

namespace gsim::simulation {

/// Sink for a planner in a comparison with a run: only the time counts, not its segments.
class NullSegmentSink final : public motion::SegmentSink {
  public:
    void on_segment(const motion::Segment& /*segment*/) override {}
};

}  // namespace gsim::simulation
