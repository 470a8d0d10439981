#include "apps/run_arguments.h"

#include <fmt/format.h>

#include "apps/language_options.h"
#include "apps/limit_options.h"
#include "engine/run.h"

namespace gsim::apps {

namespace {

std::string studies_contradiction(const RunArguments& arguments) {
    if (!arguments.studies.any()) return {};
    if (!arguments.request.robots.empty())
        return "--robots does not go with --check-machine, --envelope or --draw-axes";
    if (!arguments.request.program.empty())
        return fmt::format("--check-machine, --envelope and --draw-axes run no program; take away {}",
                           arguments.request.program);
    if (arguments.outputs.any() || arguments.request.explain) {
        return "--check-machine, --envelope and --draw-axes run no program, of which there would be a "
               "report, "
               "moves or a path; --check-machine prints, with --json as JSON";
    }
    if (!arguments.studies.check.empty() && !arguments.request.machine.empty())
        return "--check-machine names the machine file; take away --machine";
    return {};
}

std::string robots_contradiction(const RunArguments& arguments) {
    if (arguments.request.robots.empty()) return {};
    if (!arguments.save_machine_data.empty()) return "--save-machine-data does not go with --robots";
    if (arguments.outputs.on_standard_output())
        return "'-' does not go with --robots: each robot has files of its own";
    return {};
}

}  // namespace

engine::Request make_request(const RunArguments& arguments) {
    engine::Request request = arguments.request;
    request.collisions = !arguments.no_collisions;
    request.limits.memory_bytes = arguments.memory_mb << 20U;
    return request;
}

void add_machine_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Machine and language");
    line.add(
            "--machine", &a.request.machine,
            "machine file (TOML), or a LinuxCNC .ini; without it the 5-axis waterjet gantry that is built in")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.request.machine_data,
             "machine data (NCFILE): work offsets, variables, aliases")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.request.cell,
             "cell file (TOML): the run is looked at for collisions and near misses in it, too; it may name "
             "the machine")
        .takes_file(FileKind::input, {".toml"});
    line.add("--no-collisions", &a.no_collisions,
             "do not look for collisions and near misses: neither of the machine's own bodies nor in a cell");
    line.add("--probe", &a.request.probe,
             "what probes touch: z=-3.2 (or x=, y=) is a plane, in mm of machine coordinates of the tool's "
             "end; "
             "none: nothing; without it the bodies of the cell, or without one their targets")
        .with_value_name("none|AXIS=MM");
    add_language_options(line, a.request.language);
    line.add("--setup", &a.request.setup,
             "script (Lua) that runs before the program: user M codes, inputs, answers of the probe")
        .takes_file(FileKind::input, {".lua"});
    line.add("--block-delete", &a.request.block_delete, "leave out blocks that begin with /");
}

void add_limit_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Limits");
    line.add("--stop-at-first", &a.request.stop_at_first,
             "end the run with an alarm where an axis would pass its limit, or the tool break a zone's rule; "
             "else it goes on, and all of these are told");
    line.add("--passes", &a.request.passes,
             "how often to run a main program that ends in M99 and leads back to its start")
        .with_value_name("N")
        .within(1, 1'000'000)
        .show_default();
    line.add("--max-time", &a.request.limits.machine_s, "end the run after this many seconds of machine time")
        .with_value_name("SECONDS")
        .make_positive()
        .show_default();
    line.add("--max-blocks", &a.request.limits.blocks, "end the run after this many blocks")
        .make_positive()
        .show_default();
    line.add("--max-steps", &a.request.limits.steps,
             "end the run after this many steps of the script without a motion")
        .show_default();
    add_cpu_option(line, a.request.limits.cpu_s);
    add_memory_option(line, a.memory_mb);
    line.add("--no-confine", &a.no_confine,
             "do not take from the run, before it begins, what it does not need: all files but those in the "
             "folders of its programs and outputs, other programs, the network (Linux, landlock)");
}

