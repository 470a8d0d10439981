// gsim-run: runs a script or a part program on a simulated machine and tells what it would do.

#include <algorithm>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/exit_status.h"
#include "apps/machine_data_file.h"
#include "apps/robots_run.h"
#include "apps/run_arguments.h"
#include "apps/run_inputs.h"
#include "apps/run_main.h"
#include "apps/variables_file.h"
#include "runtime/machine/machine_file.h"
#include "runtime/simulation/progress.h"
#include "runtime/simulation/report.h"

namespace {

using namespace gsim;
using apps::RunArguments;

constexpr const char* kProgram = "gsim-run";

int usage_error(const std::string& message) {
    return apps::usage_error(kProgram, message);
}

/// What the control keeps, in the files that are asked for.
tl::expected<void, std::string> keep(const RunArguments& arguments, script::Engine& engine,
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

bool has_collisions(const simulation::Report& report) {
    return report.cell && !report.cell->collisions.empty();
}

script::Engine::Options engine_options(const RunArguments& arguments, machine::MachineData data,
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
simulation::Report failed_report(const RunArguments& arguments, const machine::Machine& machine,
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

void print_report(const RunArguments& arguments, const simulation::Report& report) {
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
int run_robots(const RunArguments& arguments) {
    if (arguments.input.empty()) return usage_error("no program given; gsim-run --help tells how");
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
int run_studies(const RunArguments& arguments, const machine::Machine& machine) {
    const auto ended = apps::run_studies(arguments.studies, machine, arguments.cell,
                                         {.json = arguments.json, .quiet = arguments.quiet});
    if (!ended) return usage_error(ended.error());
    return std::fflush(stdout) == 0 ? *ended : usage_error("standard output cannot be written");
}

/// Runs what was read, and writes what was asked for.
int simulate(const RunArguments& arguments, apps::RunInputs inputs) {
    simulation::Simulator simulator(std::move(inputs.machine), arguments.limits, std::move(inputs.module));
    if (inputs.cell != nullptr) simulator.set_cell(*inputs.cell);
    tl::expected<apps::Outputs, std::string> outputs = apps::Outputs::open(arguments.outputs, simulator);
    if (!outputs) return usage_error(outputs.error());
    simulation::Progress progress(stderr, !arguments.quiet && ::isatty(STDERR_FILENO) == 1);
    script::Engine::Options options =
        engine_options(arguments, std::move(inputs.data), inputs.language, progress);
    options.setup = std::move(inputs.setup);
    script::Engine engine(simulator, options);
    const std::string program = inputs.program.file_name;
    engine.run(std::move(inputs.program));
    progress.clear();

    simulation::Report report = simulator.finish(program);
    engine.report(report);
    outputs->explain(report);
    const tl::expected<void, std::string> path = outputs->make_path(program);
    tl::expected<void, std::string> written = outputs->commit(report);
    if (written) written = keep(arguments, engine, inputs.document);
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

int run(const RunArguments& given) {
    if (const std::string fault = find_contradiction(given); !fault.empty()) return usage_error(fault);
    if (!given.robots.empty()) return run_robots(given);
    const tl::expected<RunArguments, std::string> with_cell = apps::with_files_of_cell(given);
    if (!with_cell) return usage_error(with_cell.error());
    const RunArguments& arguments = *with_cell;
    const tl::expected<machine::Machine, std::string> machine = apps::read_machine(arguments);
    if (!machine) return usage_error(machine.error());
    if (arguments.print_machine) {
        std::printf("%s", machine::print_machine(*machine).c_str());
        return std::fflush(stdout) == 0 ? apps::kDone : usage_error("standard output cannot be written");
    }
    if (arguments.studies.any()) return run_studies(arguments, *machine);
    if (arguments.input.empty()) return usage_error("no program given; gsim-run --help tells how");
    tl::expected<apps::RunInputs, apps::InputError> inputs = apps::read_run_inputs(arguments, *machine);
    if (inputs) return simulate(arguments, *std::move(inputs));
    if (!inputs.error().in_program) return usage_error(inputs.error().message);
    if (arguments.json) print_report(arguments, failed_report(arguments, *machine, inputs.error().message));
    return apps::kProgramFault;
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<RunArguments>(
        argc, argv, kProgram,
        "Simulates a script or a part program: cycle time, moves, trajectory, what goes wrong.",
        apps::add_run_options, run);
}
