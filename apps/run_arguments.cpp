#include "apps/run_arguments.h"

#include <fmt/format.h>

#include "apps/language_options.h"
#include "apps/limit_options.h"
#include "engine/run.h"

namespace gsim::apps {

namespace {

std::optional<Error> studies_contradiction(const RunArguments& arguments) {
    if (!arguments.studies.any()) return {};
    if (!arguments.request.robots.empty())
        return "--robots cannot be combined with --check-machine, --envelope or --draw-axes";
    if (!arguments.request.program.empty())
        return fmt::format("--check-machine, --envelope and --draw-axes run no program; remove {}",
                           arguments.request.program);
    if (arguments.outputs.any() || arguments.request.explain) {
        return "--check-machine, --envelope and --draw-axes run no program, so they write no report, moves "
               "or path; --check-machine prints its results, with --json as JSON";
    }
    if (!arguments.studies.check.empty() && !arguments.request.machine.empty())
        return "--check-machine names the machine file; remove --machine";
    return {};
}

std::optional<Error> robots_contradiction(const RunArguments& arguments) {
    if (arguments.request.robots.empty()) return {};
    if (!arguments.save_machine_data.empty()) return "--save-machine-data cannot be combined with --robots";
    if (arguments.outputs.on_standard_output())
        return "'-' cannot be combined with --robots: each robot has separate files";
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
    line.add("--machine", &a.request.machine,
             "machine file (TOML), or a LinuxCNC .ini; default: the built-in 5-axis waterjet gantry")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.request.machine_data,
             "machine data (NCFILE): work offsets, variables, aliases")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.request.cell,
             "cell file (TOML): the run is also checked for collisions and near misses in it; it may name "
             "the machine")
        .takes_file(FileKind::input, {".toml"});
    line.add("--no-collisions", &a.no_collisions,
             "do not check for collisions and near misses, neither of the machine's bodies nor in a cell");
    line.add("--probe", &a.request.probe,
             "surface that probes touch: z=-3.2 (or x=, y=) is a plane, in mm of machine coordinates of the "
             "tool's end; none: nothing; default: the bodies of the cell, or without a cell the targets of "
             "the probes")
        .with_value_name("none|AXIS=MM");
    add_language_options(line, a.request.language);
    line.add("--setup", &a.request.setup,
             "script (Lua) that runs before the program: user M codes, inputs, results of the probe")
        .takes_file(FileKind::input, {".lua"});
    line.add("--block-delete", &a.request.execution.block_delete, "skip blocks that begin with /");
}

void add_limit_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Limits");
    line.add("--stop-at-first", &a.request.execution.stop_at_first,
             "end the run with an alarm if an axis would exceed its limit, or the tool would violate a zone; "
             "otherwise the run continues and reports all of these");
    line.add("--passes", &a.request.execution.passes,
             "number of times to run a main program that ends in M99 and returns to its start")
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
             "do not confine the run before it begins; confinement blocks files outside the folders of its "
             "programs and outputs, other programs and the network (Linux, landlock)");
}

namespace {

void add_override_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Operator overrides");
    line.add("--feed-override", &a.request.overrides.feed_percent,
             "feed override of the complete run; M49, M50 P0, G63, threads and taps lock it")
        .with_value_name("PERCENT");
    line.add("--rapid-override", &a.request.overrides.rapid_percent, "rapid override of the complete run")
        .with_value_name("PERCENT");
    line.add("--spindle-override", &a.request.overrides.spindle_percent,
             "spindle override of the complete run: it affects motion that is synchronized with the spindle, "
             "or has a feed per revolution")
        .with_value_name("PERCENT");
    line.add("--overrides", &a.request.overrides.file,
             "changes of the overrides during the run, [[override]] with at_s, feed_percent, rapid_percent "
             "and spindle_percent (TOML); they affect the current move at once, and 0 stops it")
        .takes_file(FileKind::input, {".toml"});
}

/// Adds the options of a document, which follow the option of its file.
void add_document_options(engine::OutputKind output_kind, CommandLine& line, engine::OutputOptions& options) {
    if (output_kind == engine::OutputKind::trajectory) {
        line.add("--step", &options.step_s, "time between samples")
            .with_value_name("SECONDS")
            .within(engine::kMinStep_s, 1e6)
            .show_default();
        line.add("--forces", &options.forces,
                 "the trajectory includes the forces and torques of the motors, and their power");
        line.add("--following", &options.following,
                 "the trajectory includes the following errors of the axes, the actual position of the TCP "
                 "and its contour error");
    }
    if (output_kind == engine::OutputKind::plot) {
        line.add("--plot-plane", &options.plane, "plane of the picture: xy from above, zx or yz from a side")
            .one_of({"xy", "zx", "yz"})
            .show_default();
    }
}

