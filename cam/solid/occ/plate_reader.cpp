#include "cam/solid/occ/plate_reader.h"

#include <fmt/format.h>

#include "cam/solid/occ/flat_outline.h"
#include "cam/solid/occ/plate_bodies.h"
#include "cam/solid/occ/solid_outline.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

void note_rest(std::size_t count, const char* what, Plate& plate) {
    if (count == 0) return;
    plate.drawing.notes.push_back(fmt::format("{} {} beside the bodies left out", count, what));
}

tl::expected<Plate, std::string> plate_of_solids(const Bodies& bodies, const ShapeFile& file,
                                                 const PlateOptions& options) {
    const auto frame = find_plate(bodies.solids, options);
    if (!frame) return Fault(frame.error());
    Plate plate;
    SolidOutline outline(file, *frame, options.tolerance_mm, plate);
    for (const TopoDS_Solid& solid : bodies.solids) {
        if (auto added = outline.add(solid); !added) return Fault(added.error());
    }
    note_rest(bodies.faces.size(), bodies.faces.size() == 1 ? "surface is" : "surfaces are", plate);
    note_rest(bodies.edges.size(), bodies.edges.size() == 1 ? "curve is" : "curves are", plate);
    return plate;
}

}  // namespace

tl::expected<Plate, std::string> plate_of(const ShapeFile& file, const PlateOptions& options) {
    const Bodies bodies = sort_bodies(file.shape());
    if (!bodies.solids.empty()) return plate_of_solids(bodies, file, options);
    if (!bodies.faces.empty()) return plate_of_faces(bodies.faces, file, options);
    if (!bodies.edges.empty()) return plate_of_curves(bodies.edges, file, options);
    return Fault("there is no body, surface or curve in it");
}

}  // namespace gsim::solid
