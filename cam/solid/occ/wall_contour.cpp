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

using No = tl::unexpected<std::string>;

constexpr double kTurnStep_rad = 2 * kRadPerDeg;  // of directions, from one point to the next
constexpr int kMaxHalvings = 14;
constexpr int kFirstParts = 2;
constexpr double kSmooth = 0.9998;   // cosine of the angle at which two faces are one, 1 deg
constexpr double kBeside_mm = 0.05;  // distance off the wall for the search of obstacles after it
constexpr double kBlind_mm = 0.05;

Triple triple_of(const gp_XYZ& vector) {
    return {vector.X(), vector.Y(), vector.Z()};
}

gp_Vec occ_vector(const Triple& triple) {
    return {triple[0], triple[1], triple[2]};
}

gp_Pnt point_of(const Triple& triple) {
    return {triple[0], triple[1], triple[2]};
}

std::string label_of(const ShapeFile& file, const TopoDS_Shape& shape) {
    const std::string label = file.label(shape);
    return label.empty() ? "" : " " + label;
}

// A sampler for points of an edge, as close as the tolerance and the change of directions require.
class EdgeSampler {
  public:
    EdgeSampler(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& wall,
                const ContourOptions& options)
        : curve_(edge),
          on_face_(edge, face),
          face_(face),
          wall_(edge, wall, options.kind == "edges"),
          options_(options) {}

    /// Returns the points in the order of the curve's parameter; an error if the wall is not straight, or has
    /// no normals.
    tl::expected<std::vector<WallPoint>, std::string> run() {
        const double from = curve_.FirstParameter();
        const double to = curve_.LastParameter();
        WallPoint first = at(from, true);
        points_.push_back(first);
        for (int i = 1; i <= kFirstParts && fault_.empty(); ++i) {
            const double begin = from + (i - 1) * (to - from) / kFirstParts;
            const double end = from + i * (to - from) / kFirstParts;
            const WallPoint next = at(end, i == kFirstParts);
            divide(begin, points_.back(), end, next, 0);
        }
        if (!fault_.empty()) return tl::unexpected(fault_);
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
        gp_Pnt place;
        gp_Vec tangent;
        curve_.D1(inside, place, tangent);
        point.position_mm = triple_of(curve_.Value(parameter).XYZ());
        const gp_Pnt2d on_face = on_face_.Value(inside);
        const auto normal = outward_normal(face_, on_face.X(), on_face.Y());
        const auto wall_normal = wall_.normal(inside);
        if (!normal || !wall_normal || tangent.Magnitude() <= 1e-12) {
            fault_ = fmt::format("has no normal at {}", shown(place));
            return point;
        }
        point.normal = triple_of(normal->XYZ());
        point.wall_normal = triple_of(wall_normal->XYZ());
        point.tangent = triple_of(tangent.Normalized().XYZ());
        const auto line = wall_.line(inside);
        if (line) {
            point.along_wall = triple_of(line->direction.XYZ());
            point.depth_mm = line->depth_mm;
            point.far_normal = triple_of(line->far_normal.XYZ());
        } else if (options_.along_walls) {
            fault_ = fmt::format("is not straight along the jet at {}", shown(place));
        }
        return point;
    }

    bool is_close(const WallPoint& a, const WallPoint& middle, const WallPoint& b) const {
        const gp_Vec chord = occ_vector(b.position_mm) - occ_vector(a.position_mm);
        const gp_Vec off = occ_vector(middle.position_mm) - occ_vector(a.position_mm);
        const double length = chord.Magnitude();
        const double off_mm = length > 1e-9 ? off.Crossed(chord).Magnitude() / length : off.Magnitude();
        if (off_mm > options_.tolerance_mm / 4) return false;
        const auto turns = [&](Triple WallPoint::*direction) {
            const gp_Vec first = occ_vector(a.*direction);
            const gp_Vec last = occ_vector(b.*direction);
            return first.Crossed(last).Magnitude() > kTurnStep_rad || first.Dot(last) < 0;
        };
        return !turns(&WallPoint::tangent) && !turns(&WallPoint::normal) && !turns(&WallPoint::wall_normal) &&
               !turns(&WallPoint::along_wall) && !turns(&WallPoint::far_normal);
    }

    void divide(double from, const WallPoint& first, double to, const WallPoint& last, int depth) {
        if (!fault_.empty()) return;
        const double middle = (from + to) / 2;
        const WallPoint between = at(middle, false);
        if (depth >= kMaxHalvings || is_close(first, between, last)) {
            points_.push_back(last);
            return;
        }
        divide(from, first, middle, between, depth + 1);
        divide(middle, between, to, last, depth + 1);
    }

    BRepAdaptor_Curve curve_;
    BRepAdaptor_Curve2d on_face_;
    const TopoDS_Face& face_;
    Wall wall_;
    const ContourOptions& options_;
    std::vector<WallPoint> points_;
    std::string fault_;
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
    return first && second && first->Dot(*second) > kSmooth;
}

void turn_round(WallEdge& edge) {
    std::reverse(edge.points.begin(), edge.points.end());
    for (WallPoint& point : edge.points) {
        for (double& value : point.tangent) value = -value;
    }
}

