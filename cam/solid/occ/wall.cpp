#include "cam/solid/occ/wall.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_IntCS.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "cam/solid/occ/face.h"

namespace gsim::solid {

namespace {

constexpr double kStraightnessTolerance_mm = 0.005;  // how far the wall may be off its straight line
constexpr double kMinLine_mm = 0.01;                 // a shorter line does not define a direction
constexpr double kMinDownShare = 0.05;               // of a line of length 1, away from the edge

// Returns the vector from the beginning of a curve to its end; nothing if it is curved.
std::optional<gp_Vec> line_direction(const BRepAdaptor_Curve& curve) {
    const double from = curve.FirstParameter();
    const double to = curve.LastParameter();
    const gp_Pnt first = curve.Value(from);
    const gp_Pnt last = curve.Value(to);
    const gp_Vec edge_vector(first, last);
    if (edge_vector.Magnitude() < kMinLine_mm) return std::nullopt;
    for (const double share : {0.25, 0.5, 0.75}) {
        const gp_Vec offset(first, curve.Value(from + share * (to - from)));
        if (offset.Crossed(edge_vector).Magnitude() > kStraightnessTolerance_mm * edge_vector.Magnitude())
            return std::nullopt;
    }
    return edge_vector;
}

// Returns the straight edge from a vertex to its other end.
std::optional<gp_Vec> straight_edge_vector(const TopoDS_Edge& edge, const TopoDS_Vertex& vertex) {
    const BRepAdaptor_Curve curve(edge);
    const auto edge_vector = line_direction(curve);
    if (!edge_vector) return std::nullopt;
    const gp_Pnt start = BRep_Tool::Pnt(vertex);
    const bool is_at_curve_begin = start.Distance(curve.Value(curve.FirstParameter())) <
                                   start.Distance(curve.Value(curve.LastParameter()));
    return is_at_curve_begin ? *edge_vector : edge_vector->Reversed();
}

}  // namespace

Wall::Wall(const TopoDS_Edge& edge, const TopoDS_Face& wall, bool allows_curved_edge)
    : edge_(edge),
      wall_(wall),
      curve_(edge),
      wall_curve_(edge, wall),
      plane_(face_plane(wall).has_value()),
      allows_curved_edge_(allows_curved_edge) {
    BRepTools::UVBounds(wall, u_low_, u_high_, v_low_, v_high_);
    for (TopExp_Explorer edges(wall, TopAbs_EDGE); edges.More(); edges.Next()) {
        if (edges.Current().IsSame(edge)) sense_ = edges.Current().Orientation() == TopAbs_REVERSED ? -1 : 1;
    }
    if (plane_) find_sides();
}

std::optional<gp_Dir> Wall::normal(double parameter) const {
    const gp_Pnt2d at = wall_curve_.Value(parameter);
    return outward_normal(wall_, at.X(), at.Y());
}

// Returns the direction in the wall, across the edge and away from it: faces are to the left of their edges.
std::optional<gp_Vec> Wall::inward_direction(double parameter) const {
    const auto outward_direction = normal(parameter);
    gp_Pnt point;
    gp_Vec tangent;
    curve_.D1(parameter, point, tangent);
    if (!outward_direction || tangent.Magnitude() <= 1e-12) return std::nullopt;
    return gp_Vec(*outward_direction).Crossed(tangent.Normalized() * sense_);
}

void Wall::find_sides() {
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge_, first, last);  // by the curve, in either direction of the edge
    if (first.IsNull() || last.IsNull() || first.IsSame(last)) return;
    for (TopExp_Explorer edges(wall_, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& side = TopoDS::Edge(edges.Current());
        if (side.IsSame(edge_) || BRep_Tool::Degenerated(side)) continue;
        for (TopExp_Explorer ends(side, TopAbs_VERTEX); ends.More(); ends.Next()) {
            if (ends.Current().IsSame(first)) first_side_ = straight_edge_vector(side, first);
            if (ends.Current().IsSame(last)) last_side_ = straight_edge_vector(side, last);
        }
    }
}

// Returns the side edge at an end, if it leads down the wall.
std::optional<gp_Vec> Wall::side_at(double parameter, bool first) const {
    const gp_Vec downward = inward_direction(parameter).value_or(gp_Vec(0, 0, 0));
    const auto& side = first ? first_side_ : last_side_;
    if (side && side->Dot(downward) > kMinDownShare * side->Magnitude()) return side;
    return std::nullopt;
}

// Returns the length of a plane wall along a direction, to the first edge that ends it.
std::optional<double> Wall::reach_mm(double parameter, const gp_Vec& direction) const {
    const gp_Pnt start = curve_.Value(parameter);
    const Handle(Geom_Plane) plane = new Geom_Plane(start, direction.Crossed(gp_Vec(*normal(parameter))));
    std::optional<double> reach;
    for (TopExp_Explorer edges(wall_, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        double from = 0;
        double to = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
        if (curve.IsNull()) continue;
        const GeomAPI_IntCS intersections(new Geom_TrimmedCurve(curve, from, to), plane);
        for (int i = 1; intersections.IsDone() && i <= intersections.NbPoints(); ++i) {
            const double along_mm = gp_Vec(start, intersections.Point(i)).Dot(direction);
            if (along_mm > kMinLine_mm) reach = std::min(along_mm, reach.value_or(along_mm));
        }
    }
    return reach;
}

WallLine Wall::plane_line(double parameter) const {
    const double from = curve_.FirstParameter();
    const double to = curve_.LastParameter();
    const double share = (parameter - from) / (to - from);
    const auto first = side_at(from, true);
    const auto last = side_at(to, false);
    const gp_Vec downward = inward_direction(parameter).value_or(gp_Vec(0, 0, 0));
    gp_Vec direction = (first ? first->Normalized() : downward) * (1 - share);
    direction += (last ? last->Normalized() : downward) * share;
    direction.Normalize();
    const double depth_mm = first && last ? first->Magnitude() * (1 - share) + last->Magnitude() * share
                                          : reach_mm(parameter, direction).value_or(1);
    return {direction, depth_mm, gp_Vec(*normal(parameter))};
}

std::optional<WallLine> Wall::iso_line(double parameter, bool is_along_u) const {
    const auto downward = inward_direction(parameter);
    if (!downward) return std::nullopt;
    const BRepAdaptor_Surface surface(wall_, false);
    const gp_Pnt2d at = wall_curve_.Value(parameter);
    const gp_Pnt start = surface.Value(at.X(), at.Y());
    std::optional<WallLine> found;
    for (const double end : {is_along_u ? u_low_ : v_low_, is_along_u ? u_high_ : v_high_}) {
        const auto point = [&](double share) {
            return is_along_u ? surface.Value(at.X() + share * (end - at.X()), at.Y())
                              : surface.Value(at.X(), at.Y() + share * (end - at.Y()));
        };
        const gp_Vec edge_vector(start, point(1));
        const double length = edge_vector.Magnitude();
        if (length < kMinLine_mm || edge_vector.Dot(*downward) < kMinDownShare * length) continue;
        bool line_direction = true;
        for (const double share : {0.2, 0.4, 0.6, 0.8})
            line_direction &= gp_Vec(start, point(share)).Crossed(edge_vector).Magnitude() <=
                              kStraightnessTolerance_mm * length;
        if (!line_direction || (found && length <= found->depth_mm)) continue;
        const auto end_normal =
            is_along_u ? outward_normal(wall_, end, at.Y()) : outward_normal(wall_, at.X(), end);
        found = WallLine{edge_vector.Normalized(), length,
                         end_normal ? gp_Vec(*end_normal) : gp_Vec(*normal(parameter))};
    }
    return found;
}

std::optional<WallLine> Wall::line(double parameter) const {
    if (plane_) {
        const bool has_sides = first_side_ || last_side_;
        if (!allows_curved_edge_ && !has_sides && !line_direction(curve_)) return std::nullopt;
        return plane_line(parameter);
    }
    const auto u = iso_line(parameter, true);
    const auto v = iso_line(parameter, false);
    if (!u || !v) return u ? u : v;
    // Both are straight on a saddle; the one that is steeper downwards belongs to the wall.
    const gp_Vec downward = *inward_direction(parameter);
    return u->direction.Dot(downward) > v->direction.Dot(downward) ? u : v;
}

}  // namespace gsim::solid
