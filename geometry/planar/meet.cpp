#include "geometry/planar/meet.h"

namespace gsim::geometry {

namespace {

void add_if_within(const Edge& a, const Edge& b, Point point, Meets& found) {
    if (within(a, point) && within(b, point)) found.add(point);
}

void meet_lines(const Edge& a, const Edge& b, Meets& found) {
    const Point u = a.end - a.start;
    const Point v = b.end - b.start;
    const double scale = cross(u, v);
    // Parallel lines meet only at ends, and those are checked for all edges.
    if (std::abs(scale) <= 1e-14 * length(u) * length(v)) return;
    add_if_within(a, b, a.start + (cross(b.start - a.start, v) / scale) * u, found);
}

void meet_line_arc(const Edge& line, const Edge& arc, Meets& found) {
    const Point middle = center(arc);
    const double r = radius_mm(arc);
    const Point along = unit(line.end - line.start);
    const double foot = dot(middle - line.start, along);
    const Point nearest = line.start + foot * along;
    const double height = distance(middle, nearest);
    if (height > r + kSamePoint_mm) return;
    if (height >= r) {
        add_if_within(line, arc, nearest, found);
        return;
    }
    const double half = std::sqrt((r - height) * (r + height));
    add_if_within(line, arc, nearest + half * along, found);
    add_if_within(line, arc, nearest - half * along, found);
}

void meet_arcs(const Edge& a, const Edge& b, Meets& found) {
    const Point middle = center(a);
    const Point between = center(b) - middle;
    const double apart = length(between);
    const double ra = radius_mm(a);
    const double rb = radius_mm(b);
    if (apart <= kSamePoint_mm) return;  // of one circle: ends alone
    if (apart > ra + rb + kSamePoint_mm || apart < std::abs(ra - rb) - kSamePoint_mm) return;
    const Point along = (1 / apart) * between;
    const double foot = (apart + (ra - rb) * (ra + rb) / apart) / 2;
    const double square = (ra - foot) * (ra + foot);
    if (square <= 0) {
        add_if_within(a, b, middle + std::copysign(ra, foot) * along, found);
        return;
    }
    const Point up = std::sqrt(square) * left_of(along);
    add_if_within(a, b, middle + foot * along + up, found);
    add_if_within(a, b, middle + foot * along - up, found);
}

}  // namespace

void Meets::add(Point point) {
    for (const Point& known : *this) {
        if (distance(known, point) <= kSamePoint_mm) return;
    }
    if (count < points.size()) points[count++] = point;
}

Meets meets(const Edge& a, const Edge& b) {
    Meets found;
    for (const Point end : {a.start, a.end}) {
        if (distance_mm(b, end) <= kSamePoint_mm) found.add(end);
    }
    for (const Point end : {b.start, b.end}) {
        if (distance_mm(a, end) <= kSamePoint_mm) found.add(end);
    }
    if (is_arc(a) && is_arc(b)) {
        meet_arcs(a, b, found);
    } else if (is_arc(b)) {
        meet_line_arc(a, b, found);
    } else if (is_arc(a)) {
        meet_line_arc(b, a, found);
    } else {
        meet_lines(a, b, found);
    }
    return found;
}

}  // namespace gsim::geometry
