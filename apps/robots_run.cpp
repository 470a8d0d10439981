#include "apps/robots_run.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "base/os/file_identity.h"
#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "engine/inner/machine_input.h"
#include "engine/inner/process_words.h"
#include "engine/inner/run_cell.h"
#include "engine/inner/run_inputs.h"
#include "engine/inner/word_table.h"
#include "runtime/process/robots_file.h"

namespace gsim::apps {

namespace {

/// All that one robot needs for the run; it stays where it is.
struct Station {
    std::string name;
    std::unique_ptr<simulation::CellWatch> cell;
    std::unique_ptr<simulation::Simulator> simulator;
    std::unique_ptr<Outputs> outputs;
    Language language;
    machine::MachineData data;
    rrs::CartPos base;
};

tl::unexpected<InputError> usage(std::string message) {
    return tl::unexpected(
        InputError{.message = std::move(message), .kind = text::DiagnosticKind::input_file});
}

OutputNames own_files(const OutputNames& names, const std::string& robot) {
    OutputNames own = names;
    own.report.clear();  // one for all
    for (const OutputNames::File& file : OutputNames::files())
        own.*file.name = robots_own_file(own.*file.name, robot);
    return own;
}

tl::expected<std::unique_ptr<simulation::CellWatch>, std::string> read_robots_cell(
    const process::RobotEntry& entry, const machine::Machine& machine,
    const std::vector<std::string>& conveyors, bool collisions) {
    CellChoice choice{.file = entry.cell.string(), .text = {}, .collisions = collisions};
    if (choice.file.empty()) return read_run_cell(choice, machine, conveyors);
    return os::read_text_file(choice.file).and_then([&](const std::string& text) {
        choice.text = text;
        return read_run_cell(choice, machine, conveyors);
    });
}

tl::expected<Station, InputError> make_station(const process::RobotEntry& entry,
                                               const std::vector<std::string>& conveyors,
                                               const RobotsRun& run) {
    auto input = read_machine_input(entry.machine.string(), os::NamedBy::a_file);
    if (!input) return usage(input.error());
    machine::Machine* machine = &input->machine;
    Station station;
    if (input->data) station.data = *std::move(input->data);
    station.name = entry.name;
    station.base = entry.base;
    if (!entry.machine_data.empty()) {
        auto data = machine::load_machine_data(entry.machine_data.string(), machine->axes);
        if (!data) return usage(data.error());
        station.data = *std::move(data);
    }
    LanguageNames names = run.language;
    if (!entry.dialect.empty()) names.dialect = entry.dialect;
    auto language = language_of(names, machine->program, station.data);
    if (!language) return usage(language.error());
    station.language = *std::move(language);
    station.language.cpu = run.limits.cpu;
    station.language.memory_bytes = run.options.limits.memory_bytes;
    if (machine->process) {
        if (const auto fault = fault_of_process(*machine->process, *station.language.dialect))
            return usage(*fault);
    }
    auto overrides = read_overrides(run.overrides, machine->controller);
    if (!overrides) return usage(fmt::format("robot {}: {}", entry.name, overrides.error()));
    auto cell = read_robots_cell(entry, *machine, conveyors, run.collisions);
    if (!cell) return usage(cell.error());
    station.cell = *std::move(cell);
    station.simulator = std::make_unique<simulation::Simulator>(std::move(*machine), run.limits);
    station.simulator->set_cell(*station.cell);
    if (!overrides->changes().empty()) station.simulator->set_overrides(*overrides);
    auto outputs = Outputs::open(own_files(run.outputs, entry.name), *station.simulator);
    if (!outputs) return usage(outputs.error());
    station.outputs = std::make_unique<Outputs>(*std::move(outputs));
    return station;
}

/// A file of a robot's own that is another one of the run, as a sentence.
std::optional<std::string> conflict_of_own_files(const process::RobotEntry& robot, const RobotsRun& run) {
    const OutputNames own = own_files(run.outputs, robot.name);
    const std::pair<std::string, const char*> others[] = {
        {run.outputs.report, "the report"},      {run.input, "the program"},
        {run.robots, "the file of robots"},      {run.setup, "the setup"},
        {robot.machine.string(), "its machine"}, {robot.machine_data.string(), "its machine data"},
        {robot.cell.string(), "its cell"}};
    for (const OutputNames::File& file : OutputNames::files()) {
        const std::string& name = own.*file.name;
        const auto identity = os::identity_of(name);
        if (name.empty() || !identity) continue;
        for (const auto& [other, what] : others) {
            if (other.empty() || os::identity_of(other) != identity) continue;
            return fmt::format("'{}', of the robot {}, is {}, too; give one of them another name", name,
                               robot.name, what);
        }
    }
    return std::nullopt;
}

tl::expected<void, InputError> write_report(const std::string& name, const simulation::RobotsReport& report) {
    if (name.empty()) return {};
    auto file = os::OutputFile::open(name);
    if (!file) return usage(file.error());
    simulation::TextStream text(file->stream());
    text.buffer().append(to_json(report));
    text.end_line();
    if (auto flushed = text.flush(); !flushed) return usage(file->cannot_write(flushed.error()).value());
    if (auto committed = file->commit(); !committed) return usage(committed.error());
    return {};
}

/// Ends the robots' runs, one after the other, and writes their files.
tl::expected<simulation::RobotsReport, InputError> finish(const std::string& program,
                                                          std::vector<Station>& stations,
                                                          const script::Engine& engine) {
    simulation::Report whole;
    whole.program = program;
    engine.report(whole);
    std::vector<simulation::RobotReport> reports;
    reports.reserve(stations.size());
    std::optional<InputError> without_path;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        simulation::Report report = stations[i].simulator->finish(program);
        stations[i].outputs->explain(report);
        if (auto path = stations[i].outputs->make_path(program); !path && !without_path)
            without_path = {.message = path.error(), .kind = text::DiagnosticKind::path};
        if (auto written = stations[i].outputs->commit(report); !written) return usage(written.error());
        reports.push_back({stations[i].name, engine.idle_s(i), std::move(report)});
    }
    if (without_path) return tl::unexpected(*std::move(without_path));
    return simulation::robots_report(std::move(whole), std::move(reports));
}

}  // namespace

