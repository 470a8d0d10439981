#include "cam/solid/occ/edge_chains.h"

#include <BRep_Tool.hxx>
#include <gp_Vec.hxx>
#include <optional>

#include <fmt/format.h>

#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

namespace {

class Chainer {
  public:
    explicit Chainer(const std::vector<EdgeAlone>& edges) : edges_(edges), used_(edges.size()) {}

    tl::expected<std::vector<EdgeChain>, std::string> run() {
        for (const EdgeAlone& edge : edges_) {
            if (auto fault = find_branch(edge.end)) return tl::unexpected(*std::move(fault));
        }
        std::vector<EdgeChain> chains;
        // Open chains come first, so the remaining ones are closed.
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (count(edges_[i].begin, &EdgeAlone::end) == 0) chains.push_back(follow(i));
        }
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (!used_[i]) chains.push_back(follow(i));
        }
        return chains;
    }

  private:
    std::size_t count(const TopoDS_Vertex& at, TopoDS_Vertex EdgeAlone::*which) const {
        std::size_t found = 0;
        for (const EdgeAlone& edge : edges_) found += (edge.*which).IsSame(at) ? 1 : 0;
        return found;
    }

    std::optional<std::string> find_branch(const TopoDS_Vertex& at) const {
        const std::size_t ends = count(at, &EdgeAlone::end);
        const std::size_t begins = count(at, &EdgeAlone::begin);
        if (begins == 0 || ends + begins < 3) return std::nullopt;
        std::string names;
        for (const EdgeAlone& edge : edges_) {
            if (!edge.begin.IsSame(at) && !edge.end.IsSame(at)) continue;
            names += (names.empty() ? "" : ", ") + edge.edge.name;
        }
        return fmt::format("a chain of edges has no branches: at {} there are {}", shown(BRep_Tool::Pnt(at)),
                           names);
    }

    EdgeChain follow(std::size_t first) {
        EdgeChain chain;
        std::optional<std::size_t> at = first;
        while (at && !used_[*at]) {
            used_[*at] = true;
            chain.edges.push_back(*at);
            at = behind(*at);
        }
        chain.is_closed = at == first;
        return chain;
    }

    std::optional<std::size_t> behind(std::size_t edge) const {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (edges_[i].begin.IsSame(edges_[edge].end)) return i;
        }
        return std::nullopt;
    }

    const std::vector<EdgeAlone>& edges_;
    std::vector<bool> used_;
};

gp_Vec vector_of(const Triple& triple) {
    return {triple[0], triple[1], triple[2]};
}

}  // namespace

tl::expected<std::vector<EdgeChain>, std::string> chain(const std::vector<EdgeAlone>& edges) {
    return Chainer(edges).run();
}

bool is_hole(const WallContour& closed) {
    const gp_Vec first = vector_of(closed.edges.front().points.front().position_mm);
    gp_Vec area(0, 0, 0);
    gp_Vec normal(0, 0, 0);
    for (const WallEdge& edge : closed.edges) {
        for (std::size_t i = 1; i < edge.points.size(); ++i) {
            area += (vector_of(edge.points[i - 1].position_mm) - first)
                        .Crossed(vector_of(edge.points[i].position_mm) - first);
            normal += vector_of(edge.points[i].normal);
        }
    }
    return area.Dot(normal) < 0;
}

}  // namespace gsim::solid
