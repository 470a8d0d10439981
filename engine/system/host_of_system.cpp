#include "engine/system/host_of_system.h"

#include <utility>

#include "base/os/installation.h"
#include "cam/solid/mesh.h"
#include "cam/solid/plate.h"
#include "engine/system/installed_files.h"
#include "engine/system/read_contours.h"
#include "runtime/rcs/rcs_machine.h"
#include "runtime/rrs/rcs_host.h"
#include "runtime/rrs/rcs_process.h"
#include "runtime/simulation/simulator.h"

namespace gsim::engine {

namespace {

tl::expected<Triangles, std::string> read_solid(const std::string& file, double tolerance_mm) {
    return solid::read_mesh(file, tolerance_mm).map([](solid::Mesh mesh) {
        return Triangles{.points_mm = std::move(mesh.vertices_mm), .corners = std::move(mesh.triangles)};
    });
}

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

using LoadedModule = tl::expected<std::shared_ptr<rrs::RcsModule>, std::string>;

tl::expected<rrs::RcsModule, std::string> load_here(const std::string& file,
                                                    const gsim_rcs_machine& machine) {
    auto library = rrs::RcsLibrary::load(file, machine);
    if (!library) return tl::unexpected(std::move(library.error()));
    return rrs::RcsModule::create(*std::move(library), machine);
}

tl::expected<rrs::RcsModule, std::string> load_beside(const std::string& file,
                                                      const gsim_rcs_machine& machine) {
    const auto program = os::helper_program(os::program_folder(), "gsim-rcs-host");
    if (program) return rrs::begin_rcs_process(*program, file, machine);
    return tl::unexpected(program.error() + "; controller modules run in it (--rcs-in-process does without)");
}

LoadedModule load_module(ModulePlace place, const std::string& file, const machine::Machine& machine) {
    const rcs::RcsMachine described(simulation::setup_of_machine(machine));
    const auto load = place == ModulePlace::this_process ? load_here : load_beside;
    return load(file, described.get()).map([](rrs::RcsModule module) {
        return std::make_shared<rrs::RcsModule>(std::move(module));
    });
}

}  // namespace

Host host_of_system(ModulePlace place) {
    return {.files = {},
            .find = find_file,
            .read_solid = read_solid,
            .read_plate = read_plate,
            .read_contours = read_contours,
            .load_module = [place](const std::string& file, const machine::Machine& machine) {
                return load_module(place, file, machine);
            }};
}

}  // namespace gsim::engine
