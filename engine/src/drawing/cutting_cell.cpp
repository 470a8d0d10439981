#include "engine/src/drawing/cutting_cell.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cam/linking/collision_avoidance.h"
#include "engine/src/conversions.h"
#include "engine/src/machine/machine_parts.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

constexpr std::size_t kMaxErrors = 20;
// Work offset of programs that do not select one.
constexpr std::string_view kDefaultWorkOffset = "54";

std::string path_name(const cutting::Autopath& autopath_result, std::size_t path) {
    const std::string& name = autopath_result.program.paths[path].name;
    if (path >= autopath_result.cuts.size() || autopath_result.cuts[path].empty()) return name;
    return fmt::format("{} ({})", name, autopath_result.cuts[path]);
}

std::string linking_error_message(const cutting::Autopath& autopath_result, const path::TargetError& error) {
    return fmt::format("{}: {}", path_name(autopath_result, error.where.path), error.message);
}

}  // namespace

struct CuttingCell::Parts {
    Machine machine;
    linking::Origin origin;
    path::MachineSpace space;
    motion::PlannerSetup setup;
    cell::CollisionChecker bodies;
    std::vector<std::string> notes;
};

CuttingCell::CuttingCell(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CuttingCell::CuttingCell(CuttingCell&&) noexcept = default;
CuttingCell& CuttingCell::operator=(CuttingCell&&) noexcept = default;
CuttingCell::~CuttingCell() = default;

tl::expected<CuttingCell, Error> CuttingCell::read(const Host& host, const CuttingCellOptions& work_cell) {
    Request request;
    request.host = host;
    request.cell = work_cell.cell;
    request.machine = work_cell.machine;
    request.machine_data = work_cell.machine_data;
    auto machine = Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    if (auto bodies = machine->read_bodies(); !bodies) return tl::unexpected(bodies.error());
    const auto failed = [](const std::string& message) {
        return tl::unexpected(make_error(DiagnosticKind::input_file, message));
    };
    const Machine::Parts& parts = machine->parts();
    const auto data = read_request_data(parts.found, parts.input);
    if (!data) return failed(data.error().message);
    linking::Origin origin;
    const auto offset = data->data().offsets.find(kDefaultWorkOffset);
    if (offset != data->data().offsets.end()) origin = offset->second;
    auto space = path::MachineSpace::make(parts.input.machine);
    if (!space) return failed(space.error().message);
    auto bodies = cell::CollisionChecker::make(*parts.bodies, parts.input.machine);
    if (!bodies) return failed(bodies.error().message);
    motion::PlannerSetup setup = simulation::make_planner_setup(parts.input.machine);
    std::vector<std::string> notes = parts.input.warnings;
    notes.insert(notes.end(), parts.input.notes.begin(), parts.input.notes.end());
    if (bodies->pair_count() == 0)
        notes.push_back(
            "machine and cell have no bodies that can touch each other: linking moves between cuts are "
            "unchanged");
    return CuttingCell(
        std::make_unique<Parts>(Parts{*std::move(machine), std::move(origin), *std::move(space),
                                      std::move(setup), *std::move(bodies), std::move(notes)}));
}

const std::vector<std::string>& CuttingCell::notes() const {
    return parts_->notes;
}

Result<void> CuttingCell::avoid_collisions(cutting::Autopath& autopath_result,
                                           CuttingMetrics& metrics) const {
    const linking::RapidPlanner space(parts_->space, parts_->setup, parts_->bodies, parts_->origin,
                                      linking::has_orientations(autopath_result.program));
    const auto linking = linking::avoid_collisions(autopath_result.program, space, parts_->space.home());
    if (!linking) return tl::unexpected(linking_error_message(autopath_result, linking.error()));
    if (parts_->bodies.pair_count() > 0) metrics.linking_paths = linking->linking_paths;
    metrics.rerouted_moves = linking->changed;
    if (linking->errors.empty()) return {};
    std::string sentences;
    for (std::size_t i = 0; i < std::min(linking->errors.size(), kMaxErrors); ++i) {
        if (i > 0) sentences += "\n  ";
        sentences += linking_error_message(autopath_result, linking->errors[i]);
    }
    if (linking->errors.size() > kMaxErrors)
        sentences += fmt::format("\n  and {} more", linking->errors.size() - kMaxErrors);
    return tl::unexpected(std::move(sentences));
}

}  // namespace gsim::engine
