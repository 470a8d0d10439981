#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Where the jet stands upright any turn about the vertical will do, and a machine with an axis for it would
/// come out of there with the wrong one. So an upright point beside leaning ones leans by a hair to where
/// they lean (kHair_deg); where it has to be two ways it becomes two points, and the machine turns on the
/// spot.
void settle_upright(std::vector<JetPoint>& points);

inline constexpr double kHair_deg = 0.005;

/// To where an axis leans, about the vertical; its lean from there.
double azimuth_rad(const Vector& axis);
double lean_rad(const Vector& axis);
Vector axis_of(double azimuth_rad, double lean_rad);

}  // namespace gsim::surface
