#include "cam/solid/occ/plate_reader.h"

#include <fmt/format.h>

#include "cam/solid/occ/flat_outline.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/plate_outline_builder.h"

namespace gsim::solid {

namespace {

void add_ignored_note(std::size_t count, const char* what, Plate& plate) {
    if (count == 0) return;
    plate.drawing.notes.push_back(fmt::format("{} {} that are not part of a body are ignored", count, what));
}

Result<Plate> plate_from_solids(const Bodies& bodies, const ShapeFile& file, const PlateOptions& options) {
    const auto frame = find_plate(bodies.solids, options);
    if (!frame) return Unexpected(frame.error());
    Plate plate;
    PlateOutlineBuilder outline(file, *frame, options.tolerance_mm, plate);
    for (const TopoDS_Solid& solid : bodies.solids) {
        if (auto result = outline.add(solid); !result) return Unexpected(result.error());
    }
    add_ignored_note(bodies.faces.size(), bodies.faces.size() == 1 ? "surface is" : "surfaces are", plate);
    add_ignored_note(bodies.edges.size(), bodies.edges.size() == 1 ? "curve is" : "curves are", plate);
    return plate;
}

}  // namespace

Result<Plate> extract_plate(const ShapeFile& file, const PlateOptions& options) {
    const Bodies bodies = sort_bodies(file.shape());
    if (!bodies.solids.empty()) return plate_from_solids(bodies, file, options);
    if (!bodies.faces.empty()) return plate_from_faces(bodies.faces, file, options);
    if (!bodies.edges.empty()) return plate_from_curves(bodies.edges, file, options);
    return Unexpected("it contains no body, surface or curve");
}

}  // namespace gsim::solid
