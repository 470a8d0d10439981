#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Adjusts upright points. If the jet is upright, any turn about the vertical is possible. A machine with an
/// axis for it would leave the point with the wrong one. So an upright point next to tilted ones gets a
/// minimal tilt in their direction (kHair_deg). If it needs two directions it becomes two points, and the
/// machine turns at a fixed position.
void settle_upright(std::vector<JetPoint>& points);

inline constexpr double kHair_deg = 0.005;

/// Returns the direction of an axis tilt, about the vertical; `lean_rad` its tilt from there.
double azimuth_rad(const Vector& axis);
double lean_rad(const Vector& axis);
Vector axis_of(double azimuth_rad, double lean_rad);

}  // namespace gsim::surface
