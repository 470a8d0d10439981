#include "cam/solid/occ/outline_pen.h"

#include <TColStd_Array1OfReal.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include <fmt/format.h>

#include "geometry/planar/fit.h"

namespace gsim::solid {

using geometry::Contour;
using geometry::Edge;
using geometry::Point;

namespace {

constexpr double kFlatTolerance = 1e-9;  // how far the axis of a circle may lean

std::string curve_kind(GeomAbs_CurveType type) {
    switch (type) {
        case GeomAbs_Line: return "line";
        case GeomAbs_Circle: return "circle";
        case GeomAbs_Ellipse: return "ellipse";
        default: return "curve";
    }
}

}  // namespace

std::uint32_t OutlinePen::add_entity(const BRepAdaptor_Curve& curve, const std::string& name,
                                     double bevel_deg) {
    drawing_.entities.push_back({curve_kind(curve.GetType()), name, 0, bevel_deg});
    return static_cast<std::uint32_t>(drawing_.entities.size() - 1);
}

void OutlinePen::draw_circle(const BRepAdaptor_Curve& curve, double from, double to,
                             Contour& drawn_contour) const {
    const double sense = curve.Circle().Axis().Direction().Dot(frame_.up()) > 0 ? 1 : -1;
    const int parts = to - from > std::numbers::pi ? 2 : 1;
    const double step = (to - from) / parts;
    for (int i = 0; i < parts; ++i) {
        append_edge(drawn_contour,
                    {frame_.to_plane(curve.Value(from + i * step)),
                     frame_.to_plane(curve.Value(from + (i + 1) * step)), sense * std::tan(step / 4)},
                    source_);
    }
}

void OutlinePen::draw_fitted(const BRepAdaptor_Curve& curve, double from, double to,
                             Contour& drawn_contour) const {
    const int count = curve.NbIntervals(GeomAbs_C2);
    TColStd_Array1OfReal ends(1, count + 1);
    curve.Intervals(ends, GeomAbs_C2);
    const auto at = [&](double parameter) {
        gp_Pnt point;
        gp_Vec direction;
        curve.D1(parameter, point, direction);
        return geometry::CurvePoint{frame_.to_plane(point), frame_.to_plane(direction)};
    };
    for (int i = 1; i <= count; ++i) {
        const double first = std::max(from, ends.Value(i));
        const double last = std::min(to, ends.Value(i + 1));
        if (first < last) geometry::fit_arcs(at, first, last, tolerance_mm_, source_, drawn_contour);
    }
}

Result<void> OutlinePen::check(const Contour& drawn_contour) const {
    if (edges_ > drawing::kMaxEdges)
        return Unexpected(fmt::format("the outlines have more than {} lines and arcs", drawing::kMaxEdges));
    for (const geometry::Vertex& vertex : drawn_contour.vertices) {
        const Point& at = vertex.position;
        const auto is_near = [](double value) { return std::abs(value) <= drawing::kMaxCoordinate_mm; };
        if (is_near(at.x) && is_near(at.y)) continue;  // false for NaN
        return Unexpected(fmt::format("{} has the point ({}, {}) mm; coordinates must not exceed {} mm",
                                      display_text(drawing_.entities.back()), at.x, at.y,
                                      drawing::kMaxCoordinate_mm));
    }
    return {};
}

Result<void> OutlinePen::draw(const BRepAdaptor_Curve& curve, double from, double to, const std::string& name,
                              double bevel_deg) {
    Contour drawn_contour;
    source_ = add_entity(curve, name, bevel_deg);
    const bool flat = curve.GetType() == GeomAbs_Circle &&
                      1 - std::abs(curve.Circle().Axis().Direction().Dot(frame_.up())) < kFlatTolerance;
    if (curve.GetType() == GeomAbs_Line) {
        append_edge(drawn_contour, {frame_.to_plane(curve.Value(from)), frame_.to_plane(curve.Value(to)), 0},
                    source_);
    } else if (flat) {
        draw_circle(curve, from, to, drawn_contour);
    } else {
        draw_fitted(curve, from, to, drawn_contour);
    }
    edges_ += drawn_contour.edges();
    if (auto checked = check(drawn_contour); !checked) return checked;
    if (drawn_contour.edges() > 0) drawing_.drawn_contours.push_back(std::move(drawn_contour));
    return {};
}

}  // namespace gsim::solid
