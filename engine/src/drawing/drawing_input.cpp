#include "engine/src/drawing/drawing_input.h"

#include <utility>

#include <fmt/format.h>

#include "cam/drawing/drawing_file.h"
#include "geometry/mesh/mesh.h"

namespace gsim::engine {

namespace {

geometry::Contour to_contour(const Plate::Outline& outline) {
    geometry::Contour contour;
    contour.closed = outline.closed;
    contour.vertices.reserve(outline.vertices.size());
    for (const Plate::Vertex& vertex : outline.vertices)
        contour.vertices.push_back(
            {{vertex.position_mm[0], vertex.position_mm[1]}, vertex.bulge, vertex.source});
    return contour;
}

solid::Plate to_solid_plate(Plate given) {
    solid::Plate plate;
    plate.thickness_mm = given.thickness_mm;
    for (Plate::Source& source : given.sources)
        plate.drawing.entities.push_back(
            {std::move(source.kind), std::move(source.name), source.line, source.bevel_deg});
    for (const Plate::Outline& outline : given.outlines)
        plate.drawing.drawn_contours.push_back(to_contour(outline));
    plate.drawing.notes = std::move(given.notes);
    return plate;
}

Result<solid::Plate> read_solid(const Host& host, const std::string& file,
                                const DrawingOptions& drawing_options) {
    if (drawing_options.unit_mm != 0 || !drawing_options.layers.empty())
        return Unexpected("--unit and --layer apply to drawings; a STEP or IGES file defines its unit");
    if (!host.read_plate) {
        return Unexpected(
            fmt::format("{}: STEP and IGES files are not supported here, only DXF and SVG files", file));
    }
    return host
        .read_plate(file, {.tolerance_mm = drawing_options.curve_tolerance_mm,
                           .flip = drawing_options.flip,
                           .up = drawing_options.up})
        .map(to_solid_plate);
}

}  // namespace

Result<solid::Plate> read_drawing_input(const Host& host, const std::string& file,
                                        const DrawingOptions& drawing_options) {
    if (solid::is_solid_file(file)) return read_solid(host, file, drawing_options);
    if (drawing_options.flip || !drawing_options.up.empty())
        return Unexpected("--up and --flip apply to STEP and IGES files");
    const drawing::ReadOptions options{drawing_options.curve_tolerance_mm, drawing_options.unit_mm,
                                       drawing_options.layers};
    return drawing::read_drawing(file, options, os::NameSource::command_line, host.files.impl())
        .map([](drawing::Drawing read) {
            return solid::Plate{std::move(read), 0};
        });
}

}  // namespace gsim::engine
