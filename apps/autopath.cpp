// autopath: makes the path of a jet that cuts out a drawing or a solid.

#include <array>
#include <cstdint>
#include <string>

#include "apps/confine_run.h"
#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "base/units.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "engine/drawing_path.h"
#include "engine/system/parts_host.h"

namespace {

using namespace gsim;

constexpr double kUnbounded_mm = 1e6;
constexpr std::array<double, 3> kUnset_mm{kUnbounded_mm, kUnbounded_mm, kUnbounded_mm};

struct AutopathArguments {
    engine::DrawingRequest request;
    std::string output;  ///< Empty: standard output.
    std::string units;
    std::string contours;  ///< Empty: a drawing or a flat part.
    std::string axis = "wall";
    engine::SurfaceCuttingOptions surface;
    std::uint64_t bridges = 0;
    engine::CuttingCellOptions work_cell;
    std::array<double, 3> start_mm = kUnset_mm;
    std::array<double, 3> box_low_mm{-kUnbounded_mm, -kUnbounded_mm, -kUnbounded_mm};
    std::array<double, 3> box_high_mm = kUnset_mm;
    bool report = false;
    double max_cpu_s = apps::kMaxCpu_s;
    bool no_confine = false;
    apps::FindingOptions findings;
};

using Kind = text::DiagnosticKind;

constexpr const char* kAutopath = "autopath";

void add_material_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::CuttingOptions& cutting = arguments.request.cutting;
    line.begin_group("Material");
    line.add("--material", &cutting.material, "name of the material in the materials file");
    line.add("--thickness", &cutting.thickness_mm, "thickness of the material (default: that of the solid)")
        .with_value_name("MM");
    line.add("--quality", &cutting.quality, "edge quality, 1 (separation cut) to 5 (finest)");
    line.add("--materials", &cutting.materials, "materials file (TOML) instead of the built-in one")
        .takes_file(apps::FileKind::input, {".toml"});
    line.add("--speed", &cutting.speed_mm_min, "cutting speed, instead of the material's")
        .with_value_name("MM/MIN")
        .within(1e-3, 1e6);
    line.add("--kerf", &cutting.kerf_mm, "kerf width, instead of the material's")
        .with_value_name("MM")
        .within(1e-3, 100);
    line.add("--pierce", &cutting.pierce_s, "pierce time, instead of the material's")
        .with_value_name("SECONDS")
        .within(0, 3600);
    line.add("--dynamic-pierce", &cutting.dynamic_pierce,
             "dynamic pierce: move the nozzle back and forth on the lead-in while piercing, which takes less "
             "time")
        .formerly("--moving-pierce");
    line.add("--taper-compensation", &cutting.taper_compensation,
             "taper compensation: tilt the jet against the taper of the cut, so the walls are straight")
        .formerly("--straighten");
    line.add("--report", &arguments.report, "print how the values were calculated and the cost of the job")
        .exclude_option("--json");
}

void add_path_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::CuttingPathOptions& path = arguments.request.cutting_path;
    line.begin_group("Path");
    line.add("--at", &path.origin_mm,
             "position of the drawing's origin (on the upper side of the material) in the work frame, in mm")
        .with_value_name("X Y Z")
        .within(-1e6, 1e6)
        .show_default();
    line.add("--lead", &path.lead_mm, "radius of lead-ins and lead-outs (default: three kerf widths)")
        .with_value_name("MM")
        .within(0.05, 1000);
    line.add("--safe-height", &path.safe_height_mm, "height of linking moves between cuts")
        .with_value_name("MM")
        .within(0, 10'000)
        .show_default();
    line.add("--cut-height", &path.cut_height_mm, "height of the nozzle above the material")
        .with_value_name("MM")
        .within(0, 1000)
        .show_default();
    line.add("--bevel", &path.bevel_deg,
             "tilt angle of the jet, except for edges that define a bevel; if positive, the part is smaller "
             "at the bottom")
        .with_value_name("DEG")
        .within(-60, 60)
        .show_default();
}

void add_reading_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::DrawingOptions& reading = arguments.request.reading;
    line.begin_group("Drawing or solid");
    line.add("--unit", &arguments.units, "unit of the drawing (default: as given in the drawing)")
        .one_of({"mm", "inch"});
    line.add("--layer", &reading.layers, "only entities on this layer; may be given more than once (DXF)");
    line.add("--tolerance", &reading.gap_mm, "join ends that are closer than this")
        .with_value_name("MM")
        .within(1e-6, 10)
        .show_default();
    line.add("--curve-tolerance", &reading.curve_tolerance_mm,
             "max deviation of arcs from splines and ellipses")
        .with_value_name("MM")
        .within(1e-5, 10)
        .show_default();
    line.add("--up", &reading.up,
             "direction of the upper side (default: that of the largest face; STEP, IGES)")
        .one_of({"x", "y", "z", "-x", "-y", "-z"});
    line.add("--flip", &reading.flip, "turn the plate over (STEP, IGES)");
}