// Returns a value above 0 if the wall's outside is to the right of the path.
double waste_to_the_right(const WallPoint& point) {
    return occ_vector(point.tangent).Crossed(occ_vector(point.normal)).Dot(occ_vector(point.wall_normal));
}

}  // namespace

double ContourWalk::behind_mm(const WallEdge& edge) const {
    IntCurvesFace_ShapeIntersector hits;
    hits.Load(solid_, 1e-6);
    double nearest = 0;
    for (const double share : {0.3, 0.5, 0.7}) {
        const auto at = static_cast<std::size_t>(share * static_cast<double>(edge.points.size()));
        const WallPoint& a = edge.points[std::min(at, edge.points.size() - 2)];
        const WallPoint& b = edge.points[std::min(at, edge.points.size() - 2) + 1];
        const gp_Vec direction = (occ_vector(a.along_wall) + occ_vector(b.along_wall)) / 2;
        if (direction.Magnitude() < 0.5) continue;
        const gp_Vec middle = (occ_vector(a.position_mm) + occ_vector(b.position_mm)) / 2;
        const gp_Pnt start(middle.XYZ() + kBeside_mm * occ_vector(a.wall_normal).XYZ());
        // Not PerformNearest: OpenCASCADE 7.6 deletes its array as if it were a single number.
        hits.Perform(gp_Lin(start, gp_Dir(direction)), kBeside_mm, 1e6);
        if (!hits.IsDone()) continue;
        for (int index = 1; index <= hits.NbPnt(); ++index) {
            const double hit = hits.WParameter(index);
            if (nearest <= 0 || hit < nearest) nearest = hit;
        }
    }
    return nearest;
}

tl::expected<WallEdge, std::string> ContourWalk::edge_of(const TopoDS_Edge& edge,
                                                         const TopoDS_Face& face) const {
    TopoDS_Face other;
    for (const TopoDS_Shape& each : faces_of_.FindFromKey(edge)) {
        if (!each.IsSame(face)) other = TopoDS::Face(each);
    }
    if (other.IsNull()) return No("closes upon itself in a seam");
    if (is_smooth(edge, face, other))
        return No(fmt::format("goes over smoothly into {}", shown(other, file_)));
    auto points = EdgeSampler(edge, face, other, options_).run();
    if (!points) return No(fmt::format("has {} below it, which {}", shown(other, file_), points.error()));
    WallEdge found;
    found.label = file_.label(edge);
    found.name =
        fmt::format("edge{} of the {} face{}", label_of(file_, edge), kind_of(other), label_of(file_, other));
    found.points = *std::move(points);
    const WallPoint& middle = found.points[found.points.size() / 2];
    const gp_Vec normal = occ_vector(middle.normal);
    if (normal.Dot(occ_vector(middle.along_wall)) > 0)
        return No(fmt::format("is the foot of {}, which stands up there", shown(other, file_)));
    if (edge.Orientation() == TopAbs_REVERSED) turn_round(found);
    found.behind_mm = behind_mm(found);
    return found;
}

tl::expected<WallContour, std::string> ContourWalk::walk(const TopoDS_Face& face,
                                                         const FaceLoop& loop) const {
    WallContour contour;
    contour.face = shown(face, file_);
    contour.is_hole = loop.is_hole;
    double right = 0;
    for (const TopoDS_Edge& edge : loop.edges) {
        auto found = edge_of(edge, face);
        if (!found) return tl::unexpected(found.error());
        for (const WallPoint& point : found->points) right += waste_to_the_right(point);
        contour.edges.push_back(*std::move(found));
    }
    if (right < 0) {
        std::reverse(contour.edges.begin(), contour.edges.end());
        for (WallEdge& edge : contour.edges) turn_round(edge);
    }
    if (auto blind = find_blind(contour)) return No(*std::move(blind));
    return contour;
}

std::optional<std::string> ContourWalk::find_blind(const WallContour& contour) {
    const auto blind = std::find_if(contour.edges.begin(), contour.edges.end(), [](const WallEdge& edge) {
        return edge.behind_mm > 0 && edge.behind_mm <= edge.points.front().depth_mm + kBlind_mm;
    });
    if (blind == contour.edges.end()) return std::nullopt;
    return fmt::format("does not go through: below {} at {} there is material {:.4g} mm down", blind->name,
                       shown(point_of(blind->points.front().position_mm)), blind->behind_mm);
}

tl::expected<EdgeAlone, std::string> ContourWalk::walk_along(const TopoDS_Edge& edge,
                                                             const TopoDS_Face& face) const {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    auto found = edge_of(forward, face);
    if (!found) return No(found.error());
    EdgeAlone alone{*std::move(found), {}, {}};
    TopExp::Vertices(forward, alone.begin, alone.end);
    double right = 0;
    for (const WallPoint& point : alone.edge.points) right += waste_to_the_right(point);
    if (right < 0) {
        turn_round(alone.edge);
        std::swap(alone.begin, alone.end);
    }
    return alone;
}

}  // namespace gsim::solid
