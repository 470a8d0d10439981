#include "engine/system/system_host.h"

#include <utility>

#include "base/os/installation.h"
#include "controller/module/rcs_host.h"
#include "controller/module/rcs_process.h"
#include "engine/system/installed_files.h"
#include "geometry/mesh/mesh.h"
#include "runtime/rcs/rcs_machine.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::engine {

namespace {

tl::expected<Triangles, std::string> read_solid(const std::string& file, double tolerance_mm) {
    return solid::read_mesh(file, tolerance_mm).map_error(&gsim::Error::message).map([](solid::Mesh mesh) {
        return Triangles{.points_mm = std::move(mesh.vertices_mm), .corners = std::move(mesh.triangles)};
    });
}

using LoadedModule = tl::expected<std::shared_ptr<rrs::RcsModule>, std::string>;

Result<rrs::RcsModule> load_in_process(const std::string& file, const gsim_rcs_machine& machine) {
    auto library = rrs::RcsLibrary::load(file, machine);
    if (!library) return tl::unexpected(std::move(library.error()));
    return rrs::RcsModule::create(*std::move(library), machine);
}

Result<rrs::RcsModule> load_in_separate_process(const std::string& file, const gsim_rcs_machine& machine) {
    const auto program = os::helper_program(os::program_folder(), "gsim-rcs-host");
    if (program) return rrs::start_rcs_process(*program, file, machine);
    return tl::unexpected(program.error().message +
                          "; it runs controller modules (--rcs-in-process does not require it)");
}

LoadedModule load_module(ModuleProcess isolation, const std::string& file, const machine::Machine& machine) {
    const rcs::RcsMachine machine_description(simulation::make_planner_setup(machine));
    const auto load = isolation == ModuleProcess::this_process ? load_in_process : load_in_separate_process;
    return load(file, machine_description.get())
        .map_error(&gsim::Error::message)
        .map([](rrs::RcsModule module) { return std::make_shared<rrs::RcsModule>(std::move(module)); });
}

}  // namespace

Host make_system_host(ModuleProcess isolation) {
    return {.files = {},
            .find =
                [](NameKind kind, const std::string& name) {
                    return find_file(kind, name).map_error(&gsim::Error::message);
                },
            .read_solid = read_solid,
            .load_module =
                [isolation](const std::string& file, const machine::Machine& machine) {
                    return load_module(isolation, file, machine);
                }};
}

}  // namespace gsim::engine
