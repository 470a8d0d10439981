// autopath: from a drawing or a solid to the path that a jet cuts it out by.

#include "cutting/autopath.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/exit_status.h"
#include "apps/run_main.h"
#include "drawing/drawing_file.h"
#include "runtime/path/json_writer.h"
#include "runtime/simulation/output_file.h"
#include "runtime/waterjet/cutting_plan.h"
#include "runtime/waterjet/job_report.h"
#include "runtime/waterjet/materials_file.h"
#include "solid/mesh.h"
#include "solid/plate.h"

namespace {

using namespace gsim;

struct Arguments {
    std::string input;
    std::string output;
    std::string materials;
    waterjet::CuttingRequest cut;
    drawing::ReadOptions read;
    cutting::AutopathOptions path;
    std::string units;
    solid::PlateOptions plate;
    bool report = false;
};

constexpr const char* kProgram = "autopath";

int usage_error(const std::string& message) {
    return apps::usage_error(kProgram, message);
}

void add_material_options(CLI::App& app, Arguments& arguments) {
    app.add_option("--material", arguments.cut.material, "material, as the materials file names it");
    app.add_option("--thickness", arguments.cut.thickness_mm, "of the material, in mm (that of the solid)");
    app.add_option("--quality", arguments.cut.quality, "of the edge, 1 (just through) to 5 (finest)");
    app.add_option("--materials", arguments.materials, "materials file (TOML) instead of the built-in one");
    app.add_option("--speed", arguments.cut.speed_mm_min,
                   "cutting speed in mm/min, instead of the material's")
        ->check(CLI::Range(1e-3, 1e6));
    app.add_option("--kerf", arguments.cut.kerf_mm, "width of the cut in mm, instead of the material's")
        ->check(CLI::Range(1e-3, 100.0));
    app.add_option("--pierce", arguments.cut.pierce_s, "time of a pierce in s, instead of the material's")
        ->check(CLI::Range(0.0, 3600.0));
    app.add_flag("--report", arguments.report, "print how the values were found and what the job costs");
}

void add_path_options(CLI::App& app, Arguments& arguments) {
    cutting::ProgramOptions& program = arguments.path.program;
    app.add_option("--tolerance", arguments.path.gap_mm, "join ends that are nearer than this, in mm")
        ->check(CLI::Range(1e-6, 10.0))
        ->capture_default_str();
    app.add_option("--curve-tolerance", arguments.read.tolerance_mm,
                   "how far arcs may be off splines and ellipses, in mm")
        ->check(CLI::Range(1e-5, 10.0))
        ->capture_default_str();
    app.add_option("--lead", arguments.path.lead_mm, "radius of leads in mm (three kerfs)")
        ->check(CLI::Range(0.05, 1000.0));
    app.add_option(
           "--at", program.origin_mm,
           "X Y Z: where the drawing's origin, on the material's upper side, lies in the work frame, in mm")
        ->check(CLI::Range(-1e6, 1e6))
        ->default_str("0 0 0");
    app.add_option("--safe-height", program.heights.safe_mm, "height of ways between cuts, in mm")
        ->check(CLI::Range(0.0, 10'000.0))
        ->capture_default_str();
    app.add_option("--cut-height", program.heights.cut_mm,
                   "height of the nozzle's tip over the material, in mm")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    app.add_option(
           "--bevel", program.bevel_deg,
           "lean of the jet in deg, but for edges that have a bevel of their own; above 0 the part is "
           "smaller below")
        ->check(CLI::Range(-60.0, 60.0))
        ->capture_default_str();
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("drawing", arguments.input, "drawing: .dxf, .svg; flat part: .step, .stp, .iges, .igs")
        ->required();
    app.add_option("-o,--output", arguments.output,
                   "write the path to this file; it appears only if all went well");
    add_material_options(app, arguments);
    add_path_options(app, arguments);
    app.add_option("--unit", arguments.units, "of the drawing: mm or inch (what the drawing says)")
        ->check(CLI::IsMember({"mm", "inch"}));
    app.add_option("--layer", arguments.read.layers,
                   "only what is on this layer; may be given more than once (DXF)");
    app.add_option("--up", arguments.plate.along,
                   "x, y, z, -x, -y, -z: where the upper side looks (that of the largest face; STEP, IGES)")
        ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
    app.add_flag("--flip", arguments.plate.flip, "turn the plate over (STEP, IGES)");
    app.set_version_flag("--version", "autopath " GSIM_VERSION);
}

tl::expected<solid::Plate, std::string> read_input(const Arguments& arguments) {
    if (solid::is_solid_file(arguments.input)) {
        if (!arguments.units.empty() || !arguments.read.layers.empty())
            return tl::unexpected(
                std::string("--unit and --layer are for drawings; a STEP or IGES file says its unit"));
        solid::PlateOptions options = arguments.plate;
        options.tolerance_mm = arguments.read.tolerance_mm;
        return solid::read_plate(arguments.input, options);
    }
    if (arguments.plate.flip || !arguments.plate.along.empty())
        return tl::unexpected(std::string("--up and --flip are for STEP and IGES files"));
    drawing::ReadOptions read = arguments.read;
    if (!arguments.units.empty()) read.unit_mm = arguments.units == "inch" ? 25.4 : 1;
    auto drawing = drawing::read_drawing(arguments.input, read);
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

tl::expected<waterjet::Materials, std::string> materials_of(const Arguments& arguments) {
    if (!arguments.materials.empty()) return waterjet::load_materials(arguments.materials);
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
    if (name.empty()) {
        path::write_json(program,
                         [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); });
        if (std::fflush(stdout) != 0) return tl::unexpected(std::string("standard output cannot be written"));
        return {};
    }
    auto file = simulation::OutputFile::open(name);
    if (!file) return tl::unexpected(file.error());
    path::write_json(
        program, [&](std::string_view text) { std::fwrite(text.data(), 1, text.size(), file->stream()); });
    return file->commit();
}

void print_summary(const cutting::CutSummary& summary) {
    std::fputs(
        fmt::format("{} contours, {} pierces, {:.1f} mm cut in {:.1f} s, {:.1f} mm between the cuts\n",
                    summary.outlines, summary.pierces, summary.cut_mm, summary.cut_s, summary.travel_mm)
            .c_str(),
        stderr);
}

int run(const Arguments& arguments) {
    waterjet::Materials materials;
    waterjet::CuttingPlan plan;
    tl::expected<cutting::CutRules, std::string> rules;
    const bool has_material = !arguments.cut.material.empty();
    auto plate = read_input(arguments);
    if (!plate) return usage_error(plate.error());
    waterjet::CuttingRequest cut = arguments.cut;
    take_thickness(*plate, cut);
    if (has_material) {
        auto loaded = materials_of(arguments);
        if (!loaded) return usage_error(loaded.error());
        materials = std::move(*loaded);
        auto planned = waterjet::plan_cutting(materials, cut);
        if (!planned) return usage_error(planned.error());
        plan = std::move(*planned);
        rules = rules_of(plan);
    } else {
        rules = given_rules(cut);
    }
    if (!rules) return usage_error(rules.error());
    if (arguments.report && !has_material) return usage_error("--report needs --material and --thickness");
    cutting::AutopathOptions options = arguments.path;
    options.program.name = std::filesystem::path(arguments.input).stem().string();
    const auto made = cutting::autopath(std::move(plate->drawing), *rules, options);
    if (!made) {
        usage_error(fmt::format("{}: {}", arguments.input, made.error()));
        return apps::kProgramFault;
    }
    for (const std::string& note : made->notes)
        std::fprintf(stderr, "%s: note: %s\n", kProgram, note.c_str());
    const auto written = write_path(made->program, arguments.output);
    if (!written) return usage_error(written.error());
    print_summary(made->summary);
    if (!arguments.report) return apps::kDone;
    const waterjet::JobPrice price = waterjet::price_job(
        plan, materials.prices, {made->summary.cut_mm, made->summary.pierces, made->summary.cut_s, 0});
    std::fputs(waterjet::job_report_text({plan, price, materials.prices.currency}).c_str(), stderr);
    return apps::kDone;
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<Arguments>(
        argc, argv, kProgram,
        "Makes the path of a cutting jet from a drawing (DXF, SVG) or a flat part (STEP, IGES).", add_options,
        run);
}
