// gsim-run: runs a script or a part program on a simulated machine and tells what it would do.

#include <algorithm>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "apps/exit_status.h"
#include "apps/language.h"
#include "apps/machine_data_file.h"
#include "apps/machine_studies.h"
#include "apps/outputs.h"
#include "apps/robots_run.h"
#include "apps/run_main.h"
#include "apps/script_input.h"
#include "apps/variables_file.h"
#include "runtime/cell/cell_file.h"
#include "runtime/machine/machine_file.h"
#include "runtime/rcs/rcs_machine.h"
#include "runtime/rrs/rcs_host.h"
#include "runtime/script/engine.h"
#include "runtime/simulation/cell_watch.h"
#include "runtime/simulation/progress.h"
#include "runtime/simulation/report.h"
#include "runtime/simulation/simulator.h"

namespace {

using namespace gsim;

struct Arguments {
    std::string input;
    std::string machine;
    std::string machine_data;
    std::string save_machine_data;
    std::string cell;
    apps::LanguageNames language;
    std::string setup;
    std::string variables;
    std::string lua_lib;
    std::string rcs;
    std::string robots;
    apps::OutputNames outputs;
    apps::MachineStudies studies;
    simulation::RunLimits limits;
    std::size_t memory_mb = 2048;
    std::uint64_t max_steps = script::LuaState::Limits{}.steps;
    bool json = false;
    bool quiet = false;
    bool print_machine = false;
    bool block_delete = false;
    bool optional_stop = false;
};

constexpr const char* kProgram = "gsim-run";

int usage_error(const std::string& message) {
    return apps::usage_error(kProgram, message);
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("part.lua|part.nc", a.input, "script or part program, or - for standard input");
    app.add_option("--machine", a.machine,
                   "machine file (TOML); without it the 5-axis waterjet gantry that is built in");
    app.add_option("--machine-data", a.machine_data,
                   "machine data (NCFILE): work offsets, variables, aliases");
    app.add_option("--save-machine-data", a.save_machine_data,
                   "write the machine data as the program left them to this file; it may be the same one");
    app.add_option("--cell", a.cell,
                   "cell file (TOML): the run is looked at for collisions and near misses; it may name the "
                   "machine, too");
    app.add_flag("--print-machine", a.print_machine, "print the machine file and end");
    apps::add_study_options(app, a.studies);
    apps::add_language_options(app, a.language);
    app.add_option("--setup", a.setup,
                   "script (Lua) that runs before the program: user M codes, inputs, answers of the probe")
        ->check(CLI::ExistingFile);
    app.add_option("--variables", a.variables,
                   "keep permanent variables in this file: read at the start, written at the end");
    app.add_flag("--json", a.json, "the report as JSON on standard output");
    app.add_flag("--quiet", a.quiet, "no report for people, no progress");
    app.add_flag("--explain", a.outputs.explain,
                 "the report tells where the time goes, and the least time that the path allows");
    app.add_option("--report", a.outputs.report, "write the report as JSON to this file; -: standard output");
    app.add_option("--moves", a.outputs.moves,
                   "write each move as a line of JSON to this file; -: standard output");
    app.add_option("--trajectory", a.outputs.trajectory,
                   "write samples of the trajectory to this CSV file; -: standard output");
    app.add_option("--step", a.outputs.step_s, "seconds between samples")
        ->check(CLI::Range(simulation::TrajectoryWriter::kMinStep_s, 1e6))
        ->capture_default_str();
    app.add_option("--plot", a.outputs.plot,
                   "draw path, speed and acceleration into this .svg or .png file (needs gnuplot)");
    app.add_option("--record", a.outputs.record,
                   "write what was run as a path to this file, for path2gcode; -: standard output");
    app.add_flag("--block-delete", a.block_delete, "leave out blocks that begin with /");
    app.add_flag("--optional-stop", a.optional_stop, "M01 stops");
    app.add_option("--max-time", a.limits.max_time_s, "end the run after this many seconds of machine time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--max-blocks", a.limits.max_blocks, "end the run after this many blocks")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--max-steps", a.max_steps,
                   "end the run after this many steps of the script without a motion")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--memory", a.memory_mb, "MB that the script may use")
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 20U))
        ->capture_default_str();
    app.add_option("--lua-lib", a.lua_lib,
                   "folder with the library in Lua, in place of the one that is built in")
        ->check(CLI::ExistingDirectory);
    app.add_option("--rcs", a.rcs,
                   "controller module (shared library) that plans in place of the built-in planner")
        ->check(CLI::ExistingFile);
    app.add_option(
           "--robots", a.robots,
           "robots and conveyors that the script moves (TOML); files of moves, trajectories and plots are "
           "one for each robot")
        ->check(CLI::ExistingFile);
    app.set_version_flag("--version", "gsim-run " GSIM_VERSION);
}

