#include "cam/solid/occ/edge_chains.h"

#include <BRep_Tool.hxx>
#include <gp_Vec.hxx>
#include <optional>

#include <fmt/format.h>

#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

namespace {

class EdgeChainer {
  public:
    explicit EdgeChainer(const std::vector<ChainEdge>& edges) : edges_(edges), used_(edges.size()) {}

    Result<std::vector<EdgeChain>> run() {
        for (const ChainEdge& edge : edges_) {
            if (auto error = find_branch_error(edge.end)) return tl::unexpected(*std::move(error));
        }
        std::vector<EdgeChain> chains;
        // Open chains come first, so the remaining ones are closed.
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (count(edges_[i].begin, &ChainEdge::end) == 0) chains.push_back(trace_chain(i));
        }
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (!used_[i]) chains.push_back(trace_chain(i));
        }
        return chains;
    }

  private:
    std::size_t count(const TopoDS_Vertex& at, TopoDS_Vertex ChainEdge::*vertex_member) const {
        std::size_t found = 0;
        for (const ChainEdge& edge : edges_) found += (edge.*vertex_member).IsSame(at) ? 1 : 0;
        return found;
    }

    std::optional<Error> find_branch_error(const TopoDS_Vertex& at) const {
        const std::size_t ends = count(at, &ChainEdge::end);
        const std::size_t begin_count = count(at, &ChainEdge::begin);
        if (begin_count == 0 || ends + begin_count < 3) return std::nullopt;
        std::string names;
        for (const ChainEdge& edge : edges_) {
            if (!edge.begin.IsSame(at) && !edge.end.IsSame(at)) continue;
            names += (names.empty() ? "" : ", ") + edge.edge.name;
        }
        return fmt::format("a chain of edges must not branch: at {} there are {}",
                           display_text(BRep_Tool::Pnt(at)), names);
    }

    EdgeChain trace_chain(std::size_t first) {
        EdgeChain chain;
        std::optional<std::size_t> at = first;
        while (at && !used_[*at]) {
            used_[*at] = true;
            chain.edges.push_back(*at);
            at = next_edge(*at);
        }
        chain.is_closed = at == first;
        return chain;
    }

    std::optional<std::size_t> next_edge(std::size_t edge) const {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (edges_[i].begin.IsSame(edges_[edge].end)) return i;
        }
        return std::nullopt;
    }

    const std::vector<ChainEdge>& edges_;
    std::vector<bool> used_;
};

gp_Vec to_vector(const Vec3& vec) {
    return {vec[0], vec[1], vec[2]};
}

}  // namespace

Result<std::vector<EdgeChain>> chain(const std::vector<ChainEdge>& edges) {
    return EdgeChainer(edges).run();
}

bool is_hole(const WallContour& closed) {
    const gp_Vec first = to_vector(closed.edges.front().points.front().position_mm);
    gp_Vec area(0, 0, 0);
    gp_Vec normal(0, 0, 0);
    for (const WallEdge& edge : closed.edges) {
        for (std::size_t i = 1; i < edge.points.size(); ++i) {
            area += (to_vector(edge.points[i - 1].position_mm) - first)
                        .Crossed(to_vector(edge.points[i].position_mm) - first);
            normal += to_vector(edge.points[i].normal);
        }
    }
    return area.Dot(normal) < 0;
}

}  // namespace gsim::solid
