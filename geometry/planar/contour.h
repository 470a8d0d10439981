#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/planar/edge.h"

namespace gsim::geometry {

/// A corner of a contour and how the contour goes on from it.
struct Vertex {
    Point position;
    double bulge = 0;          ///< Of the edge to the next vertex (Edge::bulge).
    std::uint32_t source = 0;  ///< What the edge comes from: an entity of a drawing.
};

/// Lines and arcs one behind the other. Where it is closed the last vertex has an edge to the first one.
struct Contour {
    std::vector<Vertex> vertices;
    bool closed = false;

    std::size_t edges() const {
        if (closed) return vertices.size();
        return vertices.empty() ? 0 : vertices.size() - 1;
    }
    Edge edge(std::size_t i) const {
        const Vertex& from = vertices[i];
        return {from.position, vertices[next(i)].position, from.bulge};
    }
    std::size_t next(std::size_t i) const { return i + 1 < vertices.size() ? i + 1 : 0; }
};

/// Which edge of which contour of a list.
struct EdgeId {
    std::uint32_t contour, edge;
};

/// Appends an edge that begins where the contour ends; an arc of more than half a turn becomes two. The last
/// vertex carries no edge yet.
void append_edge(Contour& contour, const Edge& edge, std::uint32_t source);

/// Of a closed contour, exact for arcs; counter-clockwise above 0.
double area_mm2(const Contour& contour);
double length_mm(const Contour& contour);
Box box_of(const Contour& contour);
/// Goes the other way round; a closed one keeps its first vertex.
void reverse(Contour& contour);
/// The boxes of the edges, in order.
std::vector<Box> edge_boxes(const Contour& contour);

}  // namespace gsim::geometry