void add_surface_options(apps::CommandLine& line, AutopathArguments& arguments) {
    engine::ContourSelection& contours = arguments.surface.contours;
    line.begin_group("Parts that are not flat (STEP, IGES)");
    line.add("--contours", &arguments.contours,
             "cut these closed edge loops of faces, or the edges of --edge; required by the other options of "
             "this group")
        .one_of({"holes", "outlines", "all", "edges"});
    line.add("--side", &contours.side, "only contours of faces that face in this direction")
        .one_of({"x", "y", "z", "-x", "-y", "-z"})
        .show_default();
    line.add("--face", &contours.faces,
             "only contours of this face: its number in the file (#57), name, layer or colour (red; "
             "255,128,0); may be given more than once");
    line.add(
        "--edge", &contours.edges,
        "only contours that have this edge, by its number in the file (#95); may be given more than once");
    line.add("--choose", &arguments.surface.choose,
             "only contours for which the function that this script returns is true")
        .takes_file(apps::FileKind::input, {".lua"});
    line.add("--bridges", &arguments.bridges, "number of bridges (parts left uncut) in each contour")
        .within(0, 1000)
        .show_default();
    line.add("--bridge-width", &arguments.surface.bridge_mm, "width of each bridge")
        .with_value_name("MM")
        .within(0, 100)
        .show_default();
    line.add("--start", &arguments.start_mm,
             "position where the program begins and ends, in the work frame, in mm")
        .with_value_name("X Y Z")
        .within(-kUnbounded_mm, kUnbounded_mm);
    line.add("--box-low", &arguments.box_low_mm,
             "only contours in a box of the file's coordinates: its low corner, in mm")
        .with_value_name("X Y Z")
        .within(-kUnbounded_mm, kUnbounded_mm);
    line.add("--box-high", &arguments.box_high_mm, "high corner of this box, in mm")
        .with_value_name("X Y Z")
        .within(-kUnbounded_mm, kUnbounded_mm);
    line.add("--axis", &arguments.axis, "direction of the jet: along the walls, or along the face normal")
        .one_of({"wall", "normal"})
        .show_default();
    line.add("--tilt-angle", &arguments.surface.tilt_deg,
             "tilt angle to the side, from the normal; if positive, the part is smaller at the bottom")
        .with_value_name("DEG")
        .within(-80, 80)
        .show_default()
        .formerly("--lean");
    line.add("--lead-angle", &arguments.surface.lead_angle_deg, "lead angle, positive with the nozzle ahead")
        .with_value_name("DEG")
        .within(-60, 60)
        .show_default()
        .formerly("--tilt");
    line.add("--max-tilt", &arguments.surface.max_tilt_deg,
             "reject edges where the jet is tilted more than this from the normal")
        .with_value_name("DEG")
        .within(0, 85)
        .show_default()
        .formerly("--max-lean");
}

void add_cell_options(apps::CommandLine& line, AutopathArguments& arguments) {
    using apps::FileKind;
    engine::CuttingCellOptions& work_cell = arguments.work_cell;
    line.begin_group("Machine and cell");
    line.add("--cell", &work_cell.cell,
             "cell file (TOML): linking moves between cuts avoid its bodies, and cuts that collide with them "
             "are rejected; it may name machine and machine data")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine", &work_cell.machine,
             "cutting machine, with its bodies if no cell is given (default: that of the cell)")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &work_cell.machine_data,
             "machine data with the position of G54 (default: the machine zero)")
        .takes_file(FileKind::input, {".txt"});
}

void add_autopath_options(apps::CommandLine& line, AutopathArguments& arguments) {
    using apps::FileKind;
    line.add("drawing", &arguments.request.drawing,
             "drawing: .dxf, .svg; flat part: .step, .stp, .iges, .igs")
        .takes_file(FileKind::input, {".dxf", ".svg", ".step", ".stp", ".iges", ".igs"})
        .make_required();
    line.begin_group("Output");
    line.add("-o,--output", &arguments.output, "write the path to this file; it is created only on success")
        .takes_file(FileKind::output, {".json"});
    add_material_options(line, arguments);
    add_path_options(line, arguments);
    add_reading_options(line, arguments);
    add_surface_options(line, arguments);
    add_cell_options(line, arguments);
    line.begin_group("Limits");
    apps::add_cpu_option(line, arguments.max_cpu_s);
    apps::add_confine_option(line, arguments.no_confine);
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, arguments.findings);
    line.add_example("autopath plate.svg --material aluminum --thickness 12 -o plate.path.json",
                     "cutting speed, kerf and piercing from the material");
    line.add_example("autopath plate.dxf --speed 400 --kerf 1 | path2gcode -",
                     "with given values, to a part program");
}

engine::SurfaceCuttingOptions surface_options(const AutopathArguments& arguments) {
    engine::SurfaceCuttingOptions jet_options = arguments.surface;
    jet_options.contours.kind = arguments.contours;
    jet_options.contours.along_walls = arguments.axis == "wall";
    jet_options.bridges = static_cast<int>(arguments.bridges);
    if (arguments.start_mm != kUnset_mm) jet_options.start_mm = arguments.start_mm;
    const auto& low = arguments.box_low_mm;
    const auto& high = arguments.box_high_mm;
    jet_options.contours.box_mm = {low[0], low[1], low[2], high[0], high[1], high[2]};
    return jet_options;
}

