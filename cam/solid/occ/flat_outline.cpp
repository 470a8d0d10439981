#include "cam/solid/occ/flat_outline.h"

#include <BRep_Tool.hxx>
#include <Eigen/Eigenvalues>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cam/solid/occ/face.h"
#include "cam/solid/occ/outline_pen.h"
#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr int kProbesOfCurve = 9;  // points of a curve that define its position

struct Probe {
    gp_Pnt point;
    std::size_t edge = 0;
};

std::vector<Probe> probes_of(std::span<const TopoDS_Edge> edges) {
    std::vector<Probe> probes;
    probes.reserve(edges.size() * kProbesOfCurve);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const BRepAdaptor_Curve curve(edges[i]);
        const double from = curve.FirstParameter();
        const double step = (curve.LastParameter() - from) / (kProbesOfCurve - 1);
        if (!std::isfinite(from) || !std::isfinite(step)) continue;
        for (int k = 0; k < kProbesOfCurve; ++k) probes.push_back({curve.Value(from + k * step), i});
    }
    return probes;
}

// Returns the normal of the plane with the least sum of squares of distances; along Z if several planes fit.
gp_Dir normal_of(const std::vector<Probe>& probes, const Eigen::Vector3d& middle) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Probe& probe : probes) {
        const Eigen::Vector3d off =
            Eigen::Vector3d(probe.point.X(), probe.point.Y(), probe.point.Z()) - middle;
        spread += off * off.transpose();
    }
    if (spread(2, 2) <= kSameHeight_mm * kSameHeight_mm) return {0, 0, 1};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    Eigen::Vector3d normal = solver.eigenvectors().col(0);
    constexpr double kSame = 1e-9;
    const double sign =
        std::abs(normal.z()) > kSame ? normal.z() : (std::abs(normal.y()) > kSame ? normal.y() : normal.x());
    if (sign < 0) normal = -normal;
    return {normal.x(), normal.y(), normal.z()};
}

PlateFrame frame_of(const std::vector<Probe>& probes, bool flip) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Probe& probe : probes)
        middle += Eigen::Vector3d(probe.point.X(), probe.point.Y(), probe.point.Z());
    middle /= static_cast<double>(probes.size());
    const gp_Dir up = normal_of(probes, middle);
    return {gp_Pnt(middle.x(), middle.y(), middle.z()), flip ? up.Reversed() : up};
}

// Returns the file's name of an edge, or its number among the drawn edges.
std::string name_of(const ShapeFile& file, const TopoDS_Edge& edge, std::size_t number) {
    const std::string label = file.label(edge);
    return label.empty() ? fmt::format("{}", number + 1) : label;
}

}  // namespace

tl::expected<Plate, std::string> plate_of_curves(std::span<const TopoDS_Edge> edges, const ShapeFile& file,
                                                 const PlateOptions& options) {
    const std::vector<Probe> probes = probes_of(edges);
    if (probes.empty()) return Fault("its curves have no ends");
    const PlateFrame frame = frame_of(probes, options.flip);
    for (const Probe& probe : probes) {
        const double off_mm = std::abs(frame.height_mm(probe.point));
        if (off_mm <= kSameHeight_mm) continue;
        return Fault(fmt::format("the curves do not lie in one plane: curve {} at {} is {:.4g} mm off",
                                 name_of(file, edges[probe.edge], probe.edge), shown(probe.point), off_mm));
    }
    Plate plate;
    OutlinePen pen(frame, options.tolerance_mm, plate.drawing);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const BRepAdaptor_Curve curve(edges[i]);
        const std::string name = name_of(file, edges[i], i);
        auto drawn = pen.draw(curve, curve.FirstParameter(), curve.LastParameter(), name, 0);
        if (!drawn) return Fault(drawn.error());
    }
    return plate;
}

tl::expected<Plate, std::string> plate_of_faces(std::span<const TopoDS_Face> faces, const ShapeFile& file,
                                                const PlateOptions& options) {
    for (const TopoDS_Face& face : faces) {
        if (!plane_of(face))
            return Fault(fmt::format("{} belongs to no closed body and is not plane", shown(face, file)));
    }
    // An edge of two faces is inside the surface.
    TopTools_DataMapOfShapeInteger uses;
    std::vector<TopoDS_Edge> found;
    for (const TopoDS_Face& face : faces) {
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            if (BRep_Tool::Degenerated(edge)) continue;
            if (!uses.IsBound(edge)) uses.Bind(edge, 0);
            if (++uses(edge) == 1) found.push_back(edge);
        }
    }
    std::vector<TopoDS_Edge> outer;
    for (const TopoDS_Edge& edge : found) {
        if (uses(edge) == 1) outer.push_back(edge);
    }
    return plate_of_curves(outer, file, options);
}

}  // namespace gsim::solid
