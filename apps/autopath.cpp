// autopath: from a drawing or a solid to the path that a jet cuts it out by.

#include <array>
#include <cstdio>
#include <string>

#include "apps/confine_run.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "base/units.h"
#include "engine/drawing_path.h"
#include "engine/system/host_of_system.h"

namespace {

using namespace gsim;

struct AutopathArguments {
    engine::DrawingRequest request;
    std::string output;  ///< Empty: standard output.
    std::string units;
    bool report = false;
    double max_cpu_s = apps::kMaxCpu_s;
    bool no_confine = false;
    apps::FindingOptions findings;
};

using Kind = text::DiagnosticKind;

constexpr const char* kAutopath = "autopath";

void add_material_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::CuttingChoice& cutting = arguments.request.cutting;
    line.begin_group("Material");
    line.add("--material", &cutting.material, "material, as the materials file names it");
    line.add("--thickness", &cutting.thickness_mm, "of the material (that of the solid)").called("MM");
    line.add("--quality", &cutting.quality, "of the edge, 1 (just through) to 5 (finest)");
    line.add("--materials", &cutting.materials, "materials file (TOML) instead of the built-in one")
        .of_file(apps::FileKind::input, {".toml"});
    line.add("--speed", &cutting.speed_mm_min, "cutting speed, instead of the material's")
        .called("MM/MIN")
        .within(1e-3, 1e6);
    line.add("--kerf", &cutting.kerf_mm, "width of the cut, instead of the material's")
        .called("MM")
        .within(1e-3, 100);
    line.add("--pierce", &cutting.pierce_s, "time of a pierce, instead of the material's")
        .called("SECONDS")
        .within(0, 3600);
    line.add("--moving-pierce", &cutting.moving_pierce,
             "move the nozzle to and fro on the lead while it pierces, which takes less time");
    line.add("--straighten", &cutting.straighten,
             "lean the jet against the taper of its kerf, so that sides get straight");
    line.add("--report", &arguments.report, "print how the values were found and what the job costs")
        .not_with("--json");
}

void add_path_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::CuttingWays& ways = arguments.request.ways;
    line.begin_group("Path");
    line.add("--at", &ways.origin_mm,
             "where the drawing's origin, on the material's upper side, lies in the work frame, in mm")
        .called("X Y Z")
        .within(-1e6, 1e6)
        .shows_default();
    line.add("--lead", &ways.lead_mm, "radius of leads (three kerfs)").called("MM").within(0.05, 1000);
    line.add("--safe-height", &ways.safe_height_mm, "height of ways between cuts")
        .called("MM")
        .within(0, 10'000)
        .shows_default();
    line.add("--cut-height", &ways.cut_height_mm, "height of the nozzle's tip over the material")
        .called("MM")
        .within(0, 1000)
        .shows_default();
    line.add("--bevel", &ways.bevel_deg,
             "lean of the jet, but for edges that have a bevel of their own; above 0 the part is smaller "
             "below")
        .called("DEG")
        .within(-60, 60)
        .shows_default();
}

void add_reading_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::DrawingChoice& reading = arguments.request.reading;
    line.begin_group("Drawing or solid");
    line.add("--unit", &arguments.units, "of the drawing (what the drawing says)").one_of({"mm", "inch"});
    line.add("--layer", &reading.layers, "only what is on this layer; may be given more than once (DXF)");
    line.add("--tolerance", &reading.gap_mm, "join ends that are nearer than this")
        .called("MM")
        .within(1e-6, 10)
        .shows_default();
    line.add("--curve-tolerance", &reading.curve_tolerance_mm, "how far arcs may be off splines and ellipses")
        .called("MM")
        .within(1e-5, 10)
        .shows_default();
    line.add("--up", &reading.up, "where the upper side looks (that of the largest face; STEP, IGES)")
        .one_of({"x", "y", "z", "-x", "-y", "-z"});
    line.add("--flip", &reading.flip, "turn the plate over (STEP, IGES)");
}

