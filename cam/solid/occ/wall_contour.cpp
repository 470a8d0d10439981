#include "cam/solid/occ/wall_contour.h"

#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Lin.hxx>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/solid/occ/face.h"
#include "cam/solid/occ/plate_frame.h"
#include "cam/solid/occ/wall.h"

namespace gsim::solid {

namespace {

constexpr double kMaxTurnStep_rad = 2 * kRadPerDeg;  // of directions, from one point to the next
constexpr int kMaxHalvings = 14;
constexpr int kInitialParts = 2;
constexpr double kSmoothCosine = 0.9998;  // cosine of the angle at which two faces are one, 1 deg
constexpr double kProbeOffset_mm = 0.05;  // distance off the wall for the search of obstacles past it
constexpr double kBlindTolerance_mm = 0.05;

Vec3 to_vec3(const gp_XYZ& vector) {
    return {vector.X(), vector.Y(), vector.Z()};
}

gp_Vec to_gp_vec(const Vec3& vec) {
    return {vec[0], vec[1], vec[2]};
}

gp_Pnt to_gp_pnt(const Vec3& vec) {
    return {vec[0], vec[1], vec[2]};
}

std::string label_suffix(const ShapeFile& file, const TopoDS_Shape& shape) {
    const std::string label = file.label(shape);
    return label.empty() ? "" : " " + label;
}

// A sampler for points of an edge, as close as the tolerance and the change of directions require.
class EdgeSampler {
  public:
    EdgeSampler(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& wall,
                const ContourOptions& options)
        : curve_(edge),
          face_curve_(edge, face),
          face_(face),
          wall_(edge, wall, options.kind == "edges"),
          options_(options) {}

    /// Returns the points in the order of the curve's parameter; an error if the wall is not straight, or has
    /// no normals.
    Result<std::vector<WallPoint>> run() {
        const double from = curve_.FirstParameter();
        const double to = curve_.LastParameter();
        WallPoint first = at(from, true);
        points_.push_back(first);
        for (int i = 1; i <= kInitialParts && error_.empty(); ++i) {
            const double begin = from + (i - 1) * (to - from) / kInitialParts;
            const double end = from + i * (to - from) / kInitialParts;
            const WallPoint next = at(end, i == kInitialParts);
            divide(begin, points_.back(), end, next, 0);
        }
        if (!error_.empty()) return tl::unexpected(error_);
        return std::move(points_);
    }

  private:
    // Directions at an end of the edge are those slightly before it, because surfaces may have none there.
    WallPoint at(double parameter, bool is_end) {
        const double from = curve_.FirstParameter();
        const double to = curve_.LastParameter();
        const double margin = 1e-6 * (to - from);
        const double inside = is_end ? std::clamp(parameter, from + margin, to - margin) : parameter;
        WallPoint point;
        gp_Pnt position;
        gp_Vec tangent;
        curve_.D1(inside, position, tangent);
        point.position_mm = to_vec3(curve_.Value(parameter).XYZ());
        const gp_Pnt2d face_parameters = face_curve_.Value(inside);
        const auto normal = outward_normal(face_, face_parameters.X(), face_parameters.Y());
        const auto wall_normal = wall_.normal(inside);
        if (!normal || !wall_normal || tangent.Magnitude() <= 1e-12) {
            error_ = fmt::format("has no normal at {}", display_text(position));
            return point;
        }
        point.normal = to_vec3(normal->XYZ());
        point.wall_normal = to_vec3(wall_normal->XYZ());
        point.tangent = to_vec3(tangent.Normalized().XYZ());
        const auto line = wall_.line(inside);
        if (line) {
            point.along_wall = to_vec3(line->direction.XYZ());
            point.depth_mm = line->depth_mm;
            point.exit_normal = to_vec3(line->exit_normal.XYZ());
        } else if (options_.along_walls) {
            error_ = fmt::format("is not straight along the jet at {}", display_text(position));
        }
        return point;
    }

