// autopath: from a drawing or a solid to the path that a jet cuts it out by.

#include "cam/cutting/autopath.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "base/units.h"
#include "cam/drawing/drawing_file.h"
#include "cam/solid/mesh.h"
#include "cam/solid/plate.h"
#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/job_report.h"
#include "cam/waterjet/materials_file.h"
#include "engine/system/host_of_system.h"
#include "engine/system/installed_files.h"
#include "runtime/path/json_writer.h"

namespace {

using namespace gsim;

struct AutopathArguments {
    std::string input;
    std::string output;  ///< Empty: standard output.
    std::string materials;
    waterjet::CuttingRequest cut;
    drawing::ReadOptions read;
    cutting::AutopathOptions path;
    std::string units;
    solid::PlateOptions plate;
    bool report = false;
    double max_cpu_s = apps::kMaxCpu_s;
    bool no_confine = false;
    apps::FindingOptions findings;
};

using Kind = text::DiagnosticKind;

constexpr const char* kAutopath = "autopath";

void add_material_options(apps::CommandLine& line, AutopathArguments& arguments) {
    line.begin_group("Material");
    line.add("--material", &arguments.cut.material, "material, as the materials file names it");
    line.add("--thickness", &arguments.cut.thickness_mm, "of the material (that of the solid)").called("MM");
    line.add("--quality", &arguments.cut.quality, "of the edge, 1 (just through) to 5 (finest)");
    line.add("--materials", &arguments.materials, "materials file (TOML) instead of the built-in one")
        .of_file(apps::FileKind::input, {".toml"});
    line.add("--speed", &arguments.cut.speed_mm_min, "cutting speed, instead of the material's")
        .called("MM/MIN")
        .within(1e-3, 1e6);
    line.add("--kerf", &arguments.cut.kerf_mm, "width of the cut, instead of the material's")
        .called("MM")
        .within(1e-3, 100);
    line.add("--pierce", &arguments.cut.pierce_s, "time of a pierce, instead of the material's")
        .called("SECONDS")
        .within(0, 3600);
    line.add("--report", &arguments.report, "print how the values were found and what the job costs")
        .not_with("--json");
}

void add_path_options(apps::CommandLine& line, AutopathArguments& arguments) {
    cutting::ProgramOptions& program = arguments.path.program;
    line.begin_group("Path");
    line.add("--at", &program.origin_mm,
             "where the drawing's origin, on the material's upper side, lies in the work frame, in mm")
        .called("X Y Z")
        .within(-1e6, 1e6)
        .shows_default();
    line.add("--lead", &arguments.path.lead_mm, "radius of leads (three kerfs)")
        .called("MM")
        .within(0.05, 1000);
    line.add("--safe-height", &program.heights.safe_mm, "height of ways between cuts")
        .called("MM")
        .within(0, 10'000)
        .shows_default();
    line.add("--cut-height", &program.heights.cut_mm, "height of the nozzle's tip over the material")
        .called("MM")
        .within(0, 1000)
        .shows_default();
    line.add("--bevel", &program.bevel_deg,
             "lean of the jet, but for edges that have a bevel of their own; above 0 the part is smaller "
             "below")
        .called("DEG")
        .within(-60, 60)
        .shows_default();
}

void add_reading_options(apps::CommandLine& line, AutopathArguments& arguments) {
    line.begin_group("Drawing or solid");
    line.add("--unit", &arguments.units, "of the drawing (what the drawing says)").one_of({"mm", "inch"});
    line.add("--layer", &arguments.read.layers,
             "only what is on this layer; may be given more than once (DXF)");
    line.add("--tolerance", &arguments.path.gap_mm, "join ends that are nearer than this")
        .called("MM")
        .within(1e-6, 10)
        .shows_default();
    line.add("--curve-tolerance", &arguments.read.tolerance_mm,
             "how far arcs may be off splines and ellipses")
        .called("MM")
        .within(1e-5, 10)
        .shows_default();
    line.add("--up", &arguments.plate.along,
             "where the upper side looks (that of the largest face; STEP, IGES)")
        .one_of({"x", "y", "z", "-x", "-y", "-z"});
    line.add("--flip", &arguments.plate.flip, "turn the plate over (STEP, IGES)");
}

void add_autopath_options(apps::CommandLine& line, AutopathArguments& arguments) {
    using apps::FileKind;
    line.add("drawing", &arguments.input, "drawing: .dxf, .svg; flat part: .step, .stp, .iges, .igs")
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

tl::expected<solid::Plate, std::string> read_input(const AutopathArguments& arguments,
                                                   const std::string& file) {
    if (solid::is_solid_file(file)) {
        if (!arguments.units.empty() || !arguments.read.layers.empty())
            return tl::unexpected(
                std::string("--unit and --layer are for drawings; a STEP or IGES file says its unit"));
        solid::PlateOptions options = arguments.plate;
        options.tolerance_mm = arguments.read.tolerance_mm;
        return solid::read_plate(file, options);
    }
    if (arguments.plate.flip || !arguments.plate.along.empty())
        return tl::unexpected(std::string("--up and --flip are for STEP and IGES files"));
    drawing::ReadOptions read = arguments.read;
    if (!arguments.units.empty()) read.unit_mm = arguments.units == "inch" ? kMmPerInch : 1;
    auto drawing = drawing::read_drawing(file, read, os::NamedBy::command_line);
    if (!drawing) return tl::unexpected(drawing.error());
    return solid::Plate{*std::move(drawing), 0};
}

// The thickness is the solid's where none is given.
void take_thickness(solid::Plate& plate, waterjet::CuttingRequest& cut) {
    if (plate.thickness_mm <= 0) return;
    if (cut.thickness_mm == 0) {
        cut.thickness_mm = plate.thickness_mm;
        cut.thickness_basis = "the solid";
    }
    constexpr double kSame = 0.01;
    if (std::abs(cut.thickness_mm - plate.thickness_mm) <= kSame * plate.thickness_mm) return;
    plate.drawing.notes.push_back(fmt::format("the solid is {:.6g} mm thick; --thickness says {:.6g} mm",
                                              plate.thickness_mm, cut.thickness_mm));
}

tl::expected<waterjet::Materials, std::string> materials_of(const AutopathArguments& arguments) {
    if (!arguments.materials.empty()) {
        return engine::find_file(engine::NameKind::sample, arguments.materials)
            .and_then([](const std::string& file) {
                return waterjet::load_materials(file, os::NamedBy::command_line);
            });
    }
    return waterjet::read_materials(waterjet::built_in_materials_toml(), "materials.toml");
}

cutting::CutRules rules_of(const waterjet::CuttingPlan& plan) {
    return {plan.kerf_mm,
            plan.cutting_speed_mm_min,
            plan.pierce_s,
            [plan](double radius_mm) { return waterjet::feed_for_radius_mm_min(plan, radius_mm); },
            [plan](double turn_rad) { return waterjet::feed_for_corner_mm_min(plan, turn_rad); },
            waterjet::corner_zone_mm(plan)};
}

// How to cut without a material: by what was given.
tl::expected<cutting::CutRules, std::string> given_rules(const waterjet::CuttingRequest& cut) {
    if (!cut.speed_mm_min || !cut.kerf_mm) {
        return tl::unexpected(std::string("give --material and --thickness, or --speed and --kerf"));
    }
    cutting::CutRules rules;
    rules.kerf_mm = *cut.kerf_mm;
    rules.speed_mm_min = *cut.speed_mm_min;
    rules.pierce_s = cut.pierce_s.value_or(0);
    return rules;
}

tl::expected<void, std::string> write_path(const path::Program& program, const std::string& name) {
    auto file = os::OutputFile::open(name);
    if (!file) return tl::unexpected(file.error());
    path::write_json(program, [&](std::string_view text) { file->write(text); });
    return file->commit();
}

void tell_summary(const cutting::CutSummary& summary, apps::Findings& findings) {
    const std::string sentence =
        fmt::format("{} contours, {} pierces, {:.1f} mm cut in {:.1f} s, {:.1f} mm between the cuts",
                    summary.outlines, summary.pierces, summary.cut_mm, summary.cut_s, summary.travel_mm);
    if (findings.options().json) {
        findings.take({.severity = text::Severity::note, .kind = Kind::path, .text = sentence});
    } else {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
}

/// From here on nothing is needed but the drawing and the outputs. Solids are read by a program of their own,
/// which needs its libraries.
tl::expected<void, std::string> confine_reading(const AutopathArguments& arguments,
                                                const std::string& drawing) {
    if (arguments.no_confine || solid::is_solid_file(drawing)) return {};
    return apps::confine_to(std::array{drawing}, std::array{arguments.output, arguments.findings.sarif});
}

/// Makes the path as the arguments say, and tells what is wrong; the exit status.
int make_path(const AutopathArguments& arguments, apps::Findings& findings) {
    const apps::CpuBackstop cpu(arguments.max_cpu_s);
    if (const auto conflict = apps::sarif_conflict(findings.options(), apps::product_name(arguments.output)))
        return findings.fail(Kind::usage, *conflict);
    waterjet::Materials materials;
    waterjet::CuttingPlan plan;
    tl::expected<cutting::CutRules, std::string> rules;
    const bool has_material = !arguments.cut.material.empty();
    const auto drawing = engine::find_file(engine::NameKind::sample, arguments.input);
    if (!drawing) return findings.fail(Kind::input_file, drawing.error());
    if (has_material) {
        auto loaded = materials_of(arguments);
        if (!loaded) return findings.fail(Kind::input_file, loaded.error(), arguments.materials);
        materials = std::move(*loaded);
    }
    if (auto confined = confine_reading(arguments, *drawing); !confined)
        return findings.fail(Kind::usage, confined.error());
    auto plate = read_input(arguments, *drawing);
    if (!plate) return findings.fail(Kind::input_file, plate.error(), arguments.input);
    waterjet::CuttingRequest cut = arguments.cut;
    take_thickness(*plate, cut);
    if (has_material) {
        auto planned = waterjet::plan_cutting(materials, cut);
        if (!planned) return findings.fail(Kind::usage, planned.error());
        plan = std::move(*planned);
        rules = rules_of(plan);
    } else {
        rules = given_rules(cut);
    }
    if (!rules) return findings.fail(Kind::usage, rules.error());
    if (arguments.report && !has_material)
        return findings.fail(Kind::usage, "--report needs --material and --thickness");
    cutting::AutopathOptions options = arguments.path;
    options.program.name = std::filesystem::path(arguments.input).stem().string();
    const auto made = cutting::autopath(std::move(plate->drawing), *rules, options);
    if (!made) {
        findings.fail(Kind::path, fmt::format("{}: {}", arguments.input, made.error()), arguments.input);
        return apps::kProgramFault;
    }
    for (const std::string& note : made->notes) {
        findings.take(
            {.severity = text::Severity::note, .kind = Kind::path, .file = arguments.input, .text = note});
    }
    const auto written = write_path(made->program, apps::product_name(arguments.output));
    if (!written) return findings.fail(Kind::output, written.error());
    tell_summary(made->summary, findings);
    if (!arguments.report) return apps::kDone;
    const waterjet::JobPrice price = waterjet::price_job(
        plan, materials.prices, {made->summary.cut_mm, made->summary.pierces, made->summary.cut_s, 0});
    std::fputs(waterjet::job_report_text({plan, price, materials.prices.currency}).c_str(), stderr);
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