tl::expected<machine::Machine, std::string> read_machine(const Arguments& arguments) {
    if (!arguments.studies.check.empty()) return machine::load_machine(arguments.studies.check);
    if (arguments.machine.empty())
        return machine::read_machine(machine::built_in_machine_toml(), "built-in machine");
    return machine::load_machine(arguments.machine);
}

tl::expected<machine::MachineDataDocument, std::string> read_data(const Arguments& arguments,
                                                                  const machine::Machine& machine) {
    if (arguments.machine_data.empty()) return machine::MachineDataDocument(machine.axes);
    return apps::open_machine_data(arguments.machine_data, machine.axes).map_error([](const auto& errors) {
        return errors.front();
    });
}

/// What the control keeps, in the files that are asked for.
tl::expected<void, std::string> keep(const Arguments& arguments, script::Engine& engine,
                                     machine::MachineDataDocument& document) {
    tl::expected<void, std::string> kept;
    if (!arguments.variables.empty()) {
        kept = engine.permanent_variables().and_then([&](const std::map<int, double>& values) {
            return apps::write_variables(arguments.variables, values);
        });
    }
    if (!kept || arguments.save_machine_data.empty()) return kept;
    return engine.machine_data()
        .and_then([&](const machine::MachineData& data) { return document.update(data); })
        .map_error([&](const std::string& error) {
            return fmt::format("{} is not written: {}", arguments.save_machine_data, error);
        })
        .and_then([&] { return apps::save_text(arguments.save_machine_data, document.text()); });
}

/// The files that the cell file names stand for options that are not given.
tl::expected<Arguments, std::string> with_files_of_cell(Arguments arguments) {
    if (arguments.cell.empty()) return arguments;
    return cell::load_cell_files(arguments.cell).map([&](const cell::CellFiles& files) {
        if (arguments.machine.empty()) arguments.machine = files.machine.string();
        if (arguments.machine_data.empty()) arguments.machine_data = files.machine_data.string();
        return std::move(arguments);
    });
}

/// Null where no cell is asked for.
tl::expected<std::unique_ptr<simulation::CellWatch>, std::string> read_cell(const Arguments& arguments,
                                                                            const machine::Machine& machine) {
    if (arguments.cell.empty()) return nullptr;
    return cell::load_cell(arguments.cell, machine).map([&](cell::Cell cell) {
        return std::make_unique<simulation::CellWatch>(std::move(cell), machine);
    });
}

bool has_collisions(const simulation::Report& report) {
    return report.cell && !report.cell->collisions.empty();
}

/// Nothing where no controller module is asked for.
tl::expected<std::optional<rrs::RcsModule>, std::string> load_module(const Arguments& arguments,
                                                                     const machine::Machine& machine) {
    std::optional<rrs::RcsModule> none;
    if (arguments.rcs.empty()) return none;
    const rcs::RcsMachine described(simulation::planner_setup(machine));
    auto library = rrs::RcsLibrary::load(arguments.rcs, described.get());
    if (!library) return tl::unexpected(std::move(library.error()));
    return rrs::RcsModule::create(*std::move(library), described.get()).map([](rrs::RcsModule module) {
        return std::optional<rrs::RcsModule>(std::move(module));
    });
}

script::Engine::Options engine_options(const Arguments& arguments, machine::MachineData data,
                                       const apps::Language& language, simulation::Progress& progress) {
    script::Engine::Options options;
    options.limits.memory_bytes = arguments.memory_mb << 20U;
    options.limits.steps = arguments.max_steps;
    if (!arguments.lua_lib.empty()) options.library = script::Library(arguments.lua_lib);
    options.data = std::move(data);
    options.find_program = apps::program_finder(arguments.input, language);
    options.dialect = language.dialect->name();
    options.block_delete = arguments.block_delete;
    options.optional_stop = arguments.optional_stop;
    options.progress = [&progress](std::uint64_t done, std::uint64_t total) { progress.update(done, total); };
    return options;
}

