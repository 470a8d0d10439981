#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Adjusts upright points. If the jet is upright, any turn about the vertical is possible. A machine with an
/// axis for it would leave the point with the wrong one. So an upright point next to tilted ones gets a
/// minimal tilt in their direction (kSingularityTilt_deg). If it needs two directions it becomes two points,
/// and the machine turns at a fixed position.
void split_vertical_points(std::vector<JetPoint>& points);

inline constexpr double kSingularityTilt_deg = 0.005;

/// Returns the direction of an axis tilt, about the vertical; `tilt_rad` its tilt from there.
double azimuth_rad(const Vector& axis);
double tilt_rad(const Vector& axis);
Vector axis_direction(double azimuth_rad, double tilt_rad);

}  // namespace gsim::surface
