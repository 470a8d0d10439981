#pragma once

#include <numbers>

#include "geometry/planar/point.h"

namespace gsim::geometry {

/// Nearer than this, in mm, two points of a drawing are one.
inline constexpr double kSamePoint_mm = 1e-7;

/// A straight line or an arc of a circle. `bulge` is the tangent of a quarter of the arc's angle, above 0
/// counter-clockwise, as in DXF. Arcs go at most half around: |bulge| <= 1.
struct Edge {
    Point start, end;
    double bulge = 0;
};

/// Below this a bulge means nothing: a chord of 1 m has a height of 0.05 um.
inline constexpr double kStraightBulge = 1e-7;

inline bool is_arc(const Edge& edge) {
    return std::abs(edge.bulge) > kStraightBulge;
}
/// The angle gone through, counter-clockwise above 0.
inline double sweep_rad(const Edge& edge) {
    return is_arc(edge) ? 4 * std::atan(edge.bulge) : 0;
}
/// Of an arc.
Point center(const Edge& edge);
double radius_mm(const Edge& edge);
double length_mm(const Edge& edge);
/// Directions of travel, of length 1.
Point start_tangent(const Edge& edge);
Point end_tangent(const Edge& edge);
/// The point at a share of the length, 0 to 1.
Point point_at(const Edge& edge, double share);
/// The share of the length at which the edge passes a point that lies on it.
double share_at(const Edge& edge, Point on_edge);
/// The part between two shares.
Edge part_of(const Edge& edge, double from, double to);
Edge reversed(const Edge& edge);
Box box_of(const Edge& edge);
/// From a point to the nearest point of the edge.
double distance_mm(const Edge& edge, Point point);
/// Whether a point that lies on the line or circle of the edge belongs to the edge itself.
bool within(const Edge& edge, Point on_curve);
/// The integral of x dy - y dx along the edge, halved: a closed ring of edges has their sum as its area
/// (Green's theorem), counter-clockwise above 0.
double swept_area_mm2(const Edge& edge);
/// The area between an arc and its chord: a segment of a circle, above 0 counter-clockwise.
double cap_area_mm2(const Edge& edge);
/// The arc of at most half a turn that leaves `start` along `tangent` and ends at `end`.
Edge arc_from_tangent(Point start, Point tangent, Point end);

}  // namespace gsim::geometry
