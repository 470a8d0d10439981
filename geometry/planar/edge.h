#pragma once

#include <numbers>

#include "geometry/planar/point.h"

namespace gsim::geometry {

/// Distance in mm below which two points of a drawing are one.
inline constexpr double kPointTolerance_mm = 1e-7;

/// A straight line or an arc of a circle. `bulge` is the tangent of a quarter of the arc's angle, above 0
/// counter-clockwise, as in DXF. Arcs have at most half a turn: |bulge| <= 1.
struct Edge {
    Point start, end;
    double bulge = 0;
};

/// Bulge below which an edge is straight: a chord of 1 m has a height of 0.05 um.
inline constexpr double kStraightBulge = 1e-7;

inline bool is_arc(const Edge& edge) {
    return std::abs(edge.bulge) > kStraightBulge;
}
/// Returns the angle of the arc, counter-clockwise above 0.
inline double sweep_rad(const Edge& edge) {
    return is_arc(edge) ? 4 * std::atan(edge.bulge) : 0;
}
/// Returns the center of an arc.
Point center(const Edge& edge);
double radius_mm(const Edge& edge);
double length_mm(const Edge& edge);
/// Returns the direction of travel, of length 1.
Point start_tangent(const Edge& edge);
Point end_tangent(const Edge& edge);
/// Returns the point at a share of the length, 0 to 1.
Point point_at(const Edge& edge, double share);
/// Returns the share of the length at which the edge passes a point that is on it.
double share_at(const Edge& edge, Point edge_point);
/// Returns the part between two shares.
Edge sub_edge(const Edge& edge, double from, double to);
Edge reversed(const Edge& edge);
Box bounding_box(const Edge& edge);
/// Returns the distance from a point to the nearest point of the edge.
double distance_mm(const Edge& edge, Point point);
/// True if a point on the line or circle of the edge belongs to the edge itself.
bool within(const Edge& edge, Point curve_point);
/// Returns the integral of x dy - y dx along the edge, halved. The area of a closed ring of edges is the sum
/// of these (Green's theorem), counter-clockwise above 0.
double swept_area_mm2(const Edge& edge);
/// Returns the area between an arc and its chord: a segment of a circle, above 0 counter-clockwise.
double circular_segment_area_mm2(const Edge& edge);
/// Returns the arc of at most half a turn that leaves `start` along `tangent` and ends at `end`.
Edge arc_from_tangent(Point start, Point tangent, Point end);

}  // namespace gsim::geometry
