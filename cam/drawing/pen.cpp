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

constexpr double kRound = 1e-9;  // how unequal the axes of a circle may be

bool is_round(Point u, Point v) {
    const double size = dot(u, u) + dot(v, v);
    return std::abs(dot(u, v)) <= kRound * size && std::abs(dot(u, u) - dot(v, v)) <= kRound * size;
}

Point at(const EllipseArc& arc, double t) {
    return arc.center + std::cos(t) * arc.u + std::sin(t) * arc.v;
}

}  // namespace

void Pen::take(const Affine& map, std::uint32_t source) {
    map_ = map;
    source_ = source;
    fault_.reset();
}

void Pen::check(Point point) {
    const double furthest = std::max(std::abs(point.x), std::abs(point.y));
    if (furthest <= kMaxCoordinate_mm || fault_) return;  // false for NaN
    fault_ = fmt::format("has the point ({}, {}) mm; nothing can be cut further off than {} mm", point.x,
                         point.y, kMaxCoordinate_mm);
}

void Pen::add(const Edge& edge) {
    check(edge.start);
    check(edge.end);
    if (std::abs(edge.bulge) > 1) {  // more than half around: it leads out of its chord's neighbourhood
        const Point middle = geometry::center(edge);
        check(middle + (middle - edge.start));
    }
    if (fault_ || distance(edge.start, edge.end) <= geometry::kSamePoint_mm) return;
    const std::size_t before = contour_.edges();
    append_edge(contour_, edge, source_);
    edges_ += contour_.edges() - before;
    if (edges_ > kMaxEdges) fault_ = fmt::format("is one too many: more than {} lines and arcs", kMaxEdges);
}

void Pen::move_to(Point point) {
    lift();
    start_ = here_ = point;
}

void Pen::line_to(Point point) {
    bulge_to(point, 0);
}

void Pen::bulge_to(Point point, double bulge) {
    const Point from = here_;
    here_ = point;
    const bool straight = std::abs(bulge) <= geometry::kStraightBulge;
    if (straight || is_round(map_.x, map_.y)) {
        const double sense = cross(map_.x, map_.y) < 0 ? -1 : 1;
        add({map_(from), map_(point), straight ? 0 : sense * bulge});
        return;
    }
    if (distance(from, point) <= geometry::kSamePoint_mm) return;
    const Edge edge{from, point, bulge};
    const Point middle = geometry::center(edge);
    const Point u = from - middle;
    here_ = from;
    arc({middle, u, left_of(u), 0, 4 * std::atan(bulge)});
    here_ = point;
}

void Pen::arc(const EllipseArc& arc) {
    const EllipseArc there{map_(arc.center), map_.direction(arc.u), map_.direction(arc.v), arc.from_rad,
                           arc.sweep_rad};
    const double to = arc.from_rad + arc.sweep_rad;
    here_ = at(arc, to);
    check(there.center + there.u);
    check(there.center + there.v);
    if (fault_ || !std::isfinite(arc.sweep_rad)) return;
    if (is_round(there.u, there.v)) {
        const double sense = cross(there.u, there.v) < 0 ? -1 : 1;
        const int parts = std::abs(arc.sweep_rad) > std::numbers::pi ? 2 : 1;
        const double bulge = sense * std::tan(arc.sweep_rad / parts / 4);
        for (int i = 0; i < parts; ++i) {
            const double from = arc.from_rad + arc.sweep_rad * i / parts;
            add({at(there, from), at(there, from + arc.sweep_rad / parts), bulge});
        }
        return;
    }
    Contour fitted;
    const double way = arc.sweep_rad < 0 ? -1 : 1;
    fit_arcs(
        [&](double t) {
            return CurvePoint{at(there, t), way * (std::cos(t) * there.v - std::sin(t) * there.u)};
        },
        arc.from_rad, to, tolerance_mm_, source_, fitted);
    for (std::size_t i = 0; i < fitted.edges(); ++i) add(fitted.edge(i));
}

void Pen::nurbs(const Nurbs& curve) {
    if (curve.points.empty()) return;
    Nurbs there = curve;
    for (Point& point : there.points) {
        point = map_(point);
        check(point);
    }
    here_ = curve.points.back();
    if (const auto fault = fault_of(curve); fault && !fault_) fault_ = fault;
    if (fault_) return;
    for (std::size_t span = curve.degree; span < curve.points.size() && !fault_; ++span) {
        const double from = curve.knots[span];
        const double to = curve.knots[span + 1];
        if (!(from < to)) continue;
        Contour fitted;
        fit_arcs([&](double t) { return point_of(there, span, t); }, from, to, tolerance_mm_, source_,
                 fitted);
        for (std::size_t i = 0; i < fitted.edges(); ++i) add(fitted.edge(i));
    }
}

void Pen::close() {
    line_to(start_);
    const Point start = start_;
    lift();
    start_ = here_ = start;
}

void Pen::lift() {
    if (contour_.edges() > 0) pieces_.push_back(std::move(contour_));
    contour_ = {};
}

}  // namespace gsim::drawing
