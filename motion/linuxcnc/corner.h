#pragma once

#include <Eigen/Core>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Corner between two sub-segments in X, Y, Z.
struct Corner {
    Eigen::Vector3d point;
    Eigen::Vector3d in;   ///< Unit tangent of the path to the corner.
    Eigen::Vector3d out;  ///< Unit tangent of the path from it.
    /// Unit normal of the plane of both, about which the path turns counter-clockwise; 0 if undefined.
    Eigen::Vector3d normal;
    double half_angle_rad;  ///< Half of the angle between the two legs: pi/2 if the path continues straight.
};

Corner corner_between(const SubSegment& before, const SubSegment& after, const Axes& axes);

/// Leg of a corner as a blend arc uses it.
struct Leg {
    bool curved = false;
    /// Unit vector of travel that counts for the blend: the tangent, or the chord of an arc that curves in
    /// the sense of the corner.
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double half_angle_rad = 0;                         ///< Half angle of the corner for this leg.
    double available_mm = 0;                           ///< Length that the blend may use.
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Centre of an arc, in the plane of the corner.
    double radius_mm = 0;
    bool turns_with_corner = false;  ///< The arc turns as the corner does: the blend lies within its circle.
    double available_rad = 0;        ///< Angle of the arc that the blend may use.
};

Leg leg_before(const SubSegment& sub_segment, const Corner& corner);
Leg leg_after(const SubSegment& sub_segment, const Corner& corner);

}  // namespace gsim::motion::linuxcnc
