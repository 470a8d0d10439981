#include "cam/solid/occ/solid_outline.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cam/solid/occ/face.h"
#include "cam/solid/occ/side_face.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr double kSameArea = 1e-6;
constexpr double kRound_mm = 1e-6;  // of the thickness, which reports show
constexpr double kLevel = 1e-8;  // 1 less the cosine of the angle by which a level face may lean: 0.008 deg

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer found(shape, TopAbs_FACE); found.More(); found.Next())
        faces.push_back(TopoDS::Face(found.Current()));
    return faces;
}

double area_mm2(const TopoDS_Face& face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return properties.Mass();
}

// Returns true if `a` faces up more than `b`: along Z, then Y, then X.
bool looks_up_more(const gp_Dir& a, const gp_Dir& b) {
    constexpr double kSame = 1e-6;
    if (std::abs(a.Z() - b.Z()) > kSame) return a.Z() > b.Z();
    if (std::abs(a.Y() - b.Y()) > kSame) return a.Y() > b.Y();
    return a.X() > b.X() + kSame;
}

struct PlaneFace {
    double area_mm2 = 0;
    gp_Pnt place;
    gp_Dir normal;
};

bool is_better(const PlaneFace& a, const PlaneFace& b) {
    if (std::abs(a.area_mm2 - b.area_mm2) > kSameArea * b.area_mm2) return a.area_mm2 > b.area_mm2;
    return looks_up_more(a.normal, b.normal);
}

// Returns true if the normal points along "-x" or the like; empty: any normal.
bool looks_along(const gp_Dir& normal, std::string_view axis) {
    constexpr double kAlong = 0.999;
    if (axis.empty()) return true;
    const double sense = axis.front() == '-' ? -1 : 1;
    const char letter = axis.back();
    const double along = letter == 'x' ? normal.X() : letter == 'y' ? normal.Y() : normal.Z();
    return sense * along > kAlong;
}

// Returns the point on the other side, which is the farthest of the bodies.
gp_Pnt lowest_point(std::span<const TopoDS_Solid> solids, const PlateFrame& frame) {
    gp_Pnt lowest;
    double height_mm = 1;
    for (const TopoDS_Solid& solid : solids) {
        for (TopExp_Explorer found(solid, TopAbs_VERTEX); found.More(); found.Next()) {
            const gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(found.Current()));
            if (frame.height_mm(at) >= height_mm) continue;
            height_mm = frame.height_mm(at);
            lowest = at;
        }
    }
    return lowest;
}

}  // namespace

tl::expected<PlateFrame, std::string> find_plate(std::span<const TopoDS_Solid> solids,
                                                 const PlateOptions& options) {
    std::optional<PlaneFace> best;
    for (const TopoDS_Solid& solid : solids) {
        for (const TopoDS_Face& face : faces_of(solid)) {
            const auto plane = plane_of(face);
            if (!plane || !looks_along(plane->Axis().Direction(), options.along)) continue;
            const PlaneFace candidate{area_mm2(face), place_of(face), plane->Axis().Direction()};
            if (!best || is_better(candidate, *best)) best = candidate;
        }
    }
    if (!best) {
        return Fault(
            fmt::format("the body at {} has no plane face{}; only flat plates are cut",
                        shown(place_of(faces_of(solids.front()).front())),
                        options.along.empty() ? "" : fmt::format(" that looks along {}", options.along)));
    }
    const PlateFrame frame(best->place, best->normal);
    if (!options.flip) return frame;
    return PlateFrame(lowest_point(solids, frame), best->normal.Reversed());
}

SolidOutline::Done SolidOutline::refuse(const TopoDS_Face& face, const std::string& what) const {
    return Fault(fmt::format("{} {}", shown(face, file_), what));
}

