#include "cam/solid/occ/plate_outline_builder.h"

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

constexpr double kAreaTolerance = 1e-6;
constexpr double kThicknessStep_mm = 1e-6;  // of the thickness, which reports show
constexpr double kLevelTolerance =
    1e-8;  // 1 less the cosine of the angle by which a level face may lean: 0.008 deg

std::vector<TopoDS_Face> shape_faces(const TopoDS_Shape& shape) {
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
bool faces_up_more(const gp_Dir& a, const gp_Dir& b) {
    constexpr double kEqualTolerance = 1e-6;
    if (std::abs(a.Z() - b.Z()) > kEqualTolerance) return a.Z() > b.Z();
    if (std::abs(a.Y() - b.Y()) > kEqualTolerance) return a.Y() > b.Y();
    return a.X() > b.X() + kEqualTolerance;
}

struct PlaneFace {
    double area_mm2 = 0;
    gp_Pnt position;
    gp_Dir normal;
};

bool is_better(const PlaneFace& a, const PlaneFace& b) {
    if (std::abs(a.area_mm2 - b.area_mm2) > kAreaTolerance * b.area_mm2) return a.area_mm2 > b.area_mm2;
    return faces_up_more(a.normal, b.normal);
}

// Returns true if the normal points along "-x" or the like; empty: any normal.
bool faces_along(const gp_Dir& normal, std::string_view axis) {
    constexpr double kMinAlignment = 0.999;
    if (axis.empty()) return true;
    const double sense = axis.front() == '-' ? -1 : 1;
    const char letter = axis.back();
    const double facing_axis = letter == 'x' ? normal.X() : letter == 'y' ? normal.Y() : normal.Z();
    return sense * facing_axis > kMinAlignment;
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

Result<PlateFrame> find_plate(std::span<const TopoDS_Solid> solids, const PlateOptions& options) {
    std::optional<PlaneFace> best;
    for (const TopoDS_Solid& solid : solids) {
        for (const TopoDS_Face& face : shape_faces(solid)) {
            const auto plane = face_plane(face);
            if (!plane || !faces_along(plane->Axis().Direction(), options.facing_axis)) continue;
            const PlaneFace candidate{area_mm2(face), face_point(face), plane->Axis().Direction()};
            if (!best || is_better(candidate, *best)) best = candidate;
        }
    }
    if (!best) {
        return Unexpected(fmt::format(
            "the body at {} has no planar face{}; only flat plates can be cut",
            display_text(face_point(shape_faces(solids.front()).front())),
            options.facing_axis.empty() ? "" : fmt::format(" that faces {}", options.facing_axis)));
    }
    const PlateFrame frame(best->position, best->normal);
    if (!options.flip) return frame;
    return PlateFrame(lowest_point(solids, frame), best->normal.Reversed());
}

Result<void> PlateOutlineBuilder::reject(const TopoDS_Face& face, const std::string& what) const {
    return Unexpected(fmt::format("{} {}", display_text(face, file_), what));
}

// Sorts upper and lower faces, and all others.
Result<void> PlateOutlineBuilder::sort_faces(const TopoDS_Solid& solid) {
    upper_.clear();
    lower_.clear();
    depths_mm_.clear();
    other_faces_.clear();
    for (const TopoDS_Face& face : shape_faces(solid)) {
        const auto plane = face_plane(face);
        const double rise = plane ? plane->Axis().Direction().Dot(frame_.up()) : 0;
        const double height_mm = frame_.height_mm(face_point(face));
        if (rise < -1 + kLevelTolerance) {
            lower_.push_back(face);
            depths_mm_.push_back(-height_mm);
        } else if (rise > 1 - kLevelTolerance) {
            if (std::abs(height_mm) > kHeightTolerance_mm) {
                return reject(
                    face,
                    fmt::format(
                        "is {:.6g} mm {} the upper side; the upper side of a plate must be in one plane",
                        std::abs(height_mm), height_mm > 0 ? "above" : "below"));
            }
            upper_.push_back(face);
        } else {
            other_faces_.push_back(face);
        }
    }
    return {};
}

Result<void> PlateOutlineBuilder::find_thickness() {
    if (lower_.empty() || upper_.empty()) {
        const TopoDS_Face& face =
            other_faces_.empty() ? (lower_.empty() ? upper_ : lower_).front() : other_faces_.front();
        return reject(face,
                      fmt::format("belongs to a body without {} side; a plate must have two planar sides",
                                  upper_.empty() ? "an upper" : "a lower"));
    }
    for (std::size_t i = 0; i < lower_.size(); ++i) {
        const double depth_mm = std::round(depths_mm_[i] / kThicknessStep_mm) * kThicknessStep_mm;
        if (plate_.thickness_mm == 0) plate_.thickness_mm = depth_mm;
        if (std::abs(depth_mm - plate_.thickness_mm) <= kHeightTolerance_mm) continue;
        return reject(lower_[i], fmt::format("is {:.6g} mm below the upper side, but another one {:.6g} mm; "
                                             "a plate must have one thickness",
                                             depth_mm, plate_.thickness_mm));
    }
    return {};
}

Result<void> PlateOutlineBuilder::draw_edge(const TopoDS_Edge& edge, const TopoDS_Face& side) {
    const auto sections = edge_bevels(edge, side, frame_, plate_.thickness_mm);
    if (!sections) return reject(side, sections.error().message);
    const BRepAdaptor_Curve curve(edge);
    const std::string label = file_.label(side);
    const std::string name =
        fmt::format("of {} face{}{}", surface_kind(side), label.empty() ? "" : " ", label);
    for (const BevelInterval& section : *sections) {
        if (auto result = pen_.draw(curve, section.from, section.to, name, section.bevel_deg); !result)
            return result;
    }
    return {};
}

Result<void> PlateOutlineBuilder::draw_face(const TopoDS_Face& face, const Neighbours& edge_faces) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        for (const TopoDS_Shape& neighbour : edge_faces.FindFromKey(edge)) {
            const TopoDS_Face& side = TopoDS::Face(neighbour);
            const auto is_side = [&](const TopoDS_Face& other) { return other.IsSame(side); };
            // An edge between two parts of the upper side is not cut.
            if (std::any_of(upper_.begin(), upper_.end(), is_side)) continue;
            if (auto result = draw_edge(edge, side); !result) return result;
        }
    }
    return {};
}

Result<void> PlateOutlineBuilder::add(const TopoDS_Solid& solid) {
    if (auto sorted = sort_faces(solid); !sorted) return sorted;
    if (auto found = find_thickness(); !found) return found;
    Neighbours edge_faces;
    TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, edge_faces);
    TopTools_MapOfShape upper_edge_faces;
    for (const TopoDS_Face& face : upper_) {
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            for (const TopoDS_Shape& neighbour : edge_faces.FindFromKey(edges.Current()))
                upper_edge_faces.Add(neighbour);
        }
    }
    for (const TopoDS_Face& face : other_faces_) {
        if (!upper_edge_faces.Contains(face))
            return reject(face, "has no edge on the upper side: a jet cannot reach it from there");
    }
    for (const TopoDS_Face& face : upper_) {
        if (auto result = draw_face(face, edge_faces); !result) return result;
    }
    return {};
}

}  // namespace gsim::solid
