#include "engine/system/host_of_system.h"

#include <utility>

#include "cam/solid/mesh.h"
#include "engine/system/installed_files.h"
#include "runtime/rcs/rcs_machine.h"
#include "runtime/rrs/rcs_host.h"
#include "runtime/simulation/simulator.h"

namespace gsim::engine {

namespace {

tl::expected<Triangles, std::string> read_solid(const std::string& file, double tolerance_mm) {
    return solid::read_mesh(file, tolerance_mm).map([](solid::Mesh mesh) {
        return Triangles{.points_mm = std::move(mesh.vertices_mm), .corners = std::move(mesh.triangles)};
    });
}

tl::expected<std::shared_ptr<rrs::RcsModule>, std::string> load_module(const std::string& file,
                                                                       const machine::Machine& machine) {
    const rcs::RcsMachine described(simulation::setup_of_machine(machine));
    auto library = rrs::RcsLibrary::load(file, described.get());
    if (!library) return tl::unexpected(std::move(library.error()));
    return rrs::RcsModule::create(*std::move(library), described.get()).map([](rrs::RcsModule module) {
        return std::make_shared<rrs::RcsModule>(std::move(module));
    });
}

}  // namespace

Host host_of_system() {
    return {.files = {}, .find = find_file, .read_solid = read_solid, .load_module = load_module};
}

}  // namespace gsim::engine