namespace {

void add_override_options(CommandLine& line, RunArguments& a) {
    line.begin_group("The operator");
    line.add("--feed-override", &a.request.overrides.feed_percent,
             "feed override of the whole run; M49, M50 P0, G63, threads and taps lock it")
        .with_value_name("PERCENT");
    line.add("--rapid-override", &a.request.overrides.rapid_percent, "rapid override of the whole run")
        .with_value_name("PERCENT");
    line.add("--spindle-override", &a.request.overrides.spindle_percent,
             "spindle override of the whole run: it changes what moves in step with the spindle, or with a "
             "feed per revolution")
        .with_value_name("PERCENT");
    line.add("--overrides", &a.request.overrides.file,
             "changes of the overrides in the course of the run, [[override]] with at_s, feed_percent, "
             "rapid_percent and spindle_percent (TOML); a move under way obeys at once, and 0 holds it")
        .takes_file(FileKind::input, {".toml"});
}

/// Adds the options of a document after the option of its file.
void add_document_options(engine::OutputKind output_kind, CommandLine& line, engine::OutputOptions& options) {
    if (output_kind == engine::OutputKind::trajectory) {
        line.add("--step", &options.step_s, "time between samples")
            .with_value_name("SECONDS")
            .within(engine::kMinStep_s, 1e6)
            .show_default();
        line.add("--forces", &options.forces,
                 "the trajectory has the forces and torques of the motors, and their power");
        line.add("--following", &options.following,
                 "the trajectory has the following errors of the axes, where the tip really is, and how far "
                 "that is from its way");
    }
    if (output_kind == engine::OutputKind::plot) {
        line.add("--plot-plane", &options.plane,
                 "what the picture shows the path in: xy from above, zx or yz from a side")
            .one_of({"xy", "zx", "yz"})
            .show_default();
    }
}

void add_output_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Results");
    line.add("--json", &a.findings.json, "the report as JSON on standard output");
    add_sarif_option(line, a.findings);
    line.add("--quiet", &a.quiet, "no report for people, no progress");
    line.add("--explain", &a.request.explain,
             "the report tells where the time goes, and the least time that the path allows");
    line.add("--report", &a.outputs.report, "write the report as JSON to this file; -: standard output")
        .takes_file(FileKind::output, {".json"});
    line.add("--view", &a.outputs.view,
             "write a page that shows the run in a browser, with all that it needs in it, to this file; -: "
             "standard "
             "output")
        .takes_file(FileKind::output, {".html"});
#define GSIM_DOCUMENT(name, number, option, help, ...)                                   \
    line.add(option, &a.outputs.name, help).takes_file(FileKind::output, {__VA_ARGS__}); \
    add_document_options(engine::OutputKind::name, line, a.outputs.options);
#include "engine/outputs.def"
}

void add_persistence_options(CommandLine& line, RunArguments& a) {
    line.begin_group("What the control keeps");
    line.add("--variables", &a.request.variables,
             "keep permanent variables in this file: read at the start, written at the end")
        .takes_file(FileKind::changed);
    line.add("--save-machine-data", &a.save_machine_data,
             "write the machine data as the program left them to this file; it may be the same one")
        .takes_file(FileKind::output, {".txt"})
        .may_share_file_with("--machine-data");
    add_wait_option(line, a.wait_s);
}

void add_misc_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Further");
    line.add("--optional-stop", &a.request.optional_stop, "M01 stops");
    line.add("--robots", &a.request.robots,
             "robots and conveyors that the script moves (TOML); files of moves, trajectories, drawings, "
             "plots "
             "and paths are one for each robot")
        .takes_file(FileKind::input, {".toml"});
    line.add(
            "--rcs", &a.request.module,
            "controller module (shared library) that plans in place of the built-in planner, in a process of "
            "its own")
        .takes_file(FileKind::input, {".so"});
    line.add(
        "--rcs-in-process", &a.module_in_process,
        "load the module into this process: for a debugger, and a little faster; a crash of the module is "
        "one of the program, and the run is not confined");
    line.add("--lua-lib", &a.request.library,
             "folder with the library in Lua, in place of the one that is built in")
        .takes_file(FileKind::folder);
}

}  // namespace

void add_run_options(CommandLine& line, RunArguments& a) {
    line.add("part.lua|part.nc", &a.request.program, "script or part program, or - for standard input")
        .takes_file(FileKind::input, {".lua", ".nc", ".ngc"});
    add_machine_options(line, a);
    add_output_options(line, a);
    line.begin_group("A machine without a program");
    line.add("--print-machine", &a.print_machine, "print the machine file and end");
    add_study_options(line, a.studies);
    add_override_options(line, a);
    add_persistence_options(line, a);
    add_limit_options(line, a);
    add_misc_options(line, a);
    line.add_example("gsim-run part.nc", "the report: cycle time, moves, what went wrong");
    line.add_example("gsim-run --machine mine.toml --plot part.svg part.nc",
                     "on another machine, with a picture");
    line.add_example("gsim-run --cell cell.toml part.nc", "collisions and near misses");
    line.add_example("gsim-run --json part.nc | jq .cycle_time_s", "one figure, for a script");
    line.add_example("gsim-run --print-machine > mine.toml", "a machine file to begin with");
    line.add_example("gsim-run --record - part.nc | path2gcode --dialect rs274ngc -",
                     "the same motion for another control");
}

std::string find_contradiction(const RunArguments& arguments) {
    if (std::string contradiction = studies_contradiction(arguments); !contradiction.empty())
        return contradiction;
    if (std::string contradiction = robots_contradiction(arguments); !contradiction.empty())
        return contradiction;
    if (const auto conflict = arguments.outputs.conflict()) return *conflict;
    if (arguments.findings.json && arguments.outputs.on_standard_output())
        return "--json and a file '-' both want standard output; give one of them a file";
    return {};
}

}  // namespace gsim::apps