// Sorts upper and lower faces, and all others.
SolidOutline::Done SolidOutline::sort_faces(const TopoDS_Solid& solid) {
    upper_.clear();
    lower_.clear();
    depths_mm_.clear();
    others_.clear();
    for (const TopoDS_Face& face : faces_of(solid)) {
        const auto plane = plane_of(face);
        const double rise = plane ? plane->Axis().Direction().Dot(frame_.up()) : 0;
        const double height_mm = frame_.height_mm(place_of(face));
        if (rise < -1 + kLevel) {
            lower_.push_back(face);
            depths_mm_.push_back(-height_mm);
        } else if (rise > 1 - kLevel) {
            if (std::abs(height_mm) > kSameHeight_mm) {
                return refuse(
                    face, fmt::format("lies {:.6g} mm {} the upper side; all of a plate's upper side is in "
                                      "one plane",
                                      std::abs(height_mm), height_mm > 0 ? "above" : "below"));
            }
            upper_.push_back(face);
        } else {
            others_.push_back(face);
        }
    }
    return {};
}

SolidOutline::Done SolidOutline::find_thickness() {
    if (lower_.empty() || upper_.empty()) {
        const TopoDS_Face& face =
            others_.empty() ? (lower_.empty() ? upper_ : lower_).front() : others_.front();
        return refuse(face, fmt::format("belongs to a body without {} side; a plate has two plane ones",
                                        upper_.empty() ? "an upper" : "a lower"));
    }
    for (std::size_t i = 0; i < lower_.size(); ++i) {
        const double depth_mm = std::round(depths_mm_[i] / kRound_mm) * kRound_mm;
        if (plate_.thickness_mm == 0) plate_.thickness_mm = depth_mm;
        if (std::abs(depth_mm - plate_.thickness_mm) <= kSameHeight_mm) continue;
        return refuse(
            lower_[i],
            fmt::format("lies {:.6g} mm below the upper side, but another one {:.6g} mm; a plate has "
                        "one thickness",
                        depth_mm, plate_.thickness_mm));
    }
    return {};
}

SolidOutline::Done SolidOutline::draw_edge(const TopoDS_Edge& edge, const TopoDS_Face& side) {
    const auto stretches = bevels_along(edge, side, frame_, plate_.thickness_mm);
    if (!stretches) return refuse(side, stretches.error());
    const BRepAdaptor_Curve curve(edge);
    const std::string label = file_.label(side);
    const std::string name = fmt::format("of {} face{}{}", kind_of(side), label.empty() ? "" : " ", label);
    for (const BevelStretch& stretch : *stretches) {
        if (auto drawn = pen_.draw(curve, stretch.from, stretch.to, name, stretch.bevel_deg); !drawn)
            return drawn;
    }
    return {};
}

SolidOutline::Done SolidOutline::draw_face(const TopoDS_Face& face, const Neighbours& faces_at) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        for (const TopoDS_Shape& neighbour : faces_at.FindFromKey(edge)) {
            const TopoDS_Face& side = TopoDS::Face(neighbour);
            const auto is_side = [&](const TopoDS_Face& other) { return other.IsSame(side); };
            // An edge between two parts of the upper side is not cut.
            if (std::any_of(upper_.begin(), upper_.end(), is_side)) continue;
            if (auto drawn = draw_edge(edge, side); !drawn) return drawn;
        }
    }
    return {};
}

SolidOutline::Done SolidOutline::add(const TopoDS_Solid& solid) {
    if (auto sorted = sort_faces(solid); !sorted) return sorted;
    if (auto found = find_thickness(); !found) return found;
    Neighbours faces_at;
    TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_at);
    TopTools_MapOfShape at_upper_edges;
    for (const TopoDS_Face& face : upper_) {
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            for (const TopoDS_Shape& neighbour : faces_at.FindFromKey(edges.Current()))
                at_upper_edges.Add(neighbour);
        }
    }
    for (const TopoDS_Face& face : others_) {
        if (!at_upper_edges.Contains(face))
            return refuse(face, "has no edge in the upper side: it is not reached by a jet from there");
    }
    for (const TopoDS_Face& face : upper_) {
        if (auto drawn = draw_face(face, faces_at); !drawn) return drawn;
    }
    return {};
}

}  // namespace gsim::solid
