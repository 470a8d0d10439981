#pragma once

#include <array>

#include <tl/expected.hpp>

#include "controller/services/types.h"
#include "motion/kinematics/kinematics.h"
#include "motion/path/arc.h"

namespace gsim::motion {

/// Values of the two joints of a head, in rad.
struct HeadAngles {
    double turn = 0;
    double tilt = 0;
};

/// Joints of a head at a position of an orientation arc, and their derivatives by the angle along it.
struct HeadState {
    HeadAngles angles;
    HeadAngles first;
    HeadAngles second;
};

/// Bounds of the derivatives of the joints by the angle along the arc, up or down, valid everywhere on it.
struct HeadBounds {
    HeadAngles first;
    HeadAngles second;
    HeadAngles third;
};

/// Reason why no orientation arc leads to a target.
enum class OrientationError {
    opposite,            ///< The directions are opposite: no great circle is the only one.
    same,                ///< The direction is the same, but the joints would turn.
    at_pole,             ///< The tool is at the pole, at one end, and the turning joint would turn.
    different_solution,  ///< The joints, without a jump, would end at other values than the target's.
};

/// Path of the two joints of a kinematics::TiltingHead on which the tool direction moves along the shorter
/// great circle between two directions.
///
/// S is the sine of the tilt from the pole, h the heading on the sphere (0: the tilt grows) and w the angle
/// along the circle. Clairaut's relation S sin h = L holds all along it. So d(turn)/dw = L / S^2 and
/// d(tilt)/dw = cos h, and further derivatives follow from these. A circle through the pole (L = 0) is a
/// meridian: the turning joint is at standstill, and the tilt passes through 0 and changes its sign.
class OrientationArc {
  public:
    /// Returns the arc from `start` to `end`, which may differ from the end of the circle by the rounding of
    /// kinematics. The difference is shared out, so that both ends are exact. Circles that pass the pole
    /// within 1e-9 rad count as meridians. The directions must differ by more than 1e-9 rad.
    static tl::expected<OrientationArc, OrientationError> between(const kinematics::TiltingHead& head,
                                                                  const rrs::JointPos& start,
                                                                  const rrs::JointPos& end);

    int turn_joint() const { return head_.turn_joint; }
    int tilt_joint() const { return head_.tilt_joint; }
    bool moves(int joint) const { return joint == head_.turn_joint || joint == head_.tilt_joint; }
    /// Returns the angle between the directions at both ends.
    double length_rad() const { return length_rad_; }
    /// Returns the state at the angle `angle_rad` from the start.
    HeadState at(double angle_rad) const;
    HeadBounds bounds() const;
    /// Returns the lowest and highest tilt (of the joint) on the path. The turning joint turns in only one
    /// direction.
    Range tilt_range() const;
    /// Returns the part of the arc between two angles.
    OrientationArc part(double from_rad, double to_rad) const;
    /// Returns the values from which at() is computed, so that it can be computed elsewhere: the angles of
    /// turn and tilt at the anchor, the tilt from the pole there, its sine and cosine, sine and cosine of the
    /// heading, the side, Clairaut's constant, the drifts of turn and tilt, the start of this part, and its
    /// length (rad).
    std::array<double, 13> constants() const {
        return {anchor_.turn,         anchor_.tilt,    tilt_,      sine_,     cosine_,
                heading_sine_,        heading_cosine_, tilt_sign_, clairaut_, rounding_drift_.turn,
                rounding_drift_.tilt, from_rad_,       length_rad_};
    }

  private:
    /// Direction at a position: sine (signed as the tilt) and cosine of the tilt from the pole, and the slope
    /// of the cosine.
    struct Direction {
        double across;   // horizontal part, along the azimuth of the anchor and
        double lateral;  // at right angles to it
        double sine;
        double cosine;
        double cosine_slope;
    };
    /// Smallest and largest |sine of the tilt| on the path.
    struct SineRange {
        double min;
        double max;
    };

    OrientationArc() = default;
    bool is_meridian() const { return clairaut_ == 0; }
    Direction direction(double from_anchor_rad) const;
    HeadAngles angles(double from_anchor_rad, const Direction& direction) const;
    bool passes_apex(const Direction& start, const Direction& end) const;
    SineRange sine_range() const;

    kinematics::TiltingHead head_;
    HeadAngles anchor_;  // joint values where the arc was begun
    double tilt_ = 0;    // from the pole there
    double sine_ = 0;    // of it
    double cosine_ = 1;
    double heading_sine_ = 0;
    double heading_cosine_ = 1;
    double tilt_sign_ = 1;       // sign of the sine of the tilt
    double clairaut_ = 0;        // L
    HeadAngles rounding_drift_;  // rounding to be made up for, by angle
    double from_rad_ = 0;        // of this part
    double length_rad_ = 0;
};

}  // namespace gsim::motion