    bool is_fine_enough(const WallPoint& a, const WallPoint& middle, const WallPoint& b) const {
        const gp_Vec chord = to_gp_vec(b.position_mm) - to_gp_vec(a.position_mm);
        const gp_Vec offset = to_gp_vec(middle.position_mm) - to_gp_vec(a.position_mm);
        const double length = chord.Magnitude();
        const double deviation_mm =
            length > 1e-9 ? offset.Crossed(chord).Magnitude() / length : offset.Magnitude();
        if (deviation_mm > options_.tolerance_mm / 4) return false;
        const auto turns_too_much = [&](Vec3 WallPoint::*direction) {
            const gp_Vec first = to_gp_vec(a.*direction);
            const gp_Vec last = to_gp_vec(b.*direction);
            return first.Crossed(last).Magnitude() > kMaxTurnStep_rad || first.Dot(last) < 0;
        };
        return !turns_too_much(&WallPoint::tangent) && !turns_too_much(&WallPoint::normal) &&
               !turns_too_much(&WallPoint::wall_normal) && !turns_too_much(&WallPoint::along_wall) &&
               !turns_too_much(&WallPoint::exit_normal);
    }

    void divide(double from, const WallPoint& first, double to, const WallPoint& last, int depth) {
        if (!error_.empty()) return;
        const double middle = (from + to) / 2;
        const WallPoint between = at(middle, false);
        if (depth >= kMaxHalvings || is_fine_enough(first, between, last)) {
            points_.push_back(last);
            return;
        }
        divide(from, first, middle, between, depth + 1);
        divide(middle, between, to, last, depth + 1);
    }

    BRepAdaptor_Curve curve_;
    BRepAdaptor_Curve2d face_curve_;
    const TopoDS_Face& face_;
    Wall wall_;
    const ContourOptions& options_;
    std::vector<WallPoint> points_;
    std::string error_;
};

// Returns true if two faces are tangent in the middle of their edge.
bool is_smooth(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& other) {
    const auto normal_of = [&edge](const TopoDS_Face& each) {
        const BRepAdaptor_Curve2d curve(edge, each);
        const gp_Pnt2d at = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
        return outward_normal(each, at.X(), at.Y());
    };
    const auto first = normal_of(face);
    const auto second = normal_of(other);
    return first && second && first->Dot(*second) > kSmoothCosine;
}

void reverse_edge(WallEdge& edge) {
    std::reverse(edge.points.begin(), edge.points.end());
    for (WallPoint& point : edge.points) {
        for (double& value : point.tangent) value = -value;
    }
}

// Returns a value above 0 if the wall's outside is to the right of the path.
double waste_side(const WallPoint& point) {
    return to_gp_vec(point.tangent).Crossed(to_gp_vec(point.normal)).Dot(to_gp_vec(point.wall_normal));
}

}  // namespace

double ContourTracer::next_surface_mm(const WallEdge& edge) const {
    IntCurvesFace_ShapeIntersector hits;
    hits.Load(solid_, 1e-6);
    double nearest = 0;
    for (const double share : {0.3, 0.5, 0.7}) {
        const auto at = static_cast<std::size_t>(share * static_cast<double>(edge.points.size()));
        const WallPoint& a = edge.points[std::min(at, edge.points.size() - 2)];
        const WallPoint& b = edge.points[std::min(at, edge.points.size() - 2) + 1];
        const gp_Vec direction = (to_gp_vec(a.along_wall) + to_gp_vec(b.along_wall)) / 2;
        if (direction.Magnitude() < 0.5) continue;
        const gp_Vec middle = (to_gp_vec(a.position_mm) + to_gp_vec(b.position_mm)) / 2;
        const gp_Pnt start(middle.XYZ() + kProbeOffset_mm * to_gp_vec(a.wall_normal).XYZ());
        // Not PerformNearest: OpenCASCADE 7.6 deletes its array as if it were a single number.
        hits.Perform(gp_Lin(start, gp_Dir(direction)), kProbeOffset_mm, 1e6);
        if (!hits.IsDone()) continue;
        for (int index = 1; index <= hits.NbPnt(); ++index) {
            const double hit = hits.WParameter(index);
            if (nearest <= 0 || hit < nearest) nearest = hit;
        }
    }
    return nearest;
}

Result<WallEdge> ContourTracer::make_wall_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
    TopoDS_Face other;
    for (const TopoDS_Shape& each : edge_faces_.FindFromKey(edge)) {
        if (!each.IsSame(face)) other = TopoDS::Face(each);
    }
    if (other.IsNull()) return Unexpected("closes on itself at a seam");
    if (is_smooth(edge, face, other))
        return Unexpected(fmt::format("continues smoothly into {}", display_text(other, file_)));
    auto points = EdgeSampler(edge, face, other, options_).run();
    if (!points)
        return Unexpected(
            fmt::format("has {} below it, which {}", display_text(other, file_), points.error().message));
    WallEdge found;
    found.label = file_.label(edge);
    found.name = fmt::format("edge{} of the {} face{}", label_suffix(file_, edge), surface_kind(other),
                             label_suffix(file_, other));
    found.points = *std::move(points);
    const WallPoint& middle = found.points[found.points.size() / 2];
    const gp_Vec normal = to_gp_vec(middle.normal);
    if (normal.Dot(to_gp_vec(middle.along_wall)) > 0)
        return Unexpected(
            fmt::format("is at the foot of {}, which rises from there", display_text(other, file_)));
    if (edge.Orientation() == TopAbs_REVERSED) reverse_edge(found);
    found.next_surface_mm = next_surface_mm(found);
    return found;
}

