#include "engine/src/run/run_cell.h"

#include <utility>

#include <fmt/format.h>

#include "collision/cell/cell_file.h"
#include "collision/cell/machine_shapes.h"

namespace gsim::engine {

namespace {

cell::Cell make_frames_only_cell(const machine::Machine& machine) {
    return {.name = machine.name, .frames = cell::FrameTree(machine)};
}

solid::Mesh to_mesh(Triangles triangles) {
    return {.vertices_mm = std::move(triangles.points_mm), .triangles = std::move(triangles.corners)};
}

}  // namespace

cell::MeshFiles mesh_files(const Host& host) {
    return {
        .files = host.files.impl(),
        .read_solid = [read = host.read_solid](const std::filesystem::path& file,
                                               double tolerance_mm) -> Result<solid::Mesh> {
            if (!read) {
                return Unexpected(fmt::format(
                    "{}: STEP and IGES files are not supported here, only STL and OBJ files", file.string()));
            }
            return read(file.string(), tolerance_mm).map(to_mesh);
        }};
}

Result<cell::Cell> read_bodies(const CellSource& cell_source, const machine::Machine& machine) {
    if (!cell_source.collisions) return make_frames_only_cell(machine);
    return read_cell_contents(cell_source, machine);
}

Result<cell::Cell> read_cell_contents(const CellSource& cell_source, const machine::Machine& machine,
                                      std::span<const std::string> conveyors) {
    if (!cell_source.file.empty())
        return cell::read_cell(cell_source.text, cell_source.file, machine, conveyors, cell_source.files);
    return cell_source.collisions ? cell::make_machine_cell(machine, cell_source.files)
                                  : make_frames_only_cell(machine);
}

Result<std::unique_ptr<simulation::CellMonitor>> make_cell_monitor(const CellSource& cell_source,
                                                                   const machine::Machine& machine,
                                                                   std::span<const std::string> conveyors) {
    const bool is_from_file = !cell_source.file.empty();
    const bool monitored = cell_source.collisions && (is_from_file || !machine.shapes.empty());
    const auto monitor = [&](cell::Cell cell) {
        return std::make_unique<simulation::CellMonitor>(
            std::move(cell), machine,
            simulation::CellOptions{.is_from_file = is_from_file, .monitored = monitored});
    };
    if (cell_source.read) return monitor(*cell_source.read);
    return read_cell_contents(cell_source, machine, conveyors).map(monitor);
}

}  // namespace gsim::engine
