#include "engine/src/run/robots_run.h"

#include <utility>

#include <fmt/format.h>

#include "collision/cell/machine_shapes.h"
#include "engine/src/conversions.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/language.h"
#include "engine/src/run/override_changes.h"
#include "engine/src/run/process_words.h"
#include "engine/src/run/run_cell.h"
#include "engine/src/run/word_table.h"
#include "grammar/dialect.h"
#include "runtime/simulator/machine_dynamics.h"

namespace gsim::engine {

namespace {

tl::unexpected<Error> unexpected_error(const gsim::Error& error) {
    return tl::unexpected(make_error(text::DiagnosticKind::input_file, error));
}

}  // namespace

Result<std::unique_ptr<simulation::CellMonitor>> RobotsRun::read_cell(
    const process::RobotEntry& entry, const machine::Machine& machine,
    const std::vector<std::string>& conveyors) const {
    const Request& request = found_->request;
    CellSource cell_source{.file = entry.cell.string(),
                           .text = {},
                           .collisions = request.collisions,
                           .files = mesh_files(request.host)};
    if (cell_source.file.empty()) return make_cell_monitor(cell_source, machine, conveyors);
    return request.host.files.impl().read_text(cell_source.file).and_then([&](const std::string& text) {
        cell_source.text = text;
        return make_cell_monitor(cell_source, machine, conveyors);
    });
}

tl::expected<RobotsRun::Station, Error> RobotsRun::make_station(
    const process::RobotEntry& entry, const std::vector<std::string>& conveyors) const {
    const Request& request = found_->request;
    const os::Files& files = request.host.files.impl();
    auto input = read_machine_input(request.host, entry.machine.string(), os::NameSource::in_file);
    if (!input) return unexpected_error(input.error());
    for (const text::Diagnostic& diagnostic : machine_diagnostics(*input))
        run_context_->on_diagnostic(diagnostic);
    machine::Machine* machine = &input->machine;
    Station station;
    station.entry = entry;
    if (input->data) station.data = *std::move(input->data);
    if (!entry.machine_data.empty()) {
        const std::string name = entry.machine_data.string();
        auto data = files.read_text(name).and_then(
            [&](const std::string& text) { return machine::read_machine_data(text, name, machine->axes); });
        if (!data) return unexpected_error(data.error());
        station.data = *std::move(data);
    }
    LanguageOptions cell_source = request.language;
    if (!entry.dialect.empty()) cell_source.dialect = entry.dialect;
    auto language = make_language(cell_source, machine->program, station.data);
    if (!language) return unexpected_error(language.error());
    station.language = *std::move(language);
    station.language.cpu = &run_context_->cpu;
    station.language.memory_bytes = request.limits.memory_bytes;
    if (machine->process) {
        if (const auto error = find_process_error(*machine->process, *station.language.dialect))
            return unexpected_error(*error);
    }
    auto overrides = read_overrides(files, request.overrides, machine->controller);
    if (!overrides)
        return unexpected_error(fmt::format("robot {}: {}", entry.name, overrides.error().message));
    auto cell = read_cell(entry, *machine, conveyors);
    if (!cell) return unexpected_error(cell.error());
    station.cell = *std::move(cell);
    auto dynamics = simulation::make_dynamics(*machine, mesh_files(request.host));
    if (!dynamics) return unexpected_error(fmt::format("robot {}: {}", entry.name, dynamics.error()));
    station.simulator =
        std::make_unique<simulation::Simulator>(std::move(*machine), run_limits(request, run_context_->cpu));
    station.simulator->set_cell(*station.cell);
    station.simulator->monitors().set_dynamics(*std::move(dynamics));
    if (!overrides->changes().empty()) station.simulator->motion().set_overrides(*overrides);
    return station;
}

tl::expected<RobotsRun, Error> RobotsRun::open(const ResolvedRequest& found, const RunContext& tools) {
    const std::string& name = found.request.robots;
    auto file = found.request.host.files.impl()
                    .read_text(name, os::NameSource::command_line)
                    .and_then([&](const std::string& text) {
                        return process::read_robots(text, name, grammar::dialect_names());
                    });
    if (!file) return unexpected_error(file.error());
    std::vector<std::string> conveyors;
    conveyors.reserve(file->conveyors.size());
    for (const process::Conveyor& conveyor : file->conveyors) conveyors.push_back(conveyor.name());
    RobotsRun run(found, tools);
    run.stations_.reserve(file->robots.size());
    for (const process::RobotEntry& entry : file->robots) {
        auto station = run.make_station(entry, conveyors);
        if (!station) return tl::unexpected(station.error());
        run.stations_.push_back(*std::move(station));
    }
    run.conveyors_ = std::move(file->conveyors);
    run.zones_ = std::move(file->zones);
    run.monitor_robots();
    return run;
}

void RobotsRun::monitor_robots() {
    std::vector<simulation::PlacedRobot> robots;
    robots.reserve(stations_.size());
    for (Station& station : stations_)
        robots.push_back(
            {station.entry.name, station.simulator->motion(), station.cell.get(), station.entry.base});
    std::vector<simulation::PlacedZone> zones;
    zones.reserve(zones_.size());
    for (const process::SharedZone& zone : zones_)
        zones.push_back({zone.name, cell::make_shape(zone.form).value(), zone.frame});  // it is no mesh
    monitor_ = std::make_unique<simulation::MultiRobotMonitor>(robots, zones, &run_context_->cpu);
}

std::vector<script::Robot> RobotsRun::robots() {
    const Request& request = found_->request;
    const os::Files& files = request.host.files.impl();
    std::vector<script::Robot> robots;
    robots.reserve(stations_.size());
    for (Station& station : stations_) {
        robots.push_back({.name = station.entry.name,
                          .simulator = *station.simulator,
                          .dialect = station.language.dialect->name(),
                          .codes = word_table(*station.language.dialect),
                          .unit_mm = start_unit_mm(station.language),
                          .data = std::move(station.data),
                          .find_program = program_finder(files, request.program, station.language,
                                                         run_context_->on_diagnostic),
                          .find_module = module_finder(files, request.program, request.limits.memory_bytes),
                          .base = station.entry.base});
    }
    return robots;
}

tl::expected<void, Error> RobotsRun::prepare(OpenedScript& opened, ProgressHandler progress) {
    const Language& language = stations_.front().language;
    auto input = read_script(opened, language, run_context_->on_diagnostic);
    if (!input) return tl::unexpected(input.error());
    auto setup = read_setup(found_->request, language, run_context_->on_diagnostic);
    if (!setup) return tl::unexpected(setup.error());
    script::Engine::Options options = engine_options(found_->request, {}, {}, *run_context_);
    options.setup = *std::move(setup);
    options.progress = std::move(progress);
    options.zones = std::move(zones_);
    if (monitor_->has_pairs()) options.multi_robot_monitor = monitor_.get();
    program_ = input->file_name;
    script_ = *std::move(input);
    engine_ = std::make_unique<script::Engine>(robots(), std::move(conveyors_), std::move(options));
    return {};
}

std::vector<simulation::RobotReport> RobotsRun::run() {
    engine_->run(*std::move(script_));
    std::vector<simulation::RobotReport> reports;
    reports.reserve(stations_.size());
    for (std::size_t i = 0; i < stations_.size(); ++i)
        reports.push_back(
            {stations_[i].entry.name, engine_->idle_s(i), stations_[i].simulator->finish(program_)});
    monitor_->finish();
    monitor_->add_findings(reports);
    return reports;
}

simulation::RobotsReport RobotsRun::combined_report(std::vector<simulation::RobotReport> robots) const {
    simulation::Report combined_report;
    combined_report.source.program = program_;
    engine_->report(combined_report);
    for (std::string& warning : monitor_->warnings())
        combined_report.messages.warnings.push_back(std::move(warning));
    return simulation::robots_report(std::move(combined_report), std::move(robots));
}

}  // namespace gsim::engine
