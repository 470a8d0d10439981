#include "apps/run_arguments.h"

#include <utility>

#include <fmt/format.h>

#include "runtime/simulation/trajectory_writer.h"

namespace gsim::apps {

namespace {

std::string contradiction_of_studies(const RunArguments& arguments) {
    if (!arguments.studies.any()) return {};
    if (!arguments.robots.empty()) return "--robots does not go with --check-machine or --envelope";
    if (!arguments.input.empty())
        return fmt::format("--check-machine and --envelope run no program; take away {}", arguments.input);
    if (arguments.outputs.any() || arguments.outputs.explain) {
        return "--check-machine and --envelope run no program, of which there would be a report, moves or a "
               "path; --check-machine prints, with --json as JSON";
    }
    if (!arguments.studies.check.empty() && !arguments.machine.empty())
        return "--check-machine names the machine file; take away --machine";
    return {};
}

std::string contradiction_of_robots(const RunArguments& arguments) {
    if (arguments.robots.empty()) return {};
    for (const auto& [value, option] : {std::pair{&arguments.machine, "--machine"},
                                        {&arguments.machine_data, "--machine-data"},
                                        {&arguments.save_machine_data, "--save-machine-data"},
                                        {&arguments.cell, "--cell"},
                                        {&arguments.rcs, "--rcs"},
                                        {&arguments.variables, "--variables"}}) {
        if (!value->empty()) return fmt::format("{} does not go with --robots", option);
    }
    if (arguments.outputs.on_standard_output())
        return "'-' does not go with --robots: each robot has files of its own";
    return {};
}

}  // namespace

void add_run_options(CLI::App& app, RunArguments& a) {
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
    add_study_options(app, a.studies);
    add_language_options(app, a.language);
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

std::string find_contradiction(const RunArguments& arguments) {
    if (std::string fault = contradiction_of_studies(arguments); !fault.empty()) return fault;
    if (std::string fault = contradiction_of_robots(arguments); !fault.empty()) return fault;
    if (const auto conflict = arguments.outputs.conflict()) return *conflict;
    if (arguments.json && arguments.outputs.on_standard_output())
        return "--json and a file '-' both want standard output; give one of them a file";
    return {};
}

}  // namespace gsim::apps
