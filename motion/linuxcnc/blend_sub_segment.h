#pragma once

#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/blend_arc.h"
#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Blend arc that could be inserted between two sub-segments.
struct Blend {
    SubSegment sub_segment;
    double cut_before = 0;  ///< As in BlendCircle.
    double cut_after = 0;
    bool absorbs_previous_line =
        false;  ///< True if the remainder of the previous line is so short that the blend takes it.
};

/// Returns the blend arc between two sub-segments that move only X, Y and Z, or nullopt if none fits.
std::optional<Blend> blend_between(const SubSegment& before, const SubSegment& after, const Corner& corner,
                                   const Axes& axes, const PlanningRules& planning);

/// Cuts off both sub-segments what the blend uses.
void trim_for_blend(const Blend& blend, const Axes& axes, SubSegment& before, SubSegment& after);

}  // namespace gsim::motion::linuxcnc
