#include "engine/src/run/run_cell.h"

#include <utility>

#include <fmt/format.h>

#include "collision/cell/cell_file.h"
#include "collision/cell/machine_shapes.h"

namespace gsim::engine {

namespace {

cell::Cell frames_alone(const machine::Machine& machine) {
    return {.name = machine.name, .frames = cell::FrameTree(machine)};
}

solid::Mesh mesh_of(Triangles triangles) {
    return {.vertices_mm = std::move(triangles.points_mm), .triangles = std::move(triangles.corners)};
}

}  // namespace

cell::MeshFiles mesh_files(const Host& host) {
    return {.files = host.files.inner(),
            .read_solid = [read = host.read_solid](const std::filesystem::path& file, double tolerance_mm)
                -> tl::expected<solid::Mesh, std::string> {
                if (!read) {
                    return tl::unexpected(fmt::format(
                        "{}: STEP and IGES files are not read here; STL and OBJ files are", file.string()));
                }
                return read(file.string(), tolerance_mm).map(mesh_of);
            }};
}

tl::expected<cell::Cell, std::string> read_bodies(const CellChoice& choice, const machine::Machine& machine) {
    if (!choice.collisions) return frames_alone(machine);
    return read_cell_of_run(choice, machine);
}

tl::expected<cell::Cell, std::string> read_cell_of_run(const CellChoice& choice,
                                                       const machine::Machine& machine,
                                                       std::span<const std::string> conveyors) {
    if (!choice.file.empty())
        return cell::read_cell(choice.text, choice.file, machine, conveyors, choice.files);
    return choice.collisions ? cell::cell_of_machine(machine, choice.files) : frames_alone(machine);
}

tl::expected<std::unique_ptr<simulation::CellWatch>, std::string> read_run_cell(
    const CellChoice& choice, const machine::Machine& machine, std::span<const std::string> conveyors) {
    const bool of_file = !choice.file.empty();
    const bool watched = choice.collisions && (of_file || !machine.shapes.empty());
    const auto watch = [&](cell::Cell cell) {
        return std::make_unique<simulation::CellWatch>(
            std::move(cell), machine, simulation::CellUse{.of_file = of_file, .watched = watched});
    };
    if (choice.read) return watch(*choice.read);
    return read_cell_of_run(choice, machine, conveyors).map(watch);
}

}  // namespace gsim::engine
