#include "geometry/planar/intersection.h"

namespace gsim::geometry {

namespace {

void add_if_within(const Edge& a, const Edge& b, Point point, Intersections& found) {
    if (within(a, point) && within(b, point)) found.add(point);
}

void intersect_lines(const Edge& a, const Edge& b, Intersections& found) {
    const Point u = a.end - a.start;
    const Point v = b.end - b.start;
    const double scale = cross(u, v);
    // Parallel lines meet only at ends, and those are checked for all edges.
    if (std::abs(scale) <= 1e-14 * length(u) * length(v)) return;
    add_if_within(a, b, a.start + (cross(b.start - a.start, v) / scale) * u, found);
}

void intersect_line_arc(const Edge& line, const Edge& arc, Intersections& found) {
    const Point middle = center(arc);
    const double r = radius_mm(arc);
    const Point direction = unit(line.end - line.start);
    const double foot = dot(middle - line.start, direction);
    const Point nearest = line.start + foot * direction;
    const double height = distance(middle, nearest);
    if (height > r + kPointTolerance_mm) return;
    if (height >= r) {
        add_if_within(line, arc, nearest, found);
        return;
    }
    const double half = std::sqrt((r - height) * (r + height));
    add_if_within(line, arc, nearest + half * direction, found);
    add_if_within(line, arc, nearest - half * direction, found);
}

void intersect_arcs(const Edge& a, const Edge& b, Intersections& found) {
    const Point middle = center(a);
    const Point between = center(b) - middle;
    const double center_distance = length(between);
    const double ra = radius_mm(a);
    const double rb = radius_mm(b);
    if (center_distance <= kPointTolerance_mm) return;  // of one circle: ends alone
    if (center_distance > ra + rb + kPointTolerance_mm ||
        center_distance < std::abs(ra - rb) - kPointTolerance_mm)
        return;
    const Point direction = (1 / center_distance) * between;
    const double foot = (center_distance + (ra - rb) * (ra + rb) / center_distance) / 2;
    const double square = (ra - foot) * (ra + foot);
    if (square <= 0) {
        add_if_within(a, b, middle + std::copysign(ra, foot) * direction, found);
        return;
    }
    const Point up = std::sqrt(square) * left_normal(direction);
    add_if_within(a, b, middle + foot * direction + up, found);
    add_if_within(a, b, middle + foot * direction - up, found);
}

}  // namespace

void Intersections::add(Point point) {
    for (const Point& known : *this) {
        if (distance(known, point) <= kPointTolerance_mm) return;
    }
    if (count < points.size()) points[count++] = point;
}

Intersections intersections(const Edge& a, const Edge& b) {
    Intersections found;
    for (const Point end : {a.start, a.end}) {
        if (distance_mm(b, end) <= kPointTolerance_mm) found.add(end);
    }
    for (const Point end : {b.start, b.end}) {
        if (distance_mm(a, end) <= kPointTolerance_mm) found.add(end);
    }
    if (is_arc(a) && is_arc(b)) {
        intersect_arcs(a, b, found);
    } else if (is_arc(b)) {
        intersect_line_arc(a, b, found);
    } else if (is_arc(a)) {
        intersect_line_arc(b, a, found);
    } else {
        intersect_lines(a, b, found);
    }
    return found;
}

}  // namespace gsim::geometry
