#pragma once

#include "motion/segment/segment.h"

namespace gsim::simulation {

/// For a planner beside a run: its segments are of no interest, only the time.
class TimeAlone final : public motion::SegmentSink {
  public:
    void take(const motion::Segment& /*segment*/) override {}
};

}  // namespace gsim::simulation
