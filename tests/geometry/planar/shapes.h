#pragma once

#include <random>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

Contour polygon(const std::vector<Point>& corners);
/// Counter-clockwise, of two arcs.
Contour circle(Point center, double radius_mm);
Contour rectangle(Point low, Point high);
/// Counter-clockwise about the origin, without crossings: corners at growing angles, their distances between
/// the two radii, each edge an arc with that chance (lines and arcs meet at corners at any angle).
Contour star(std::mt19937& random, int corners, double inner_mm, double outer_mm, double arcs);
/// Returns points along the contour, none farther off it than `tolerance_mm`.
std::vector<Point> flattened(const Contour& contour, double tolerance_mm);

}  // namespace gsim::geometry
