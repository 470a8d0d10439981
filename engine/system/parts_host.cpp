#include "engine/system/parts_host.h"

#include <string>
#include <utility>

#include "cam/solid/plate.h"
#include "engine/system/read_contours.h"

namespace gsim::engine {

namespace {

Plate::Outline to_outline(const geometry::Contour& contour) {
    Plate::Outline outline{.closed = contour.closed};
    outline.vertices.reserve(contour.vertices.size());
    for (const geometry::Vertex& vertex : contour.vertices)
        outline.vertices.push_back({{vertex.position.x, vertex.position.y}, vertex.bulge, vertex.source});
    return outline;
}

tl::expected<Plate, std::string> read_plate(const std::string& file, const PlateReadOptions& options) {
    return solid::read_plate(file, {options.tolerance_mm, options.flip, options.up})
        .map([](solid::Plate read) {
            Plate plate{.notes = std::move(read.drawing.notes), .thickness_mm = read.thickness_mm};
            for (drawing::Entity& entity : read.drawing.entities)
                plate.sources.push_back(
                    {std::move(entity.kind), std::move(entity.name), entity.line, entity.bevel_deg});
            for (const geometry::Contour& contour : read.drawing.drawn_contours)
                plate.outlines.push_back(to_outline(contour));
            return plate;
        })
        .map_error(&gsim::Error::message);
}

}  // namespace

Host make_parts_host(ModuleProcess isolation) {
    Host host = make_system_host(isolation);
    host.read_plate = read_plate;
    host.read_contours = read_contours;
    return host;
}

}  // namespace gsim::engine
