#include "geometry/planar/edge.h"

namespace gsim::geometry {

namespace {

Point turned(Point v, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

Point chord(const Edge& edge) {
    return edge.end - edge.start;
}

// Returns the angle from the start to the direction of a point, in the sense of the arc: -pi to pi about its
// middle.
double angle_along(const Edge& edge, Point middle, Point point) {
    const Point from = edge.start - middle;
    const Point to = point - middle;
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return edge.bulge > 0 ? angle : -angle;
}

bool is_in_sector(const Edge& edge, Point middle, Point point) {
    const double sense = edge.bulge > 0 ? 1 : -1;
    const Point to = point - middle;
    return sense * cross(edge.start - middle, to) >= 0 && sense * cross(to, edge.end - middle) >= 0;
}

}  // namespace

Point center(const Edge& edge) {
    const double b = edge.bulge;
    const Point middle = 0.5 * (edge.start + edge.end);
    return middle + ((1 - b * b) / (4 * b)) * left_normal(chord(edge));
}

double radius_mm(const Edge& edge) {
    const double b = std::abs(edge.bulge);
    return length(chord(edge)) * (1 + b * b) / (4 * b);
}

double length_mm(const Edge& edge) {
    return is_arc(edge) ? radius_mm(edge) * std::abs(sweep_rad(edge)) : length(chord(edge));
}

Point start_tangent(const Edge& edge) {
    const Point along = unit(chord(edge));
    return is_arc(edge) ? turned(along, -sweep_rad(edge) / 2) : along;
}

Point end_tangent(const Edge& edge) {
    const Point along = unit(chord(edge));
    return is_arc(edge) ? turned(along, sweep_rad(edge) / 2) : along;
}

Point point_at(const Edge& edge, double share) {
    if (share <= 0) return edge.start;
    if (share >= 1) return edge.end;
    if (!is_arc(edge)) return edge.start + share * chord(edge);
    const Point middle = center(edge);
    return middle + turned(edge.start - middle, share * sweep_rad(edge));
}

double share_at(const Edge& edge, Point edge_point) {
    if (!is_arc(edge)) {
        const Point along = chord(edge);
        return std::clamp(dot(edge_point - edge.start, along) / dot(along, along), 0.0, 1.0);
    }
    const double share = angle_along(edge, center(edge), edge_point) / std::abs(sweep_rad(edge));
    // The end of half a turn may be computed as minus half a turn.
    if (share < -0.5) return 1;
    return std::clamp(share, 0.0, 1.0);
}

Edge sub_edge(const Edge& edge, double from, double to) {
    const double bulge = is_arc(edge) ? std::tan(sweep_rad(edge) * (to - from) / 4) : 0;
    return {point_at(edge, from), point_at(edge, to), bulge};
}

Edge reversed(const Edge& edge) {
    return {edge.end, edge.start, -edge.bulge};
}

Box bounding_box(const Edge& edge) {
    Box box;
    box.add(edge.start);
    box.add(edge.end);
    if (!is_arc(edge)) return box;
    const Point middle = center(edge);
    const double r = radius_mm(edge);
    for (const Point axis : {Point{r, 0}, Point{0, r}, Point{-r, 0}, Point{0, -r}}) {
        if (is_in_sector(edge, middle, middle + axis)) box.add(middle + axis);
    }
    return box;
}

double distance_mm(const Edge& edge, Point point) {
    if (is_arc(edge)) {
        const Point middle = center(edge);
        if (is_in_sector(edge, middle, point)) return std::abs(distance(middle, point) - radius_mm(edge));
        return std::min(distance(edge.start, point), distance(edge.end, point));
    }
    const Point along = chord(edge);
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(point - edge.start, along) / square, 0.0, 1.0) : 0;
    return distance(edge.start + share * along, point);
}

bool within(const Edge& edge, Point curve_point) {
    if (distance(edge.start, curve_point) <= kPointTolerance_mm) return true;
    if (distance(edge.end, curve_point) <= kPointTolerance_mm) return true;
    if (is_arc(edge)) return is_in_sector(edge, center(edge), curve_point);
    const double along = dot(curve_point - edge.start, chord(edge));
    return along >= 0 && along <= dot(chord(edge), chord(edge));
}

double circular_segment_area_mm2(const Edge& edge) {
    if (!is_arc(edge)) return 0;
    const double r = radius_mm(edge);
    const double angle = sweep_rad(edge);
    // angle - sin(angle) loses its digits if the angle is small.
    const double a2 = angle * angle;
    const double difference =
        std::abs(angle) < 1e-2 ? angle * a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42)) : angle - std::sin(angle);
    return r * r / 2 * difference;
}

double swept_area_mm2(const Edge& edge) {
    return cross(edge.start, edge.end) / 2 + circular_segment_area_mm2(edge);
}

Edge arc_from_tangent(Point start, Point tangent, Point end) {
    const Point to_end = end - start;
    const double half_sweep = std::atan2(cross(tangent, to_end), dot(tangent, to_end));
    return {start, end, std::tan(half_sweep / 2)};
}

}  // namespace gsim::geometry
