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
#include "cam/solid/occ/edge_selection.h"
#include "cam/solid/occ/face.h"
#include "cam/solid/occ/plate_frame.h"
#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

namespace {

constexpr double kMaxRotation_rad = 10 * kRadPerDeg;  // from one point of another edge to the next

class ChainReader {
  public:
    ChainReader(const ShapeFile& file, const ContourOptions& options)
        : file_(file), options_(options), selection_(file, options.edges) {}

    Result<WallContours> run(const Bodies& bodies) {
        for (const TopoDS_Solid& solid : bodies.solids) {
            if (auto result = add(solid); !result) return Unexpected(result.error());
        }
        if (auto error = selection_.find_error()) return Unexpected(*std::move(error));
        if (found_.contours.empty()) return Unexpected("no edge is selected");
        return std::move(found_);
    }

  private:
    Result<void> add(const TopoDS_Solid& solid) {
        const std::vector<TopoDS_Edge> edges = selection_.find_edges_in(solid);
        if (edges.empty()) return {};
        EdgeFaceMap edge_faces;
        TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, edge_faces);
        const ContourTracer walk(file_, solid, edge_faces, options_);
        std::vector<ChainEdge> chain_edges;
        std::vector<TopoDS_Face> entry_faces;
        for (const TopoDS_Edge& edge : edges) {
            auto found = trace_edge(walk, edge, edge_faces, entry_faces);
            if (!found) return Unexpected(found.error());
            chain_edges.push_back(*std::move(found));
        }
        auto chains = chain(chain_edges);
        if (!chains) return Unexpected(chains.error());
        for (const EdgeChain& each : *chains) {
            if (auto result = add_contour(each, chain_edges, entry_faces); !result) return result;
        }
        selection_.mark_cut(edges);
        add_other_edges(edges, entry_faces, edge_faces);
        return {};
    }

    // Uses the one of the edge's two faces that faces the side most, of those below which a jet could pass.
    Result<ChainEdge> trace_edge(const ContourTracer& walk, const TopoDS_Edge& edge,
                                 const EdgeFaceMap& edge_faces, std::vector<TopoDS_Face>& entry_faces) const {
        const std::string begin =
            fmt::format("edge {} at {}", file_.label(edge), display_text(edge_middle(edge)));
        if (options_.box_mm && !is_within_box({edge}, *options_.box_mm))
            return Unexpected(begin + " is not in the box (--box-low, --box-high)");
        std::vector<std::pair<double, TopoDS_Face>> candidates;
        for (const TopoDS_Shape& each : edge_faces.FindFromKey(edge)) {
            const TopoDS_Face& face = TopoDS::Face(each);
            if (is_requested(face)) candidates.emplace_back(facing_component(edge, face), face);
        }
        if (candidates.empty()) return Unexpected(begin + " does not belong to a selected face (--face)");
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        std::string reason;
        for (const auto& [sharpness, face] : candidates) {
            if (sharpness <= kMinFacing) break;
            auto found = walk.trace_edge(edge, face);
            if (found) {
                entry_faces.push_back(face);
                return found;
            }
            if (reason.empty())
                reason = fmt::format("from {} it {}", display_text(face, file_), found.error().message);
        }
        if (reason.empty()) {
            reason = fmt::format("no adjacent face faces this side: {}",
                                 display_text(candidates.front().second, file_));
            if (candidates.size() > 1)
                reason += fmt::format(", {}", display_text(candidates.back().second, file_));
        }
        return Unexpected(fmt::format("{} cannot be entered from {}: {}", begin, options_.side, reason));
    }

    bool is_requested(const TopoDS_Face& face) const {
        return options_.faces.empty() ||
               std::any_of(options_.faces.begin(), options_.faces.end(),
                           [&](const std::string& name) { return file_.matches_name(face, name); });
    }

    static gp_Pnt edge_middle(const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        return curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    }

    // Returns how much a face faces the side next to an edge, -1 to 1, on average.
    double facing_component(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
        const BRepAdaptor_Curve2d curve(edge, face);
        const double sense = options_.side.front() == '-' ? -1 : 1;
        const int axis = options_.side.back() - 'x' + 1;
        constexpr std::array kShares{0.1, 0.3, 0.5, 0.7, 0.9};
        double sum = 0;
        for (const double share : kShares) {
            const double at =
                curve.FirstParameter() + share * (curve.LastParameter() - curve.FirstParameter());
            const gp_Pnt2d position = curve.Value(at);
            if (const auto normal = outward_normal(face, position.X(), position.Y()))
                sum += normal->Coord(axis);
        }
        return sense * sum / kShares.size();
    }

    Result<void> add_contour(const EdgeChain& chain, const std::vector<ChainEdge>& chain_edges,
                             const std::vector<TopoDS_Face>& entry_faces) {
        WallContour contour{.face = display_text(entry_faces[chain.edges.front()], file_)};
        for (const std::size_t edge : chain.edges) contour.edges.push_back(chain_edges[edge].edge);
        contour.is_open = !chain.is_closed;
        contour.is_hole = chain.is_closed && is_hole(contour);
        if (const auto blind = ContourTracer::find_blind_wall(contour))
            return Unexpected(fmt::format("a chain of edges of {} {}", contour.face, blind->message));
        found_.contours.push_back(std::move(contour));
        return {};
    }

    // Adds all edges of the body except those that are cut and the lower ends of their walls, along which the
    // jet runs.
    void add_other_edges(const std::vector<TopoDS_Edge>& cut, const std::vector<TopoDS_Face>& entry_faces,
                         const EdgeFaceMap& edge_faces) {
        TopTools_MapOfShape contour_edges, above, walls;
        for (const TopoDS_Edge& edge : cut) contour_edges.Add(edge);
        for (const TopoDS_Face& face : entry_faces) above.Add(face);
        for (const TopoDS_Edge& edge : cut) {
            for (const TopoDS_Shape& face : edge_faces.FindFromKey(edge)) {
                if (!above.Contains(face)) walls.Add(face);
            }
        }
        const auto belongs_to_any = [](const TopTools_ListOfShape& faces,
                                       const TopTools_MapOfShape& requested) {
            return std::any_of(faces.begin(), faces.end(),
                               [&](const TopoDS_Shape& face) { return requested.Contains(face); });
        };
        for (int i = 1; i <= edge_faces.Extent(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(edge_faces.FindKey(i));
            const bool is_opposite_end =
                belongs_to_any(edge_faces(i), walls) && !belongs_to_any(edge_faces(i), above);
            if (contour_edges.Contains(edge) || is_opposite_end || BRep_Tool::Degenerated(edge)) continue;
            const std::string label = file_.label(edge);
            found_.other_edges.push_back({label.empty() ? "an edge" : "edge " + label, edge_points(edge)});
        }
    }

    std::vector<Vec3> edge_points(const TopoDS_Edge& edge) const {
        const BRepAdaptor_Curve curve(edge);
        const GCPnts_TangentialDeflection points(curve, kMaxRotation_rad, options_.tolerance_mm);
        std::vector<Vec3> found;
        for (int i = 1; i <= points.NbPoints(); ++i) {
            const gp_Pnt at = points.Value(i);
            found.push_back({at.X(), at.Y(), at.Z()});
        }
        return found;
    }

    const ShapeFile& file_;
    const ContourOptions& options_;
    EdgeSelection selection_;
    WallContours found_;
};

}  // namespace

Result<WallContours> extract_chains(const ShapeFile& file, const Bodies& bodies,
                                    const ContourOptions& options) {
    return ChainReader(file, options).run(bodies);
}

}  // namespace gsim::solid
