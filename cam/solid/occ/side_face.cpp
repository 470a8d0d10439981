#include "cam/solid/occ/side_face.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/solid/occ/face.h"

namespace gsim::solid {

namespace {

constexpr double kFaceTolerance_mm = 0.01;  // how far the jet may leave the face
constexpr double kMaxBevel_deg = 60;
constexpr double kBevelStep_deg = 0.5;
constexpr int kMaxDepth = 8;  // of halving an edge
constexpr double kVerticalTolerance_deg = 1e-4;
// Positions along an edge where the jet is tested; a face may have no normal at its ends.
constexpr std::array kSampleShares{0.02, 0.2, 0.35, 0.5, 0.65, 0.8, 0.98};

// The face below one edge of the upper side.
class Side {
  public:
    Side(const TopoDS_Edge& edge, const TopoDS_Face& face, const PlateFrame& frame, double thickness_mm)
        : face_(face),
          frame_(frame),
          thickness_mm_(thickness_mm),
          curve_(edge),
          face_curve_(edge, face),
          plane_(face_plane(face).has_value()),
          surface_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))) {}

    Result<std::vector<BevelInterval>> run() {
        if (!is_through_cut())
            return Unexpected("does not extend through the plate from its upper to its lower side");
        const double from = curve_.FirstParameter();
        const double to = curve_.LastParameter();
        for (const double share : kSampleShares) {
            const double at = from + share * (to - from);
            const auto bevel = bevel_deg(at);
            if (!bevel) return Unexpected("has no normal at its upper edge");
            if (std::abs(*bevel) > kMaxBevel_deg) {
                return Unexpected(fmt::format("is tilted by {:.1f} deg; a jet can be tilted by up to {} deg",
                                              std::abs(*bevel), kMaxBevel_deg));
            }
            if (!is_straight(at)) return Unexpected("is not straight from the upper to the lower side");
        }
        // The ends themselves may have no normal.
        const double margin = 1e-3 * (to - from);
        divide(from, to, bevel_deg(from + margin).value_or(0), bevel_deg(to - margin).value_or(0), 0);
        return std::move(intervals_);
    }

  private:
    std::optional<gp_Dir> normal(double parameter) const {
        const gp_Pnt2d at = face_curve_.Value(parameter);
        return outward_normal(face_, at.X(), at.Y());
    }

    std::optional<double> bevel_deg(double parameter) const {
        const auto outward_direction = normal(parameter);
        if (!outward_direction) return std::nullopt;
        const double rise = std::clamp(outward_direction->Dot(frame_.up()), -1.0, 1.0);
        const double bevel = -std::asin(rise) * kDegPerRad;
        return std::abs(bevel) < kVerticalTolerance_deg ? 0 : bevel;
    }

    bool is_at_height(const gp_Pnt& point, double height_mm) const {
        return std::abs(frame_.height_mm(point) - height_mm) <= kHeightTolerance_mm;
    }

    // Returns true if each edge lies in the upper or in the lower side, or leads from one to the other.
    bool is_through_cut() const {
        bool reaches = false;
        for (TopExp_Explorer edges(face_, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            if (BRep_Tool::Degenerated(edge)) return false;
            const BRepAdaptor_Curve curve(edge);
            const double from = curve.FirstParameter();
            const double to = curve.LastParameter();
            const auto is_all_at = [&](double height_mm) {
                return std::all_of(kSampleShares.begin(), kSampleShares.end(), [&](double share) {
                    return is_at_height(curve.Value(from + share * (to - from)), height_mm);
                });
            };
            if (is_all_at(0)) continue;
            if (is_all_at(-thickness_mm_)) {
                reaches = true;
                continue;
            }
            const gp_Pnt first = curve.Value(from);
            const gp_Pnt last = curve.Value(to);
            const bool downward = is_at_height(first, 0) && is_at_height(last, -thickness_mm_);
            const bool upwards = is_at_height(last, 0) && is_at_height(first, -thickness_mm_);
            if (!downward && !upwards) return false;
        }
        return reaches;
    }

    // Returns true if the jet through a point of the upper edge stays on the face down to the lower side. It
    // may leave the face past its ends if the face narrows.
    bool is_straight(double parameter) const {
        if (plane_) return true;
        const gp_Vec up(frame_.up());
        const gp_Vec outward_direction(*normal(parameter));
        const gp_Vec level = outward_direction - outward_direction.Dot(up) * up;
        const gp_Vec downward = -up + outward_direction.Dot(up) / level.SquareMagnitude() * level;
        const gp_Pnt start = curve_.Value(parameter);
        return std::all_of(kSampleShares.begin(), kSampleShares.end(), [&](double share) {
            const gp_Pnt jet_point = start.Translated(share * thickness_mm_ * downward);
            const gp_Pnt2d nearest = surface_->ValueOfUV(jet_point, kFaceTolerance_mm / 10);
            return surface_->Gap() <= kFaceTolerance_mm || is_at_boundary(nearest);
        });
    }

    bool is_at_boundary(const gp_Pnt2d& point) const {
        double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
        surface_->Bounds(u_low, u_high, v_low, v_high);
        const auto is_end = [](double value, double low, double high) {
            const double near = 1e-6 * (high - low);
            return value - low <= near || high - value <= near;
        };
        return is_end(point.X(), u_low, u_high) || is_end(point.Y(), v_low, v_high);
    }

    void divide(double from, double to, double first_bevel_deg, double last_bevel_deg, int depth) {
        const double middle = (from + to) / 2;
        const double bevel = bevel_deg(middle).value_or(first_bevel_deg);
        const double change = std::max(std::abs(first_bevel_deg - bevel), std::abs(last_bevel_deg - bevel));
        if (depth >= kMaxDepth || change <= kBevelStep_deg / 2) {
            intervals_.push_back({from, to, bevel});
            return;
        }
        divide(from, middle, first_bevel_deg, bevel, depth + 1);
        divide(middle, to, bevel, last_bevel_deg, depth + 1);
    }

    const TopoDS_Face& face_;
    const PlateFrame& frame_;
    double thickness_mm_;
    BRepAdaptor_Curve curve_;
    BRepAdaptor_Curve2d face_curve_;
    bool plane_;
    Handle(ShapeAnalysis_Surface) surface_;
    std::vector<BevelInterval> intervals_;
};

}  // namespace

Result<std::vector<BevelInterval>> edge_bevels(const TopoDS_Edge& edge, const TopoDS_Face& side,
                                               const PlateFrame& frame, double thickness_mm) {
    return Side(edge, side, frame, thickness_mm).run();
}

}  // namespace gsim::solid
