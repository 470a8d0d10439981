#include "engine/system/read_contours.h"

#include <utility>

#include "cam/solid/contours.h"

namespace gsim::engine {

namespace {

Contours::Edge to_edge(solid::WallEdge read) {
    Contours::Edge edge{.name = std::move(read.name),
                        .next_surface_mm = read.next_surface_mm,
                        .label = std::move(read.label)};
    edge.points.reserve(read.points.size());
    for (const solid::WallPoint& point : read.points)
        edge.points.push_back({point.position_mm, point.normal, point.tangent, point.wall_normal,
                               point.along_wall, point.depth_mm, point.exit_normal});
    return edge;
}

}  // namespace

tl::expected<Contours, std::string> read_contours(const std::string& file,
                                                  const ContourSelection& selection) {
    const solid::ContourOptions options{selection.tolerance_mm, selection.kind, selection.faces,
                                        selection.edges,        selection.side, selection.box_mm,
                                        selection.along_walls};
    return solid::read_contours(file, options)
        .map_error(&gsim::Error::message)
        .map([](solid::WallContours read) {
            Contours contours{.low_mm = read.low_mm, .high_mm = read.high_mm, .notes = std::move(read.notes)};
            for (solid::WallContour& each : read.contours) {
                Contours::Contour contour{
                    .face = std::move(each.face), .is_hole = each.is_hole, .is_open = each.is_open};
                for (solid::WallEdge& edge : each.edges) contour.edges.push_back(to_edge(std::move(edge)));
                contours.contours.push_back(std::move(contour));
            }
            for (solid::PartEdge& edge : read.other_edges)
                contours.other_edges.push_back({std::move(edge.name), std::move(edge.points_mm)});
            return contours;
        });
}

}  // namespace gsim::engine
