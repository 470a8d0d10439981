#include "cam/solid/occ/chain_reader.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <TopExp.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/solid/occ/edge_chains.h"
#include "cam/solid/occ/edge_choice.h"
#include "cam/solid/occ/face.h"
#include "cam/solid/occ/plate_frame.h"
#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr double kMostTurn_rad = 10 * kRadPerDeg;  // from one point of another edge to the next

class ChainReader {
  public:
    ChainReader(const ShapeFile& file, const ContourOptions& options)
        : file_(file), options_(options), choice_(file, options.edges) {}

    tl::expected<WallContours, std::string> run(const Bodies& bodies) {
        for (const TopoDS_Solid& solid : bodies.solids) {
            if (auto added = add(solid); !added) return Fault(added.error());
        }
        if (auto fault = choice_.find_fault()) return Fault(*std::move(fault));
        if (found_.contours.empty()) return Fault("no edge is asked for");
        return std::move(found_);
    }

  private:
    tl::expected<void, std::string> add(const TopoDS_Solid& solid) {
        const std::vector<TopoDS_Edge> edges = choice_.find_in(solid);
        if (edges.empty()) return {};
        FacesOfEdges faces_of;
        TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
        const ContourWalk walk(file_, solid, faces_of, options_);
        std::vector<EdgeAlone> alone;
        std::vector<TopoDS_Face> entered;
        for (const TopoDS_Edge& edge : edges) {
            auto found = walk_along(walk, edge, faces_of, entered);
            if (!found) return Fault(found.error());
            alone.push_back(*std::move(found));
        }
        auto chains = chain(alone);
        if (!chains) return Fault(chains.error());
        for (const EdgeChain& each : *chains) {
            if (auto added = add_contour(each, alone, entered); !added) return added;
        }
        choice_.mark_cut(edges);
        add_others(edges, entered, faces_of);
        return {};
    }

    // Uses the one of the edge's two faces that faces the side most, of those below which a jet could pass.
    tl::expected<EdgeAlone, std::string> walk_along(const ContourWalk& walk, const TopoDS_Edge& edge,
                                                    const FacesOfEdges& faces_of,
                                                    std::vector<TopoDS_Face>& entered) const {
        const std::string begin = fmt::format("edge {} at {}", file_.label(edge), shown(middle_of(edge)));
        if (options_.box_mm && !lies_within({edge}, *options_.box_mm))
            return Fault(begin + " does not lie in the box (--box-low, --box-high)");
        std::vector<std::pair<double, TopoDS_Face>> looks;
        for (const TopoDS_Shape& each : faces_of.FindFromKey(edge)) {
            const TopoDS_Face& face = TopoDS::Face(each);
            if (is_asked_for(face)) looks.emplace_back(look_of(edge, face), face);
        }
        if (looks.empty()) return Fault(begin + " is of none of the faces that were chosen (--face)");
        std::stable_sort(looks.begin(), looks.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        std::string why;
        for (const auto& [look, face] : looks) {
            if (look <= kLeastLook) break;
            auto found = walk.walk_along(edge, face);
            if (found) {
                entered.push_back(face);
                return found;
            }
            if (why.empty()) why = fmt::format("from {} it {}", shown(face, file_), found.error());
        }
        if (why.empty()) {
            why = fmt::format("no face beside it looks there: {}", shown(looks.front().second, file_));
            if (looks.size() > 1) why += fmt::format(", {}", shown(looks.back().second, file_));
        }
        return Fault(fmt::format("{} cannot be entered from {}: {}", begin, options_.side, why));
    }

    bool is_asked_for(const TopoDS_Face& face) const {
        return options_.faces.empty() ||
               std::any_of(options_.faces.begin(), options_.faces.end(),
                           [&](const std::string& name) { return file_.goes_by(face, name); });
    }

    static gp_Pnt middle_of(const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        return curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    }

    // Returns how much a face faces the side next to an edge, -1 to 1, on average.
    double look_of(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
        const BRepAdaptor_Curve2d curve(edge, face);
        const double sense = options_.side.front() == '-' ? -1 : 1;
        const int axis = options_.side.back() - 'x' + 1;
        constexpr std::array kShares{0.1, 0.3, 0.5, 0.7, 0.9};
        double sum = 0;
        for (const double share : kShares) {
            const double at =
                curve.FirstParameter() + share * (curve.LastParameter() - curve.FirstParameter());
            const gp_Pnt2d place = curve.Value(at);
            if (const auto normal = outward_normal(face, place.X(), place.Y())) sum += normal->Coord(axis);
        }
        return sense * sum / kShares.size();
    }

    tl::expected<void, std::string> add_contour(const EdgeChain& chain, const std::vector<EdgeAlone>& alone,
                                                const std::vector<TopoDS_Face>& entered) {
        WallContour contour{.face = shown(entered[chain.edges.front()], file_)};
        for (const std::size_t edge : chain.edges) contour.edges.push_back(alone[edge].edge);
        contour.is_open = !chain.is_closed;
        contour.is_hole = chain.is_closed && is_hole(contour);
        if (const auto blind = ContourWalk::find_blind(contour))
            return Fault(fmt::format("a chain of edges of {} {}", contour.face, *blind));
        found_.contours.push_back(std::move(contour));
        return {};
    }

    // Adds all edges of the body except those that are cut and the lower ends of their walls, along which the
    // jet runs.
    void add_others(const std::vector<TopoDS_Edge>& cut, const std::vector<TopoDS_Face>& entered,
                    const FacesOfEdges& faces_of) {
        TopTools_MapOfShape own, above, walls;
        for (const TopoDS_Edge& edge : cut) own.Add(edge);
        for (const TopoDS_Face& face : entered) above.Add(face);
        for (const TopoDS_Edge& edge : cut) {
            for (const TopoDS_Shape& face : faces_of.FindFromKey(edge)) {
                if (!above.Contains(face)) walls.Add(face);
            }
        }
        const auto is_of = [](const TopTools_ListOfShape& faces, const TopTools_MapOfShape& asked) {
            return std::any_of(faces.begin(), faces.end(),
                               [&](const TopoDS_Shape& face) { return asked.Contains(face); });
        };
        for (int i = 1; i <= faces_of.Extent(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
            const bool is_end = is_of(faces_of(i), walls) && !is_of(faces_of(i), above);
            if (own.Contains(edge) || is_end || BRep_Tool::Degenerated(edge)) continue;
            const std::string label = file_.label(edge);
            found_.other_edges.push_back({label.empty() ? "an edge" : "edge " + label, points_of(edge)});
        }
    }

    std::vector<Triple> points_of(const TopoDS_Edge& edge) const {
        const BRepAdaptor_Curve curve(edge);
        const GCPnts_TangentialDeflection points(curve, kMostTurn_rad, options_.tolerance_mm);
        std::vector<Triple> found;
        for (int i = 1; i <= points.NbPoints(); ++i) {
            const gp_Pnt at = points.Value(i);
            found.push_back({at.X(), at.Y(), at.Z()});
        }
        return found;
    }

    const ShapeFile& file_;
    const ContourOptions& options_;
    EdgeChoice choice_;
    WallContours found_;
};

}  // namespace

tl::expected<WallContours, std::string> chains_of(const ShapeFile& file, const Bodies& bodies,
                                                  const ContourOptions& options) {
    return ChainReader(file, options).run(bodies);
}

}  // namespace gsim::solid
