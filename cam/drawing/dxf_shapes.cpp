#include "cam/drawing/dxf_shapes.h"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/drawing/fit_spline.h"

namespace gsim::drawing {

using geometry::Point;

namespace {

constexpr double kFlatTolerance = 1e-6;

double radians(double degrees) {
    return degrees * kRadPerDeg;
}

[[noreturn]] void fail(const GroupList& entity, const std::string& message) {
    const std::string_view handle = entity.text(5).value_or("");
    throw error_at(entity.line(),
                   fmt::format("{}{}{} {}", entity.kind(), handle.empty() ? "" : " ", handle, message));
}

// Returns the counter-clockwise angle from one to the other, above 0 and at most a full turn.
double turn_between(double from_rad, double to_rad) {
    const double turn = std::fmod(to_rad - from_rad, 2 * std::numbers::pi);
    return turn <= 1e-12 ? turn + 2 * std::numbers::pi : turn;
}

double circle_radius(const GroupList& entity) {
    const double radius = entity.number(40);
    if (!(radius > 0)) fail(entity, fmt::format("has the radius {}; it must be greater than 0", radius));
    return radius;
}

void draw_line_entity(const GroupList& entity, Pen& pen) {
    const Point from = entity.point(10);
    const Point to = entity.point(11);
    const double rise = entity.number(31, 0) - entity.number(30, 0);
    if (std::abs(rise) > kFlatTolerance)
        fail(entity, fmt::format("rises by {} in z; a drawing must be flat", rise));
    if (from == to) fail(entity, fmt::format("at ({}, {}) has no length", from.x, from.y));
    pen.move_to(from);
    pen.line_to(to);
}

void draw_circle_or_arc(const GroupList& entity, Pen& pen) {
    const Point center = entity.point(10);
    const double r = circle_radius(entity);
    EllipseArc arc{center, {r, 0}, {0, r}, 0, 2 * std::numbers::pi};
    if (entity.kind() == "ARC") {
        arc.from_rad = radians(entity.number(50));
        arc.sweep_rad = turn_between(arc.from_rad, radians(entity.number(51)));
    }
    pen.arc(arc);
}

void draw_ellipse_entity(const GroupList& entity, Pen& pen) {
    const Point u = entity.point(11);
    const double ratio = entity.number(40);
    if (u == Point{} || ratio == 0) fail(entity, "has an axis without a length");
    if (std::abs(entity.number(31, 0)) > kFlatTolerance) fail(entity, "is not level; a drawing must be flat");
    const double up = entity.number(230, 1) < 0 ? -1 : 1;
    const double from = entity.number(41, 0);
    const double to = entity.number(42, 2 * std::numbers::pi);
    pen.arc({entity.point(10), u, (up * ratio) * left_normal(u), from, turn_between(from, to)});
}

struct Corner {
    Point position;
    double bulge = 0;
};

void draw_vertices(const GroupList& entity, const std::vector<Corner>& corners, bool closed, Pen& pen) {
    if (corners.size() < 2)
        fail(entity, fmt::format("has {} corners; at least 2 are required", corners.size()));
    pen.move_to(corners.front().position);
    bool moves = false;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
        const Point to = corners[(i + 1) % corners.size()].position;
        moves = moves || to != corners[i].position;
        pen.bulge_to(to, corners[i].bulge);
    }
    if (!moves) {
        const Point at = corners.front().position;
        fail(entity, fmt::format("at ({}, {}) has no length", at.x, at.y));
    }
}

void draw_lwpolyline(const GroupList& entity, Pen& pen) {
    std::vector<Corner> corners;
    for (const Group& group : entity.groups()) {
        if (group.code == 10) corners.push_back({{parse_number(group), 0}, 0});
        if (corners.empty()) continue;
        if (group.code == 20) corners.back().position.y = parse_number(group);
        if (group.code == 42) corners.back().bulge = parse_number(group);
    }
    const int count = entity.integer_or(90, static_cast<int>(corners.size()));
    if (count != static_cast<int>(corners.size())) {
        fail(entity, fmt::format("specifies {} corners, but has {}", count, corners.size()));
    }
    draw_vertices(entity, corners, (entity.integer_or(70, 0) & 1) != 0, pen);
}

void draw_fitted(const GroupList& entity, Pen& pen) {
    std::vector<Point> points;
    for (const Group& group : entity.groups()) {
        if (group.code == 11) points.push_back({parse_number(group), 0});
        if (group.code == 21 && !points.empty()) points.back().y = parse_number(group);
    }
    SplineEnds ends;
    ends.closed = (entity.integer_or(70, 0) & 1) != 0;
    const auto read_direction = [&entity](int code) -> std::optional<Point> {
        const Point direction{entity.number(code, 0), entity.number(code + 10, 0)};
        if (direction == Point{}) return {};
        return direction;
    };
    ends.start_direction = read_direction(12);
    ends.end_direction = read_direction(13);
    const std::vector<Nurbs> splines = interpolating_spline(points, ends);
    if (splines.empty()) fail(entity, fmt::format("has {} fit points, which have no length", points.size()));
    for (const Nurbs& spline : splines) pen.nurbs(spline);
}

// Draws a spline from its control points, or from points on the curve alone.
void draw_spline(const GroupList& entity, Pen& pen) {
    Nurbs curve;
    const int degree = entity.integer_or(71, 3);
    curve.degree = degree > 0 ? static_cast<std::size_t>(degree) : 0;
    bool has_fit_points = false;
    for (const Group& group : entity.groups()) {
        if (group.code == 40) curve.knots.push_back(parse_number(group));
        if (group.code == 41) curve.weights.push_back(parse_number(group));
        if (group.code == 10) curve.points.push_back({parse_number(group), 0});
        if (group.code == 20 && !curve.points.empty()) curve.points.back().y = parse_number(group);
        has_fit_points = has_fit_points || group.code == 11;
    }
    if (curve.points.empty() && has_fit_points) return draw_fitted(entity, pen);
    if (const auto error = find_curve_error(curve)) fail(entity, error->message);
    pen.nurbs(curve);
}

using Draw = void (*)(const GroupList&, Pen&);

struct DxfShape {
    std::string_view kind;
    Draw draw;
    bool uses_ocs;  // its coordinates are those of its extrusion direction
};

constexpr std::array<DxfShape, 6> kDxfShapes{{{"LINE", draw_line_entity, false},
                                              {"ARC", draw_circle_or_arc, true},
                                              {"CIRCLE", draw_circle_or_arc, true},
                                              {"ELLIPSE", draw_ellipse_entity, false},
                                              {"LWPOLYLINE", draw_lwpolyline, true},
                                              {"SPLINE", draw_spline, false}}};

const DxfShape* find_dxf_shape(std::string_view kind) {
    for (const DxfShape& shape : kDxfShapes) {
        if (shape.kind == kind) return &shape;
    }
    return nullptr;
}

void finish(const GroupList& entity, Pen& pen) {
    if (pen.error()) fail(entity, pen.error()->message);
    pen.lift();
}

}  // namespace

