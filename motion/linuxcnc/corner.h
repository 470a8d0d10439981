#pragma once

#include <Eigen/Core>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/piece.h"

namespace gsim::motion::linuxcnc {

/// The corner between two pieces in X, Y, Z.
struct Corner {
    Eigen::Vector3d point;
    Eigen::Vector3d in;   ///< Unit tangent of the way to the corner.
    Eigen::Vector3d out;  ///< Unit tangent of the way from it.
    /// Unit normal of the plane of both, about which the way turns counter-clockwise; 0 where there is none.
    Eigen::Vector3d normal;
    double half_angle_rad;  ///< Half of the angle between the two legs: pi/2 where the way goes on straight.
};

Corner corner_between(const Piece& before, const Piece& after, const Axes& axes);

/// One leg of a corner as a blend arc sees it.
struct Leg {
    bool curved = false;
    /// Unit vector of travel that counts for the blend: the tangent, or the chord of an arc that bends along.
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double half_angle_rad = 0;                         ///< Of the corner as this leg makes it.
    double room_mm = 0;                                ///< How much of it the blend may take.
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Of an arc, in the plane of the corner.
    double radius_mm = 0;
    bool bends_along = false;  ///< The arc turns as the corner does: the blend lies within its circle.
    double room_rad = 0;       ///< How much of the arc the blend may take.
};

Leg leg_before(const Piece& piece, const Corner& corner);
Leg leg_after(const Piece& piece, const Corner& corner);

}  // namespace gsim::motion::linuxcnc
