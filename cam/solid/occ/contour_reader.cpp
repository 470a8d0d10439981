#include "cam/solid/occ/contour_reader.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "cam/solid/occ/chain_reader.h"
#include "cam/solid/occ/edge_selection.h"
#include "cam/solid/occ/face.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

namespace {

// A loop that may be cut.
struct Candidate {
    TopoDS_Face face;
    FaceLoop loop;
    double area_mm2 = 0;  ///< Area of the face.
};

// Returns how much a face faces a side, -1 to 1, on average along a loop.
double facing_component(const WallContour& contour, std::string_view side) {
    const double sense = side.front() == '-' ? -1 : 1;
    const auto axis = static_cast<std::size_t>(side.back() - 'x');
    double sum = 0;
    std::size_t count = 0;
    for (const WallEdge& edge : contour.edges) {
        for (const WallPoint& point : edge.points) sum += sense * point.normal[axis];
        count += edge.points.size();
    }
    return sum / static_cast<double>(count);
}

class ContourReader {
  public:
    ContourReader(const ShapeFile& file, const ContourOptions& options)
        : file_(file), options_(options), edges_(file, options.edges) {}

    Result<WallContours> run(const Bodies& bodies) {
        for (const TopoDS_Solid& solid : bodies.solids) {
            if (auto result = add(solid); !result) return Unexpected(result.error());
        }
        for (const auto& [face, known] : requested_faces_) {
            if (!known)
                return Unexpected(
                    fmt::format("it has no face with the number, name, layer or colour '{}'", face));
        }
        if (auto error = edges_.find_error()) return Unexpected(*std::move(error));
        add_skipped_notes(bodies);
        if (found_.contours.empty()) return Unexpected(nothing_found_message());
        return std::move(found_);
    }

  private:
    bool is_requested(const TopoDS_Face& face) {
        if (options_.faces.empty()) return true;
        bool any = false;
        for (const std::string& name : options_.faces) {
            const bool same = file_.matches_name(face, name);
            requested_faces_[name] = requested_faces_[name] || same;
            any |= same;
        }
        return any;
    }

    Result<void> add(const TopoDS_Solid& solid) {
        EdgeFaceMap edge_faces;
        TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, edge_faces);
        const ContourTracer walk(file_, solid, edge_faces, options_);
        edges_.find_edges_in(solid);
        TopTools_MapOfShape walls;
        for (const Candidate& candidate : candidates(solid)) {
            // A face along which the jet cuts is not entered as well.
            if (options_.faces.empty() && walls.Contains(candidate.face)) continue;
            auto contour = walk.walk(candidate.face, candidate.loop);
            if (!contour) {
                if (auto left = leave_out(candidate, contour.error().message); !left) return left;
            } else if (facing_component(*contour, options_.side) <= kMinFacing) {
                edges_.mark_rejected(candidate.loop.edges,
                                     fmt::format("it belongs to one that does not face {}", options_.side));
                if (edges_.accepts_any()) ++other_side_count_;
            } else {
                if (edges_.accepts(candidate.loop.edges)) found_.contours.push_back(*std::move(contour));
                edges_.mark_cut(candidate.loop.edges);
                for (const TopoDS_Edge& edge : candidate.loop.edges) {
                    for (const TopoDS_Shape& face : edge_faces.FindFromKey(edge)) {
                        if (!face.IsSame(candidate.face)) walls.Add(face);
                    }
                }
            }
        }
        return {};
    }

    // Returns the selected loops: holes first, and those of large faces, because walls are small.
    std::vector<Candidate> candidates(const TopoDS_Solid& solid) {
        std::vector<Candidate> found;
        for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
            const TopoDS_Face& face = TopoDS::Face(faces.Current());
            if (!is_requested(face)) continue;
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(face, properties);
            for (FaceLoop& loop : face_loops(face)) {
                if (options_.kind != "all" && (options_.kind == "holes") != loop.is_hole) continue;
                if (options_.box_mm && !is_within_box(loop.edges, *options_.box_mm)) continue;
                found.push_back({face, std::move(loop), properties.Mass()});
            }
        }
        std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
            if (a.loop.is_hole != b.loop.is_hole) return a.loop.is_hole;
            return a.area_mm2 > b.area_mm2;
        });
        return found;
    }

    // Reports a loop that is not a contour, or returns an error if its face was requested.
    Result<void> leave_out(const Candidate& candidate, const std::string& reason) {
        if (!is_facing(candidate.face)) return {};
        std::string message = fmt::format("{} of {} {}", candidate.loop.is_hole ? "a hole" : "the outline",
                                          display_text(candidate.face, file_), reason);
        edges_.mark_rejected(candidate.loop.edges, message);
        if (!edges_.accepts_any()) return {};
        if (!options_.faces.empty()) return Unexpected(std::move(message));
        skipped_.push_back(std::move(message));
        return {};
    }

    // Uses one normal, because loops that are not contours have no others.
    bool is_facing(const TopoDS_Face& face) const {
        double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
        BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
        const auto normal = outward_normal(face, (u_low + u_high) / 2, (v_low + v_high) / 2);
        const double sense = options_.side.front() == '-' ? -1 : 1;
        return normal && sense * normal->Coord(options_.side.back() - 'x' + 1) > kMinFacing;
    }

    void add_skipped_notes(const Bodies& bodies) {
        for (const std::string& message : skipped_) found_.notes.push_back(message + "; it is not cut");
        if (other_side_count_ > 0) {
            found_.notes.push_back(
                fmt::format("{} contours do not face {}, and are not cut", other_side_count_, options_.side));
        }
        if (!bodies.faces.empty())
            found_.notes.push_back(
                fmt::format("{} surfaces that are not part of a body are ignored", bodies.faces.size()));
    }

    std::string nothing_found_message() const {
        if (!skipped_.empty()) return skipped_.front();
        return fmt::format(
            "no {} of the selected faces faces {}",
            options_.kind == "all" ? "contour" : options_.kind.substr(0, options_.kind.size() - 1),
            options_.side);
    }

    const ShapeFile& file_;
    const ContourOptions& options_;
    WallContours found_;
    std::vector<std::string> skipped_;
    std::size_t other_side_count_ = 0;
    EdgeSelection edges_;
    std::map<std::string, bool> requested_faces_;
};

// Sets the box about all bodies.
void set_bounding_box(const Bodies& bodies, WallContours& contours) {
    Bnd_Box box;
    for (const TopoDS_Solid& solid : bodies.solids) BRepBndLib::AddOptimal(solid, box, false, false);
    box.Get(contours.low_mm[0], contours.low_mm[1], contours.low_mm[2], contours.high_mm[0],
            contours.high_mm[1], contours.high_mm[2]);
}

}  // namespace

Result<WallContours> extract_contours(const ShapeFile& file, const ContourOptions& options) {
    const Bodies bodies = sort_bodies(file.shape());
    if (bodies.solids.empty()) return Unexpected("it contains no body; only contours of bodies can be cut");
    auto found = options.kind == "edges" ? extract_chains(file, bodies, options)
                                         : ContourReader(file, options).run(bodies);
    if (found) set_bounding_box(bodies, *found);
    return found;
}

}  // namespace gsim::solid