/// A program with errors is not run: the report says so, for those who read reports alone.
simulation::Report failed_report(const Arguments& arguments, const machine::Machine& machine,
                                 const std::string& message) {
    simulation::Report report;
    report.program = arguments.input == "-" ? "stdin" : arguments.input;
    report.machine = machine.name;
    if (arguments.rcs.empty()) report.controller = machine.controller.model;
    report.status = simulation::RunStatus::alarm;
    report.alarm = simulation::Alarm{};
    report.alarm->message = "the program has errors: " + message;
    return report;
}

/// What must be said even where no report is wanted.
void print_faults(const simulation::Report& report) {
    if (has_collisions(report))
        std::fprintf(stderr, "collisions in the cell: %zu\n", report.cell->collisions.size());
    if (!report.alarm) return;
    const simulation::Place place = report.alarm->place;
    const std::string where =
        place.line > 0 ? fmt::format("{}:{}: ", report.files[place.file], place.line) : "";
    std::fprintf(stderr, "%s%s: %s\n", where.c_str(), std::string(name(report.status)).c_str(),
                 report.alarm->message.c_str());
    for (const simulation::OpenCall& call : report.alarm->calls) {
        std::fprintf(stderr, "  in %s, called at %s:%u\n", call.program.c_str(),
                     report.files[call.place.file].c_str(), call.place.line);
    }
}

void print_report(const Arguments& arguments, const simulation::Report& report) {
    if (arguments.json) {
        std::printf("%s\n", simulation::to_json(report).c_str());
    } else if (!arguments.quiet) {
        // What goes to standard output stands alone there.
        std::FILE* stream = arguments.outputs.on_standard_output() ? stderr : stdout;
        std::fputs(simulation::to_text(report).c_str(), stream);
    } else {
        print_faults(report);
    }
}

/// A run of several robots, each with the machine that the file of robots gives it.
int run_robots(const Arguments& arguments) {
    for (const auto& [value, option] : {std::pair{&arguments.machine, "--machine"},
                                        {&arguments.machine_data, "--machine-data"},
                                        {&arguments.save_machine_data, "--save-machine-data"},
                                        {&arguments.cell, "--cell"},
                                        {&arguments.rcs, "--rcs"},
                                        {&arguments.variables, "--variables"}}) {
        if (!value->empty()) return usage_error(fmt::format("{} does not go with --robots", option));
    }
    if (arguments.input.empty()) return usage_error("no program given; gsim-run --help tells how");
    if (arguments.outputs.on_standard_output())
        return usage_error("'-' does not go with --robots: each robot has files of its own");
    simulation::Progress progress(stderr, false);
    apps::RobotsRun run;
    run.input = arguments.input;
    run.robots = arguments.robots;
    run.setup = arguments.setup;
    run.language = arguments.language;
    run.outputs = arguments.outputs;
    run.limits = arguments.limits;
    run.options = engine_options(arguments, {}, {}, progress);
    tl::expected<simulation::RobotsReport, apps::InputError> report = apps::run_robots(std::move(run));
    if (!report) return report.error().in_program ? apps::kProgramFault : usage_error(report.error().message);
    if (arguments.json) {
        std::printf("%s\n", simulation::to_json(*report).c_str());
    } else if (!arguments.quiet) {
        std::printf("%s", simulation::to_text(*report).c_str());
    } else {
        print_report(arguments, report->whole);
    }
    if (std::fflush(stdout) != 0) return usage_error("standard output cannot be written");
    const bool collided =
        std::any_of(report->robots.begin(), report->robots.end(),
                    [](const simulation::RobotReport& robot) { return has_collisions(robot.report); });
    const bool completed = report->whole.status == simulation::RunStatus::completed;
    return completed && !collided ? apps::kDone : apps::kProgramFault;
}

/// What is told of a machine without a program.
int run_studies(const Arguments& arguments, const machine::Machine& machine) {
    const auto ended = apps::run_studies(arguments.studies, machine, arguments.cell,
                                         {.json = arguments.json, .quiet = arguments.quiet});
    if (!ended) return usage_error(ended.error());
    return std::fflush(stdout) == 0 ? *ended : usage_error("standard output cannot be written");
}

