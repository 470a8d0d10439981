#pragma once

#include <Eigen/Core>
#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/corner.h"
#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Speeds of a blend arc and the radius at which they are possible.
struct BlendSpeeds {
    double half_angle_rad = 0;  ///< Half of the angle between the legs.
    double tolerance_mm = 0;    ///< Max distance of the arc from the corner.
    double acceleration = 0;
    double requested_speed = 0;
    double speed = 0;
    double radius_mm = 0;
};

/// A circle that touches both legs of a corner.
struct BlendCircle {
    Eigen::Vector3d center;
    double cut_before = 0;  ///< Off the end of the leg before: mm of a line, rad of an arc.
    double cut_after = 0;   ///< Off the beginning of the next leg.
};

/// Returns speed and radius within the lengths and tolerances of both legs, or nullopt if they form no
/// corner.
std::optional<BlendSpeeds> blend_speeds(const SubSegment& before, const SubSegment& after,
                                        const Corner& corner, const Leg& leg_before, const Leg& leg_after,
                                        const Axes& axes);

/// Returns the position of the circle, or nullopt if none fits.
std::optional<BlendCircle> blend_circle(const Corner& corner, const Leg& before, const Leg& after,
                                        const BlendSpeeds& speeds);

}  // namespace gsim::motion::linuxcnc