/// Returns an option that applies to contours although none are requested; empty: no such option.
std::string option_without_contours(const AutopathArguments& arguments) {
    const AutopathArguments none;
    const engine::SurfaceCuttingOptions& given = arguments.surface;
    if (!arguments.contours.empty()) return {};
    if (given.contours.side != none.surface.contours.side) return "--side";
    if (!given.contours.faces.empty()) return "--face";
    if (!given.contours.edges.empty()) return "--edge";
    if (!given.choose.empty()) return "--choose";
    if (arguments.bridges != none.bridges) return "--bridges";
    if (given.bridge_mm != none.surface.bridge_mm) return "--bridge-width";
    if (arguments.start_mm != none.start_mm) return "--start";
    if (arguments.box_low_mm != none.box_low_mm) return "--box-low";
    if (arguments.box_high_mm != none.box_high_mm) return "--box-high";
    if (arguments.axis != none.axis) return "--axis";
    if (given.tilt_deg != none.surface.tilt_deg) return "--tilt-angle";
    if (given.lead_angle_deg != none.surface.lead_angle_deg) return "--lead-angle";
    return given.max_tilt_deg != none.surface.max_tilt_deg ? "--max-tilt" : "";
}

engine::DrawingRequest make_request(const AutopathArguments& arguments) {
    engine::DrawingRequest request = arguments.request;
    request.host = engine::make_parts_host();
    if (!arguments.units.empty()) request.reading.unit_mm = arguments.units == "inch" ? kMmPerInch : 1;
    if (!arguments.contours.empty()) request.surface = surface_options(arguments);
    const engine::CuttingCellOptions& work_cell = arguments.work_cell;
    if (!work_cell.cell.empty() || !work_cell.machine.empty() || !work_cell.machine_data.empty())
        request.work_cell = work_cell;
    return request;
}

Result<void> write_path(const engine::DrawingPath& path, const std::string& name) {
    auto file = os::OutputFile::open(name);
    if (!file) return tl::unexpected(file.error());
    path.write([&](std::string_view text) { return file->write(text); });
    return file->commit();
}

void report_summary(const std::string& message, apps::Findings& findings) {
    if (findings.options().json) {
        findings.add({.severity = text::Severity::note, .kind = Kind::path, .text = message});
    } else {
        apps::print_to_standard_error(text::printable(message + '\n'));
    }
}

/// From here on only the drawing and the outputs are needed. A separate program reads solids, and it needs
/// its libraries.
Result<void> confine_reading(const AutopathArguments& arguments, const engine::DrawingPath& path) {
    if (arguments.no_confine || path.is_solid()) return {};
    return apps::confine_to(std::array{path.drawing_file()},
                            std::array{arguments.output, arguments.findings.sarif});
}

/// An error of the drawing or of a script is no error of the user of this program.
int report_failure(apps::Findings& findings, const engine::Error& error) {
    const int status = findings.fail(error);
    return error.in_program ? apps::kProgramError : status;
}

/// Makes the path as the arguments specify, and reports errors; returns the exit status.
int make_path(const AutopathArguments& arguments, apps::Findings& findings) {
    const apps::CpuLimitGuard cpu(arguments.max_cpu_s);
    if (const auto conflict =
            apps::sarif_conflict(findings.options(), apps::output_destination(arguments.output)))
        return findings.fail(Kind::usage, conflict->message);
    if (const std::string orphan_option = option_without_contours(arguments); !orphan_option.empty())
        return findings.fail(Kind::usage, orphan_option + " requires --contours");
    auto path = engine::DrawingPath::open(make_request(arguments));
    if (!path) return findings.fail(path.error());
    if (auto confined = confine_reading(arguments, *path); !confined)
        return findings.fail(Kind::usage, confined.error().message);
    if (const auto read = path->read(); !read) return report_failure(findings, read.error());
    if (arguments.report && arguments.request.cutting.material.empty())
        return findings.fail(Kind::usage, "--report needs --material and --thickness");
    const auto result = path->make([&](const engine::Diagnostic& diagnostic) { findings.add(diagnostic); });
    if (!result) return report_failure(findings, result.error());
    const auto written = write_path(*path, apps::output_destination(arguments.output));
    if (!written) return findings.fail(Kind::output, written.error().message);
    report_summary(path->summary(), findings);
    if (arguments.report) apps::print_to_standard_error(text::printable(path->job_report()));
    return apps::kSuccess;
}

int run_autopath(const AutopathArguments& arguments) {
    using Stream = apps::Findings::Stream;
    apps::Findings findings(kAutopath, arguments.findings);
    const int status = make_path(arguments, findings);
    const bool is_output_on_standard_output =
        status == apps::kSuccess && apps::output_destination(arguments.output) == os::kStandardStream;
    return findings.finish(status,
                           is_output_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_autopath() {
    return std::make_unique<ProgramWithArguments<AutopathArguments>>(
        kAutopath, "Makes the path of a cutting jet from a drawing (DXF, SVG) or a flat part (STEP, IGES)",
        add_autopath_options, run_autopath);
}
