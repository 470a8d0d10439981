#include "cam/drawing/pen.h"

#include <fmt/format.h>

#include "cam/drawing/drawing.h"
#include "geometry/planar/chain.h"

namespace gsim::drawing {

using geometry::Contour;
using geometry::CurvePoint;
using geometry::Edge;
using geometry::Point;

namespace {

constexpr double kCircularTolerance = 1e-9;  // how unequal the axes of a circle may be

bool is_circular(Point u, Point v) {
    const double size = dot(u, u) + dot(v, v);
    return std::abs(dot(u, v)) <= kCircularTolerance * size &&
           std::abs(dot(u, u) - dot(v, v)) <= kCircularTolerance * size;
}

Point at(const EllipseArc& arc, double t) {
    return arc.center + std::cos(t) * arc.u + std::sin(t) * arc.v;
}

}  // namespace

void Pen::set_map(const Affine& map, std::uint32_t source) {
    map_ = map;
    source_ = source;
    error_.reset();
}

void Pen::check(Point point) {
    const double max_coordinate = std::max(std::abs(point.x), std::abs(point.y));
    if (max_coordinate <= kMaxCoordinate_mm || error_) return;  // false for NaN
    error_ = fmt::format("has the point ({}, {}) mm; coordinates must not exceed {} mm", point.x, point.y,
                         kMaxCoordinate_mm);
}

void Pen::add(const Edge& edge) {
    check(edge.start);
    check(edge.end);
    if (std::abs(edge.bulge) > 1) {  // more than half around: it leads out of its chord's neighbourhood
        const Point middle = geometry::center(edge);
        check(middle + (middle - edge.start));
    }
    if (error_ || distance(edge.start, edge.end) <= geometry::kPointTolerance_mm) return;
    const std::size_t before = contour_.edges();
    append_edge(contour_, edge, source_);
    edges_ += contour_.edges() - before;
    if (edges_ > kMaxEdges) error_ = fmt::format("exceeds the limit of {} lines and arcs", kMaxEdges);
}

void Pen::move_to(Point point) {
    lift();
    start_ = current_ = point;
}

void Pen::line_to(Point point) {
    bulge_to(point, 0);
}

void Pen::bulge_to(Point point, double bulge) {
    const Point from = current_;
    current_ = point;
    const bool straight = std::abs(bulge) <= geometry::kStraightBulge;
    if (straight || is_circular(map_.x, map_.y)) {
        const double sense = cross(map_.x, map_.y) < 0 ? -1 : 1;
        add({map_(from), map_(point), straight ? 0 : sense * bulge});
        return;
    }
    if (distance(from, point) <= geometry::kPointTolerance_mm) return;
    const Edge edge{from, point, bulge};
    const Point middle = geometry::center(edge);
    const Point u = from - middle;
    current_ = from;
    arc({middle, u, left_normal(u), 0, 4 * std::atan(bulge)});
    current_ = point;
}

void Pen::arc(const EllipseArc& arc) {
    const EllipseArc mapped{map_(arc.center), map_.direction(arc.u), map_.direction(arc.v), arc.from_rad,
                            arc.sweep_rad};
    const double to = arc.from_rad + arc.sweep_rad;
    current_ = at(arc, to);
    check(mapped.center + mapped.u);
    check(mapped.center + mapped.v);
    if (error_ || !std::isfinite(arc.sweep_rad)) return;
    if (is_circular(mapped.u, mapped.v)) {
        const double sense = cross(mapped.u, mapped.v) < 0 ? -1 : 1;
        const int parts = std::abs(arc.sweep_rad) > std::numbers::pi ? 2 : 1;
        const double bulge = sense * std::tan(arc.sweep_rad / parts / 4);
        for (int i = 0; i < parts; ++i) {
            const double from = arc.from_rad + arc.sweep_rad * i / parts;
            add({at(mapped, from), at(mapped, from + arc.sweep_rad / parts), bulge});
        }
        return;
    }
    Contour fitted;
    const double sign = arc.sweep_rad < 0 ? -1 : 1;
    fit_arcs(
        [&](double t) {
            return CurvePoint{at(mapped, t), sign * (std::cos(t) * mapped.v - std::sin(t) * mapped.u)};
        },
        arc.from_rad, to, tolerance_mm_, source_, fitted);
    for (std::size_t i = 0; i < fitted.edges(); ++i) add(fitted.edge(i));
}

void Pen::nurbs(const Nurbs& curve) {
    if (curve.points.empty()) return;
    Nurbs mapped = curve;
    for (Point& point : mapped.points) {
        point = map_(point);
        check(point);
    }
    current_ = curve.points.back();
    if (const auto error = find_curve_error(curve); error && !error_) error_ = error;
    if (error_) return;
    for (std::size_t span = curve.degree; span < curve.points.size() && !error_; ++span) {
        const double from = curve.knots[span];
        const double to = curve.knots[span + 1];
        if (!(from < to)) continue;
        Contour fitted;
        fit_arcs([&](double t) { return curve_point(mapped, span, t); }, from, to, tolerance_mm_, source_,
                 fitted);
        for (std::size_t i = 0; i < fitted.edges(); ++i) add(fitted.edge(i));
    }
}

void Pen::close() {
    line_to(start_);
    const Point start = start_;
    lift();
    start_ = current_ = start;
}

void Pen::lift() {
    if (contour_.edges() > 0) drawn_contours_.push_back(std::move(contour_));
    contour_ = {};
}

}  // namespace gsim::drawing