bool is_shape(std::string_view kind) {
    return find_dxf_shape(kind) != nullptr;
}

void draw_shape(const GroupList& entity, const Affine& map, std::uint32_t source, Pen& pen) {
    const DxfShape* shape = find_dxf_shape(entity.kind());
    const Affine plane = ocs_to_wcs(entity);
    pen.set_map(shape->uses_ocs ? map * plane : map, source);
    shape->draw(entity, pen);
    finish(entity, pen);
}

void draw_polyline(const GroupList& entity, const std::vector<GroupList>& vertices, const Affine& map,
                   std::uint32_t source, Pen& pen) {
    constexpr int kClosedFlag = 1;
    constexpr int kMeshFlags = 16 | 64;
    constexpr int kControlPointFlag = 16;
    const int flags = entity.integer_or(70, 0);
    if ((flags & kMeshFlags) != 0) fail(entity, "is a mesh, which has no contour");
    std::vector<Corner> corners;
    corners.reserve(vertices.size());
    for (const GroupList& vertex : vertices) {
        if ((vertex.integer_or(70, 0) & kControlPointFlag) != 0) continue;
        corners.push_back({vertex.point(10), vertex.number(42, 0)});
    }
    pen.set_map(map * ocs_to_wcs(entity), source);
    draw_vertices(entity, corners, (flags & kClosedFlag) != 0, pen);
    finish(entity, pen);
}

Affine ocs_to_wcs(const GroupList& entity) {
    const double x = entity.number(210, 0);
    const double y = entity.number(220, 0);
    const double z = entity.number(230, 1);
    if (std::abs(x) > kFlatTolerance || std::abs(y) > kFlatTolerance || z == 0) {
        fail(entity, fmt::format("is in a plane normal to ({}, {}, {}); a drawing must be flat", x, y, z));
    }
    return scaled(z > 0 ? 1 : -1, 1);
}

}  // namespace gsim::drawing