Result<WallContour> ContourTracer::walk(const TopoDS_Face& face, const FaceLoop& loop) const {
    WallContour contour;
    contour.face = display_text(face, file_);
    contour.is_hole = loop.is_hole;
    double right = 0;
    for (const TopoDS_Edge& edge : loop.edges) {
        auto found = make_wall_edge(edge, face);
        if (!found) return tl::unexpected(found.error());
        for (const WallPoint& point : found->points) right += waste_side(point);
        contour.edges.push_back(*std::move(found));
    }
    if (right < 0) {
        std::reverse(contour.edges.begin(), contour.edges.end());
        for (WallEdge& edge : contour.edges) reverse_edge(edge);
    }
    if (auto blind = find_blind_wall(contour)) return Unexpected(*std::move(blind));
    return contour;
}

std::optional<Error> ContourTracer::find_blind_wall(const WallContour& contour) {
    const auto blind = std::find_if(contour.edges.begin(), contour.edges.end(), [](const WallEdge& edge) {
        return edge.next_surface_mm > 0 &&
               edge.next_surface_mm <= edge.points.front().depth_mm + kBlindTolerance_mm;
    });
    if (blind == contour.edges.end()) return std::nullopt;
    return fmt::format("is not a through cut: below {} at {} there is material at a depth of {:.4g} mm",
                       blind->name, display_text(to_gp_pnt(blind->points.front().position_mm)),
                       blind->next_surface_mm);
}

Result<ChainEdge> ContourTracer::trace_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    auto found = make_wall_edge(forward, face);
    if (!found) return Unexpected(found.error().message);
    ChainEdge chain_edge{*std::move(found), {}, {}};
    TopExp::Vertices(forward, chain_edge.begin, chain_edge.end);
    double right = 0;
    for (const WallPoint& point : chain_edge.edge.points) right += waste_side(point);
    if (right < 0) {
        reverse_edge(chain_edge.edge);
        std::swap(chain_edge.begin, chain_edge.end);
    }
    return chain_edge;
}

}  // namespace gsim::solid
