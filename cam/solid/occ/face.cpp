#include "cam/solid/occ/face.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <fmt/format.h>

#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

namespace {

constexpr double kPlanarityTolerance_mm = 1e-4;

}  // namespace

std::string surface_kind(const TopoDS_Face& face) {
    if (face_plane(face)) return "plane";
    switch (BRepAdaptor_Surface(face, false).GetType()) {
        case GeomAbs_Cylinder: return "cylindrical";
        case GeomAbs_Cone: return "conical";
        case GeomAbs_Sphere: return "spherical";
        case GeomAbs_Torus: return "toroidal";
        default: return "curved";
    }
}

gp_Pnt face_point(const TopoDS_Face& face) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        const BRepAdaptor_Curve curve(edge);
        return curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    }
    return {};
}

std::string display_text(const TopoDS_Face& face, const ShapeFile& file) {
    const std::string label = file.label(face);
    return fmt::format("the {} face{}{} at {}", surface_kind(face), label.empty() ? "" : " ", label,
                       display_text(face_point(face)));
}

std::optional<gp_Dir> outward_normal(const TopoDS_Face& face, double u, double v) {
    gp_Pnt point;
    gp_Vec u_derivative, v_derivative;
    BRepAdaptor_Surface(face, false).D1(u, v, point, u_derivative, v_derivative);
    gp_Vec normal = u_derivative.Crossed(v_derivative);
    if (normal.Magnitude() <= 1e-12 * u_derivative.Magnitude() * v_derivative.Magnitude())
        return std::nullopt;
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    return gp_Dir(normal);
}

std::optional<gp_Pln> face_plane(const TopoDS_Face& face) {
    double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
    const GeomLib_IsPlanarSurface planarity_check(BRep_Tool::Surface(face), kPlanarityTolerance_mm);
    if (!planarity_check.IsPlanar()) return std::nullopt;
    BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
    const auto normal = outward_normal(face, (u_low + u_high) / 2, (v_low + v_high) / 2);
    if (!normal) return std::nullopt;
    return gp_Pln(planarity_check.Plan().Location(), *normal);
}

}  // namespace gsim::solid
