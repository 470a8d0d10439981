#include "engine/src/drawing/cutting_site.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cam/linking/clear_ways.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/values.h"
#include "runtime/simulator/setup_of_machine.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

constexpr std::size_t kMostFaults = 20;
// Work offset of programs that do not select one.
constexpr std::string_view kFirstOffset = "54";

std::string name_of(const cutting::Autopath& made, std::size_t path) {
    const std::string& name = made.program.paths[path].name;
    if (path >= made.cuts.size() || made.cuts[path].empty()) return name;
    return fmt::format("{} ({})", name, made.cuts[path]);
}

std::string sentence_of(const cutting::Autopath& made, const path::Fault& fault) {
    return fmt::format("{}: {}", name_of(made, fault.where.path), fault.sentence);
}

}  // namespace

struct CuttingSite::Parts {
    Machine machine;
    transit::Origin origin;
    path::MachineSpace space;
    motion::PlannerSetup setup;
    cell::ClearWay bodies;
    std::vector<std::string> notes;
};

CuttingSite::CuttingSite(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CuttingSite::CuttingSite(CuttingSite&&) noexcept = default;
CuttingSite& CuttingSite::operator=(CuttingSite&&) noexcept = default;
CuttingSite::~CuttingSite() = default;

tl::expected<CuttingSite, Failure> CuttingSite::read(const Host& host, const CuttingPlace& place) {
    Request request;
    request.host = host;
    request.cell = place.cell;
    request.machine = place.machine;
    request.machine_data = place.machine_data;
    auto machine = Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    if (auto bodies = machine->read_bodies(); !bodies) return tl::unexpected(bodies.error());
    const auto failed = [](const std::string& sentence) {
        return tl::unexpected(failure_of(DiagnosticKind::input_file, sentence));
    };
    const Machine::Parts& parts = machine->parts();
    const auto data = read_data_of(parts.found, parts.input);
    if (!data) return failed(data.error());
    transit::Origin origin;
    const auto offset = data->data().offsets.find(kFirstOffset);
    if (offset != data->data().offsets.end()) origin = offset->second;
    auto space = path::MachineSpace::make(parts.input.machine);
    if (!space) return failed(space.error());
    auto bodies = cell::ClearWay::make(*parts.bodies, parts.input.machine);
    if (!bodies) return failed(bodies.error());
    motion::PlannerSetup setup = simulation::setup_of_machine(parts.input.machine);
    std::vector<std::string> notes = parts.input.notes;
    if (bodies->pair_count() == 0)
        notes.push_back(
            "machine and cell have no bodies that could touch each other: ways between cuts stay as they "
            "are");
    return CuttingSite(
        std::make_unique<Parts>(Parts{*std::move(machine), std::move(origin), *std::move(space),
                                      std::move(setup), *std::move(bodies), std::move(notes)}));
}

const std::vector<std::string>& CuttingSite::notes() const {
    return parts_->notes;
}

tl::expected<void, std::string> CuttingSite::clear_ways(cutting::Autopath& made,
                                                        CuttingFigures& figures) const {
    const transit::RapidSpace space(parts_->space, parts_->setup, parts_->bodies, parts_->origin,
                                    transit::names_orientations(made.program));
    const auto transit = transit::clear_ways(made.program, space, parts_->space.home());
    if (!transit) return tl::unexpected(sentence_of(made, transit.error()));
    if (parts_->bodies.pair_count() > 0) figures.ways = transit->ways;
    figures.ways_round = transit->changed;
    if (transit->faults.empty()) return {};
    std::string sentences;
    for (std::size_t i = 0; i < std::min(transit->faults.size(), kMostFaults); ++i) {
        if (i > 0) sentences += "\n  ";
        sentences += sentence_of(made, transit->faults[i]);
    }
    if (transit->faults.size() > kMostFaults)
        sentences += fmt::format("\n  and {} more", transit->faults.size() - kMostFaults);
    return tl::unexpected(std::move(sentences));
}

}  // namespace gsim::engine
