#pragma once

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// What a jet along a wall may take of its lower edge, in mm, before it leaves the wall's lines for that.
inline constexpr double kMayTake_mm = 0.02;

/// The part of a direction across another one, of length 1.
Vector across(const Vector& direction, const Vector& axis);

/// Leads the axis beside the upper and the lower edge of a wall, half of the jet's width off both, where the
/// normals of the wall are `at.aside` and `at.low_aside` at first. They are another where the wall is
/// twisted; the axis then is no line of the wall.
void touch_both(JetPoint& at, const JetShape& jet);

/// The same where a jet along the wall, as `at` is, would take more than hundredths of its lower edge. So it
/// comes upright where walls do, and rotary axes need not turn for less.
void touch_twisted(JetPoint& at, const JetShape& jet);

/// Leads the lower end of the jet through a place, its upper end beside the edge as before.
void aim_low(JetPoint& at, const Vector& low_middle_mm, const JetShape& jet);

}  // namespace gsim::surface
