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

constexpr double kOffPlane_mm = 1e-4;

}  // namespace

std::string kind_of(const TopoDS_Face& face) {
    if (plane_of(face)) return "plane";
    switch (BRepAdaptor_Surface(face, false).GetType()) {
        case GeomAbs_Cylinder: return "cylindrical";
        case GeomAbs_Cone: return "conical";
        case GeomAbs_Sphere: return "spherical";
        case GeomAbs_Torus: return "toroidal";
        default: return "curved";
    }
}

gp_Pnt place_of(const TopoDS_Face& face) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        const BRepAdaptor_Curve curve(edge);
        return curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    }
    return {};
}

std::string shown(const TopoDS_Face& face, const ShapeFile& file) {
    const std::string label = file.label(face);
    return fmt::format("the {} face{}{} at {}", kind_of(face), label.empty() ? "" : " ", label,
                       shown(place_of(face)));
}

std::optional<gp_Dir> outward_normal(const TopoDS_Face& face, double u, double v) {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    BRepAdaptor_Surface(face, false).D1(u, v, point, along_u, along_v);
    gp_Vec normal = along_u.Crossed(along_v);
    if (normal.Magnitude() <= 1e-12 * along_u.Magnitude() * along_v.Magnitude()) return std::nullopt;
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    return gp_Dir(normal);
}

std::optional<gp_Pln> plane_of(const TopoDS_Face& face) {
    double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
    const GeomLib_IsPlanarSurface planar(BRep_Tool::Surface(face), kOffPlane_mm);
    if (!planar.IsPlanar()) return std::nullopt;
    BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
    const auto normal = outward_normal(face, (u_low + u_high) / 2, (v_low + v_high) / 2);
    if (!normal) return std::nullopt;
    return gp_Pln(planar.Plan().Location(), *normal);
}

}  // namespace gsim::solid