/// Why options do not go together; empty where they do.
std::string find_contradiction(const Arguments& arguments) {
    if (!arguments.studies.any()) return {};
    if (!arguments.robots.empty()) return "--robots does not go with --check-machine or --envelope";
    if (!arguments.input.empty())
        return fmt::format("--check-machine and --envelope run no program; take away {}", arguments.input);
    if (!arguments.outputs.report.empty())
        return "--report is of a run; --check-machine prints, with --json as JSON";
    if (!arguments.studies.check.empty() && !arguments.machine.empty())
        return "--check-machine names the machine file; take away --machine";
    return {};
}

int run(const Arguments& given) {
    if (const std::string fault = find_contradiction(given); !fault.empty()) return usage_error(fault);
    if (!given.robots.empty()) return run_robots(given);
    if (const auto conflict = given.outputs.conflict()) return usage_error(*conflict);
    if (given.json && given.outputs.on_standard_output())
        return usage_error("--json and a file '-' both want standard output; give one of them a file");
    const tl::expected<Arguments, std::string> with_cell = with_files_of_cell(given);
    if (!with_cell) return usage_error(with_cell.error());
    const Arguments& arguments = *with_cell;
    tl::expected<machine::Machine, std::string> machine = read_machine(arguments);
    if (!machine) return usage_error(machine.error());
    if (arguments.print_machine) {
        std::printf("%s", machine::print_machine(*machine).c_str());
        return std::fflush(stdout) == 0 ? apps::kDone : usage_error("standard output cannot be written");
    }
    if (arguments.studies.any()) return run_studies(arguments, *machine);
    if (arguments.input.empty()) return usage_error("no program given; gsim-run --help tells how");
    tl::expected<machine::MachineDataDocument, std::string> document = read_data(arguments, *machine);
    if (!document) return usage_error(document.error());
    machine::MachineData data = document->data();
    if (!arguments.variables.empty()) {
        const auto variables = apps::read_variables(arguments.variables);
        if (!variables) return usage_error(variables.error());
        for (const auto& [number, value] : *variables) data.variables[number] = value;
    }
    tl::expected<apps::Language, std::string> language = apps::language_of(arguments.language, data);
    if (!language) return usage_error(language.error());

    tl::expected<script::Script, apps::InputError> input = apps::read_script(arguments.input, *language);
    if (!input) {
        if (!input.error().in_program) return usage_error(input.error().message);
        if (arguments.json)
            print_report(arguments, failed_report(arguments, *machine, input.error().message));
        return apps::kProgramFault;
    }
    language->dialect = grammar::dialect_named(input->dialect);
    std::optional<script::Script> setup;
    if (!arguments.setup.empty()) {
        tl::expected<script::Script, apps::InputError> script = apps::read_script(arguments.setup, *language);
        if (!script) return usage_error(script.error().message);
        setup = std::move(*script);
    }
    const std::string program = input->file_name;
    tl::expected<std::optional<rrs::RcsModule>, std::string> module = load_module(arguments, *machine);
    if (!module) return usage_error(module.error());
    const auto cell = read_cell(arguments, *machine);
    if (!cell) return usage_error(cell.error());
    simulation::Simulator simulator(std::move(*machine), arguments.limits, *std::move(module));
    if (*cell) simulator.set_cell(**cell);
    tl::expected<apps::Outputs, std::string> outputs = apps::Outputs::open(arguments.outputs, simulator);
    if (!outputs) return usage_error(outputs.error());
    simulation::Progress progress(stderr, !arguments.quiet && ::isatty(STDERR_FILENO) == 1);
    script::Engine::Options options = engine_options(arguments, std::move(data), *language, progress);
    options.setup = std::move(setup);
    script::Engine engine(simulator, options);
    engine.run(std::move(*input));
    progress.clear();

    simulation::Report report = simulator.finish(program);
    engine.report(report);
    outputs->explain(report);
    const tl::expected<void, std::string> path = outputs->make_path(program);
    tl::expected<void, std::string> written = outputs->commit(report);
    if (written) written = keep(arguments, engine, *document);
    print_report(arguments, report);
    if (std::fflush(stdout) != 0) return usage_error("standard output cannot be written");
    if (!written) return usage_error(written.error());
    if (!path) {
        std::fprintf(stderr, "%s: %s\n", kProgram, path.error().c_str());
        return apps::kProgramFault;
    }
    const bool done = report.status == simulation::RunStatus::completed && !has_collisions(report);
    return done ? apps::kDone : apps::kProgramFault;
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<Arguments>(
        argc, argv, kProgram,
        "Simulates a script or a part program: cycle time, moves, trajectory, what goes wrong.", add_options,
        run);
}