void add_output_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Results");
    line.add("--json", &a.findings.json, "the report as JSON on standard output");
    add_sarif_option(line, a.findings);
    line.add("--quiet", &a.quiet, "no text report, no progress");
    line.add("--explain", &a.request.explain,
             "the report shows how the time is spent, and the min time that the path permits");
    line.add("--report", &a.outputs.report, "write the report as JSON to this file; -: standard output")
        .takes_file(FileKind::output, {".json"});
    line.add("--view", &a.outputs.view,
             "write a self-contained page that shows the run in a browser to this file; -: standard output")
        .takes_file(FileKind::output, {".html"});
#define GSIM_DOCUMENT(name, number, option, help, ...)                                   \
    line.add(option, &a.outputs.name, help).takes_file(FileKind::output, {__VA_ARGS__}); \
    add_document_options(engine::OutputKind::name, line, a.outputs.options);
#include "engine/outputs.def"
}

void add_persistence_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Persistent data of the controller");
    line.add("--variables", &a.request.variables,
             "store permanent variables in this file: read at the start, written at the end")
        .takes_file(FileKind::changed);
    line.add("--save-machine-data", &a.save_machine_data,
             "write the machine data as they are after the run to this file; it may be the file of "
             "--machine-data")
        .takes_file(FileKind::output, {".txt"})
        .may_share_file_with("--machine-data");
    add_wait_option(line, a.wait_s);
}

void add_misc_options(CommandLine& line, RunArguments& a) {
    line.begin_group("Other");
    line.add("--optional-stop", &a.request.execution.optional_stop, "stop at M01");
    line.add("--robots", &a.request.robots,
             "robots and conveyors that the script moves (TOML); moves, trajectories, drawings, plots and "
             "paths are written to one file for each robot")
        .takes_file(FileKind::input, {".toml"});
    line.add("--rcs", &a.request.module,
             "controller module (shared library) that plans instead of the built-in planner, in a separate "
             "process")
        .takes_file(FileKind::input, {".so"});
    line.add("--rcs-in-process", &a.module_in_process,
             "load the module into this process: for a debugger, and slightly faster; a crash of the module "
             "ends the program, and the run is not confined");
    line.add("--lua-lib", &a.request.library, "folder with the Lua library, instead of the built-in one")
        .takes_file(FileKind::folder);
}

}  // namespace

void add_run_options(CommandLine& line, RunArguments& a) {
    line.add("part.lua|part.nc", &a.request.program, "script or part program, or - for standard input")
        .takes_file(FileKind::input, {".lua", ".nc", ".ngc"});
    add_machine_options(line, a);
    add_output_options(line, a);
    line.begin_group("A machine without a program");
    line.add("--print-machine", &a.print_machine, "print the machine file and exit");
    add_study_options(line, a.studies);
    add_override_options(line, a);
    add_persistence_options(line, a);
    add_limit_options(line, a);
    add_misc_options(line, a);
    line.add_example("gsim-run part.nc", "the report: cycle time, moves, errors");
    line.add_example("gsim-run --machine mine.toml --plot part.svg part.nc",
                     "on another machine, with a picture");
    line.add_example("gsim-run --cell cell.toml part.nc", "collisions and near misses");
    line.add_example("gsim-run --json part.nc | jq .cycle_time_s", "one value, for a script");
    line.add_example("gsim-run --print-machine > mine.toml", "a machine file to start with");
    line.add_example("gsim-run --record - part.nc | path2gcode --dialect rs274ngc -",
                     "the same motion for another controller");
}

std::optional<Error> find_contradiction(const RunArguments& arguments) {
    if (auto contradiction = studies_contradiction(arguments)) return contradiction;
    if (auto contradiction = robots_contradiction(arguments)) return contradiction;
    if (auto conflict = arguments.outputs.conflict()) return conflict;
    if (arguments.findings.json && arguments.outputs.on_standard_output())
        return "--json and a file '-' both use standard output; write one of them to a file";
    return {};
}

}  // namespace gsim::apps