std::string robots_own_file(const std::string& name, const std::string& robot) {
    if (name.empty()) return name;
    std::filesystem::path path(name);
    path.replace_filename(path.stem().string() + "." + robot + path.extension().string());
    return path.string();
}

tl::expected<simulation::RobotsReport, InputError> run_robots(RobotsRun run) {
    auto file = process::load_robots(run.robots, os::NamedBy::command_line);
    if (!file) return usage(file.error());
    std::vector<std::string> conveyors;
    conveyors.reserve(file->conveyors.size());
    for (const process::Conveyor& conveyor : file->conveyors) conveyors.push_back(conveyor.name());
    if (!run.outputs.report.empty()) {
        if (auto writable = os::OutputFile::check(run.outputs.report); !writable)
            return usage(writable.error());
    }
    for (const process::RobotEntry& entry : file->robots) {
        if (auto conflict = conflict_of_own_files(entry, run)) return usage(*std::move(conflict));
    }
    std::vector<Station> stations;
    stations.reserve(file->robots.size());
    for (const process::RobotEntry& entry : file->robots) {
        auto station = make_station(entry, conveyors, run);
        if (!station) return tl::unexpected(station.error());
        stations.push_back(*std::move(station));
    }
    auto opened = open_script(run.input);
    if (!opened) return tl::unexpected(opened.error());
    if (auto confined = run.confine(); !confined) return usage(confined.error());
    auto input = read_script(*opened, stations.front().language, run.tell);
    if (!input) return tl::unexpected(input.error());
    if (!run.setup.empty()) {
        auto setup = read_script(run.setup, stations.front().language, run.tell);
        if (!setup) return tl::unexpected(setup.error());
        run.options.setup = *std::move(setup);
    }
    std::vector<script::Robot> robots;
    robots.reserve(stations.size());
    for (Station& station : stations) {
        robots.push_back({.name = station.name,
                          .simulator = *station.simulator,
                          .dialect = station.language.dialect->name(),
                          .codes = word_table(*station.language.dialect),
                          .unit_mm = start_unit_mm(station.language),
                          .data = std::move(station.data),
                          .find_program = program_finder(run.input, station.language, run.tell),
                          .find_module = module_finder(run.input, run.options.limits.memory_bytes),
                          .base = station.base});
    }
    const std::string program = input->file_name;
    script::Engine engine(std::move(robots), std::move(file->conveyors), std::move(run.options));
    engine.run(*std::move(input));
    auto report = finish(program, stations, engine);
    if (!report) return report;
    if (auto written = write_report(run.outputs.report, *report); !written)
        return tl::unexpected(written.error());
    return report;
}

}  // namespace gsim::apps
