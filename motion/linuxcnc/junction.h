#pragma once

#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/blend_sub_segment.h"
#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Rules for junctions, in addition to the sub-segments.
struct JoinRules {
    PlanningRules planning;
    bool stop_between_rapid_and_feed = true;
    double max_share = 1;  ///< Share of the programmed speed that the operator could set at most.
};

/// Decides how `before` ends and how `after` starts: sets the terms and tangent discontinuities of both
/// sub-segments. Returns the blend arc to insert between them, if any; both have then been cut.
std::optional<Blend> join(SubSegment& before, SubSegment& after, const Axes& axes, const JoinRules& rules);

}  // namespace gsim::motion::linuxcnc
