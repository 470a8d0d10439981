#include "geometry/planar/contour.h"

#include <numeric>

namespace gsim::geometry {

namespace {

// Relative to the middle of the box the products of coordinates keep their digits, however far off the origin
// is.
Point local_origin(const Contour& contour) {
    const Box box = bounding_box(contour);
    return box.empty() ? Point{} : 0.5 * (box.low + box.high);
}

}  // namespace

void append_edge(Contour& contour, const Edge& edge, std::uint32_t source) {
    if (contour.vertices.empty()) contour.vertices.push_back({edge.start, 0, source});
    if (std::abs(edge.bulge) > 1 + 1e-12) {
        // center() is not needed: the half of an arc follows from its height over the chord.
        const Point chord = edge.end - edge.start;
        const Point top = 0.5 * (edge.start + edge.end) + (edge.bulge / 2) * right_normal(chord);
        const double half = std::tan(std::atan(edge.bulge) / 2);
        append_edge(contour, {edge.start, top, half}, source);
        append_edge(contour, {top, edge.end, half}, source);
        return;
    }
    contour.vertices.back().bulge = edge.bulge;
    contour.vertices.back().source = source;
    contour.vertices.push_back({edge.end, 0, source});
}

double area_mm2(const Contour& contour) {
    if (!contour.closed) return 0;
    const Point origin = local_origin(contour);
    double sum = 0;
    for (std::size_t i = 0; i < contour.edges(); ++i) {
        const Edge edge = contour.edge(i);
        sum += swept_area_mm2({edge.start - origin, edge.end - origin, edge.bulge});
    }
    return sum;
}

double length_mm(const Contour& contour) {
    double sum = 0;
    for (std::size_t i = 0; i < contour.edges(); ++i) sum += length_mm(contour.edge(i));
    return sum;
}

Box bounding_box(const Contour& contour) {
    Box box;
    for (std::size_t i = 0; i < contour.edges(); ++i) box.add(bounding_box(contour.edge(i)));
    return box;
}

void reverse(Contour& contour) {
    if (contour.vertices.empty()) return;
    std::vector<Vertex> turned;
    turned.reserve(contour.vertices.size());
    const std::size_t count = contour.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t vertex = contour.closed ? (count - i) % count : count - 1 - i;
        const std::size_t before = (vertex + count - 1) % count;
        turned.push_back({contour.vertices[vertex].position, -contour.vertices[before].bulge,
                          contour.vertices[before].source});
    }
    if (!contour.closed) turned.back().bulge = 0;
    contour.vertices = std::move(turned);
}

std::vector<Box> edge_boxes(const Contour& contour) {
    std::vector<Box> boxes;
    boxes.reserve(contour.edges());
    for (std::size_t i = 0; i < contour.edges(); ++i) boxes.push_back(bounding_box(contour.edge(i)));
    return boxes;
}

}  // namespace gsim::geometry
