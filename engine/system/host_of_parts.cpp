#include "engine/system/host_of_parts.h"

#include <string>
#include <utility>

#include "cam/solid/plate.h"
#include "engine/system/read_contours.h"

namespace gsim::engine {

namespace {

Plate::Outline outline_of(const geometry::Contour& contour) {
    Plate::Outline outline{.closed = contour.closed};
    outline.vertices.reserve(contour.vertices.size());
    for (const geometry::Vertex& vertex : contour.vertices)
        outline.vertices.push_back({{vertex.position.x, vertex.position.y}, vertex.bulge, vertex.source});
    return outline;
}

tl::expected<Plate, std::string> read_plate(const std::string& file, const PlateChoice& choice) {
    return solid::read_plate(file, {choice.tolerance_mm, choice.flip, choice.up}).map([](solid::Plate read) {
        Plate plate{.notes = std::move(read.drawing.notes), .thickness_mm = read.thickness_mm};
        for (drawing::Entity& entity : read.drawing.entities)
            plate.sources.push_back(
                {std::move(entity.kind), std::move(entity.name), entity.line, entity.bevel_deg});
        for (const geometry::Contour& contour : read.drawing.pieces)
            plate.outlines.push_back(outline_of(contour));
        return plate;
    });
}

}  // namespace

Host host_of_parts(ModulePlace place) {
    Host host = host_of_system(place);
    host.read_plate = read_plate;
    host.read_contours = read_contours;
    return host;
}

}  // namespace gsim::engine
