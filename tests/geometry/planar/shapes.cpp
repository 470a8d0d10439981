#include "tests/geometry/planar/shapes.h"

#include "geometry/planar/crossing.h"

namespace gsim::geometry {

Contour polygon(const std::vector<Point>& corners) {
    Contour contour;
    contour.closed = true;
    for (const Point& corner : corners) contour.vertices.push_back({corner, 0, 0});
    return contour;
}

Contour circle(Point center, double radius_mm) {
    Contour contour;
    contour.closed = true;
    contour.vertices = {{center + Point{radius_mm, 0}, 1, 0}, {center - Point{radius_mm, 0}, 1, 0}};
    return contour;
}

Contour rectangle(Point low, Point high) {
    return polygon({low, {high.x, low.y}, high, {low.x, high.y}});
}

Contour star(std::mt19937& random, int corners, double inner_mm, double outer_mm, double arcs) {
    std::uniform_real_distribution<double> radius(inner_mm, outer_mm);
    std::uniform_real_distribution<double> chance(0, 1);
    std::uniform_real_distribution<double> bulge(-0.6, 0.6);
    Contour contour;
    contour.closed = true;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.8 * chance(random)) / corners;
        const Point corner = radius(random) * Point{std::cos(angle), std::sin(angle)};
        contour.vertices.push_back({corner, chance(random) < arcs ? bulge(random) : 0, 0});
    }
    // The corners alone give a contour that does not cross itself.
    while (const auto crossing = find_crossing({&contour, 1}, 1e-9)) {
        contour.vertices[crossing->edge_a].bulge = 0;
        contour.vertices[crossing->edge_b].bulge = 0;
    }
    return contour;
}

std::vector<Point> flattened(const Contour& contour, double tolerance_mm) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < contour.edges(); ++i) {
        const Edge edge = contour.edge(i);
        int parts = 1;
        if (is_arc(edge)) {
            const double step = 2 * std::acos(1 - std::min(1.0, tolerance_mm / radius_mm(edge)));
            parts = 1 + static_cast<int>(std::abs(sweep_rad(edge)) / step);
        }
        for (int k = 0; k < parts; ++k) points.push_back(point_at(edge, static_cast<double>(k) / parts));
    }
    return points;
}

}  // namespace gsim::geometry