void add_autopath_options(apps::CommandLine& line, AutopathArguments& arguments) {
    using apps::FileKind;
    line.add("drawing", &arguments.request.drawing,
             "drawing: .dxf, .svg; flat part: .step, .stp, .iges, .igs")
        .of_file(FileKind::input, {".dxf", ".svg", ".step", ".stp", ".iges", ".igs"})
        .must_be_given();
    line.begin_group("Output");
    line.add("-o,--output", &arguments.output,
             "write the path to this file; it appears only if all went well")
        .of_file(FileKind::output, {".json"});
    add_material_options(line, arguments);
    add_path_options(line, arguments);
    add_reading_options(line, arguments);
    line.begin_group("Limits");
    apps::add_cpu_option(line, arguments.max_cpu_s);
    apps::add_confine_option(line, arguments.no_confine);
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, arguments.findings);
    line.add_example("autopath plate.svg --material aluminum --thickness 12 -o plate.path.json",
                     "cutting speeds, kerf and piercing by the material");
    line.add_example("autopath plate.dxf --speed 400 --kerf 1 | path2gcode -",
                     "by your own figures, to a part program");
}

engine::DrawingRequest request_of(const AutopathArguments& arguments) {
    engine::DrawingRequest request = arguments.request;
    request.host = engine::host_of_system();
    if (!arguments.units.empty()) request.reading.unit_mm = arguments.units == "inch" ? kMmPerInch : 1;
    return request;
}

tl::expected<void, std::string> write_path(const engine::DrawingPath& path, const std::string& name) {
    auto file = os::OutputFile::open(name);
    if (!file) return tl::unexpected(file.error());
    path.write([&](std::string_view text) { return file->write(text); });
    return file->commit();
}

void tell_summary(const std::string& sentence, apps::Findings& findings) {
    if (findings.options().json) {
        findings.take({.severity = text::Severity::note, .kind = Kind::path, .text = sentence});
    } else {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
}

/// From here on nothing is needed but the drawing and the outputs. Solids are read by a program of their own,
/// which needs its libraries.
tl::expected<void, std::string> confine_reading(const AutopathArguments& arguments,
                                                const engine::DrawingPath& path) {
    if (arguments.no_confine || path.is_solid()) return {};
    return apps::confine_to(std::array{path.drawing_file()},
                            std::array{arguments.output, arguments.findings.sarif});
}

/// A drawing that cannot be cut is no fault of who runs this.
int tell_failure(apps::Findings& findings, const engine::Failure& failure) {
    const int status = findings.fail(failure);
    return failure.in_program ? apps::kProgramFault : status;
}

/// Makes the path as the arguments say, and tells what is wrong; the exit status.
int make_path(const AutopathArguments& arguments, apps::Findings& findings) {
    const apps::CpuBackstop cpu(arguments.max_cpu_s);
    if (const auto conflict = apps::sarif_conflict(findings.options(), apps::product_name(arguments.output)))
        return findings.fail(Kind::usage, *conflict);
    auto path = engine::DrawingPath::open(request_of(arguments));
    if (!path) return findings.fail(path.error());
    if (auto confined = confine_reading(arguments, *path); !confined)
        return findings.fail(Kind::usage, confined.error());
    if (const auto read = path->read(); !read) return findings.fail(read.error());
    if (arguments.report && arguments.request.cutting.material.empty())
        return findings.fail(Kind::usage, "--report needs --material and --thickness");
    const auto made = path->make([&](const engine::Diagnostic& told) { findings.take(told); });
    if (!made) return tell_failure(findings, made.error());
    const auto written = write_path(*path, apps::product_name(arguments.output));
    if (!written) return findings.fail(Kind::output, written.error());
    tell_summary(path->summary(), findings);
    if (arguments.report) std::fputs(path->job_report().c_str(), stderr);
    return apps::kDone;
}

int run_autopath(const AutopathArguments& arguments) {
    using Stream = apps::Findings::Stream;
    apps::Findings findings(kAutopath, arguments.findings);
    const int status = make_path(arguments, findings);
    const bool product_on_standard_output =
        status == apps::kDone && apps::product_name(arguments.output) == os::kStandardStream;
    return findings.finish(status,
                           product_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_autopath() {
    return std::make_unique<ProgramOf<AutopathArguments>>(
        kAutopath, "Makes the path of a cutting jet from a drawing (DXF, SVG) or a flat part (STEP, IGES)",
        add_autopath_options, run_autopath);
}
