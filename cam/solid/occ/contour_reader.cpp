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
#include "cam/solid/occ/edge_choice.h"
#include "cam/solid/occ/face.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

// A loop that may be cut.
struct Candidate {
    TopoDS_Face face;
    FaceLoop loop;
    double area_mm2 = 0;  ///< Area of the face.
};

// Returns how much a face faces a side, -1 to 1, on average along a loop.
double look_of(const WallContour& contour, std::string_view side) {
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

class Reader {
  public:
    Reader(const ShapeFile& file, const ContourOptions& options)
        : file_(file), options_(options), edges_(file, options.edges) {}

    tl::expected<WallContours, std::string> run(const Bodies& bodies) {
        for (const TopoDS_Solid& solid : bodies.solids) {
            if (auto added = add(solid); !added) return Fault(added.error());
        }
        for (const auto& [face, known] : asked_) {
            if (!known)
                return Fault(fmt::format("it has no face with the number, name, layer or colour '{}'", face));
        }
        if (auto fault = edges_.find_fault()) return Fault(*std::move(fault));
        tell_rest(bodies);
        if (found_.contours.empty()) return Fault(nothing_found());
        return std::move(found_);
    }

  private:
    bool is_asked_for(const TopoDS_Face& face) {
        if (options_.faces.empty()) return true;
        bool any = false;
        for (const std::string& name : options_.faces) {
            const bool same = file_.goes_by(face, name);
            asked_[name] = asked_[name] || same;
            any |= same;
        }
        return any;
    }

    tl::expected<void, std::string> add(const TopoDS_Solid& solid) {
        FacesOfEdges faces_of;
        TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
        const ContourWalk walk(file_, solid, faces_of, options_);
        edges_.find_in(solid);
        TopTools_MapOfShape walls;
        for (const Candidate& candidate : candidates(solid)) {
            // A face along which the jet cuts is not entered as well.
            if (options_.faces.empty() && walls.Contains(candidate.face)) continue;
            auto contour = walk.walk(candidate.face, candidate.loop);
            if (!contour) {
                if (auto left = leave_out(candidate, contour.error()); !left) return left;
            } else if (look_of(*contour, options_.side) <= kLeastLook) {
                edges_.mark_refused(
                    candidate.loop.edges,
                    fmt::format("it is of one that looks to another side than {}", options_.side));
                if (edges_.takes_any()) ++other_sides_;
            } else {
                if (edges_.takes(candidate.loop.edges)) found_.contours.push_back(*std::move(contour));
                edges_.mark_cut(candidate.loop.edges);
                for (const TopoDS_Edge& edge : candidate.loop.edges) {
                    for (const TopoDS_Shape& face : faces_of.FindFromKey(edge)) {
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
            if (!is_asked_for(face)) continue;
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(face, properties);
            for (FaceLoop& loop : loops_of(face)) {
                if (options_.kind != "all" && (options_.kind == "holes") != loop.is_hole) continue;
                if (options_.box_mm && !lies_within(loop.edges, *options_.box_mm)) continue;
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
    tl::expected<void, std::string> leave_out(const Candidate& candidate, const std::string& why) {
        if (!looks_there(candidate.face)) return {};
        std::string sentence = fmt::format("{} of {} {}", candidate.loop.is_hole ? "a hole" : "the outline",
                                           shown(candidate.face, file_), why);
        edges_.mark_refused(candidate.loop.edges, sentence);
        if (!edges_.takes_any()) return {};
        if (!options_.faces.empty()) return Fault(std::move(sentence));
        left_out_.push_back(std::move(sentence));
        return {};
    }

    // Uses one normal, because loops that are not contours have no others.
    bool looks_there(const TopoDS_Face& face) const {
        double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
        BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
        const auto normal = outward_normal(face, (u_low + u_high) / 2, (v_low + v_high) / 2);
        const double sense = options_.side.front() == '-' ? -1 : 1;
        return normal && sense * normal->Coord(options_.side.back() - 'x' + 1) > kLeastLook;
    }

    void tell_rest(const Bodies& bodies) {
        for (const std::string& sentence : left_out_) found_.notes.push_back(sentence + "; it is not cut");
        if (other_sides_ > 0) {
            found_.notes.push_back(fmt::format("{} contours look to another side than {}, and are not cut",
                                               other_sides_, options_.side));
        }
        if (!bodies.faces.empty())
            found_.notes.push_back(
                fmt::format("{} surfaces beside the bodies are left out", bodies.faces.size()));
    }

    std::string nothing_found() const {
        if (!left_out_.empty()) return left_out_.front();
        return fmt::format(
            "no {} of its faces that was chosen looks to {}",
            options_.kind == "all" ? "contour" : options_.kind.substr(0, options_.kind.size() - 1),
            options_.side);
    }

    const ShapeFile& file_;
    const ContourOptions& options_;
    WallContours found_;
    std::vector<std::string> left_out_;
    std::size_t other_sides_ = 0;
    EdgeChoice edges_;
    std::map<std::string, bool> asked_;
};

// Sets the box about all bodies.
void put_box(const Bodies& bodies, WallContours& contours) {
    Bnd_Box box;
    for (const TopoDS_Solid& solid : bodies.solids) BRepBndLib::AddOptimal(solid, box, false, false);
    box.Get(contours.low_mm[0], contours.low_mm[1], contours.low_mm[2], contours.high_mm[0],
            contours.high_mm[1], contours.high_mm[2]);
}

}  // namespace

tl::expected<WallContours, std::string> contours_of(const ShapeFile& file, const ContourOptions& options) {
    const Bodies bodies = sort_bodies(file.shape());
    if (bodies.solids.empty()) return Fault("there is no body in it; contours are those of bodies");
    auto found =
        options.kind == "edges" ? chains_of(file, bodies, options) : Reader(file, options).run(bodies);
    if (found) put_box(bodies, *found);
    return found;
}

}  // namespace gsim::solid
