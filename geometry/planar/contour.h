#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/planar/edge.h"

namespace gsim::geometry {

/// A corner of a contour and the edge that follows it.
struct Vertex {
    Point position;
    double bulge = 0;          ///< For the edge to the next vertex (Edge::bulge).
    std::uint32_t source = 0;  ///< Source of the edge: an entity of a drawing.
};

/// A sequence of lines and arcs. If it is closed, the last vertex has an edge to the first one.
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

/// An edge of a contour of a list.
struct EdgeId {
    std::uint32_t contour, edge;
};

/// Appends an edge that begins at the end of the contour; an arc of more than half a turn becomes two. The
/// last vertex has no edge yet.
void append_edge(Contour& contour, const Edge& edge, std::uint32_t source);

/// Returns the area of a closed contour, exact for arcs; above 0 if counter-clockwise.
double area_mm2(const Contour& contour);
double length_mm(const Contour& contour);
Box bounding_box(const Contour& contour);
/// Reverses the direction; a closed contour keeps its first vertex.
void reverse(Contour& contour);
/// Returns the boxes of the edges, in order.
std::vector<Box> edge_boxes(const Contour& contour);

}  // namespace gsim::geometry
