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

constexpr int kSamplesPerCurve = 9;  // points of a curve that define its position

struct CurveSample {
    gp_Pnt point;
    std::size_t edge = 0;
};

std::vector<CurveSample> curve_samples(std::span<const TopoDS_Edge> edges) {
    std::vector<CurveSample> samples;
    samples.reserve(edges.size() * kSamplesPerCurve);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const BRepAdaptor_Curve curve(edges[i]);
        const double from = curve.FirstParameter();
        const double step = (curve.LastParameter() - from) / (kSamplesPerCurve - 1);
        if (!std::isfinite(from) || !std::isfinite(step)) continue;
        for (int k = 0; k < kSamplesPerCurve; ++k) samples.push_back({curve.Value(from + k * step), i});
    }
    return samples;
}

// Returns the normal of the plane with the least sum of squares of distances; along Z if several planes fit.
gp_Dir normal_of(const std::vector<CurveSample>& samples, const Eigen::Vector3d& middle) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const CurveSample& probe : samples) {
        const Eigen::Vector3d offset =
            Eigen::Vector3d(probe.point.X(), probe.point.Y(), probe.point.Z()) - middle;
        scatter += offset * offset.transpose();
    }
    if (scatter(2, 2) <= kHeightTolerance_mm * kHeightTolerance_mm) return {0, 0, 1};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    Eigen::Vector3d normal = solver.eigenvectors().col(0);
    constexpr double kEqualTolerance = 1e-9;
    const double sign = std::abs(normal.z()) > kEqualTolerance
                            ? normal.z()
                            : (std::abs(normal.y()) > kEqualTolerance ? normal.y() : normal.x());
    if (sign < 0) normal = -normal;
    return {normal.x(), normal.y(), normal.z()};
}

PlateFrame fit_plate_frame(const std::vector<CurveSample>& samples, bool flip) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const CurveSample& probe : samples)
        middle += Eigen::Vector3d(probe.point.X(), probe.point.Y(), probe.point.Z());
    middle /= static_cast<double>(samples.size());
    const gp_Dir up = normal_of(samples, middle);
    return {gp_Pnt(middle.x(), middle.y(), middle.z()), flip ? up.Reversed() : up};
}

// Returns the file's name of an edge, or its number among the drawn edges.
std::string edge_name(const ShapeFile& file, const TopoDS_Edge& edge, std::size_t number) {
    const std::string label = file.label(edge);
    return label.empty() ? fmt::format("{}", number + 1) : label;
}

}  // namespace

Result<Plate> plate_from_curves(std::span<const TopoDS_Edge> edges, const ShapeFile& file,
                                const PlateOptions& options) {
    const std::vector<CurveSample> samples = curve_samples(edges);
    if (samples.empty()) return Unexpected("its curves have no ends");
    const PlateFrame frame = fit_plate_frame(samples, options.flip);
    for (const CurveSample& probe : samples) {
        const double deviation_mm = std::abs(frame.height_mm(probe.point));
        if (deviation_mm <= kHeightTolerance_mm) continue;
        return Unexpected(fmt::format("the curves are not in one plane: curve {} at {} deviates by {:.4g} mm",
                                      edge_name(file, edges[probe.edge], probe.edge),
                                      display_text(probe.point), deviation_mm));
    }
    Plate plate;
    OutlinePen pen(frame, options.tolerance_mm, plate.drawing);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const BRepAdaptor_Curve curve(edges[i]);
        const std::string name = edge_name(file, edges[i], i);
        auto result = pen.draw(curve, curve.FirstParameter(), curve.LastParameter(), name, 0);
        if (!result) return Unexpected(result.error());
    }
    return plate;
}

Result<Plate> plate_from_faces(std::span<const TopoDS_Face> faces, const ShapeFile& file,
                               const PlateOptions& options) {
    for (const TopoDS_Face& face : faces) {
        if (!face_plane(face))
            return Unexpected(fmt::format("{} does not belong to a closed body and is not planar",
                                          display_text(face, file)));
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
    return plate_from_curves(outer, file, options);
}

}  // namespace gsim::solid
