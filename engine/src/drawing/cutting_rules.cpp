#include "engine/src/drawing/cutting_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cam/waterjet/materials_file.h"
#include "engine/src/host_names.h"

namespace gsim::engine {

namespace {

waterjet::CuttingRequest make_cutting_request(const CuttingOptions& options, double plate_thickness_mm) {
    waterjet::CuttingRequest request;
    request.material = options.material;
    request.thickness_mm = options.thickness_mm;
    if (plate_thickness_mm > 0 && options.thickness_mm == 0) {
        request.thickness_mm = plate_thickness_mm;
        request.thickness_basis = "the solid";
    }
    request.quality = options.quality;
    request.speed_mm_min = options.speed_mm_min;
    request.kerf_mm = options.kerf_mm;
    request.pierce_s = options.pierce_s;
    request.dynamic_pierce = options.dynamic_pierce;
    return request;
}

cutting::CutRules make_cut_rules(const waterjet::CuttingPlan& plan, const CuttingOptions& options) {
    cutting::CutRules rules{
        .kerf_mm = plan.kerf_mm,
        .speed_mm_min = plan.cutting_speed_mm_min,
        .pierce_s = plan.pierce_s,
        .dynamic_pierce_s = plan.dynamic_pierce_s,
        .feed_on_arc_mm_min =
            [plan](double radius_mm) { return waterjet::feed_for_radius_mm_min(plan, radius_mm); },
        .feed_in_corner_mm_min =
            [plan](double turn_rad) { return waterjet::feed_for_corner_mm_min(plan, turn_rad); },
        .corner_zone_mm = waterjet::corner_zone_mm(plan)};
    // A depth below the given thickness does not allow a higher feed, because there may be more material
    // behind the wall.
    const double max_speed_mm_min =
        options.thickness_mm > 0 ? plan.cutting_speed_mm_min : std::numeric_limits<double>::infinity();
    rules.speed_at_depth_mm_min = [plan, max_speed_mm_min](double depth_mm) {
        return std::min(max_speed_mm_min, waterjet::speed_at_thickness_mm_min(plan, depth_mm));
    };
    if (options.taper_compensation) {
        rules.taper_compensation_deg = [plan](double feed_mm_min) {
            return waterjet::taper_compensation_deg(plan, feed_mm_min);
        };
    }
    return rules;
}

Result<ResolvedCutting> resolve_by_parameters(const CuttingOptions& options) {
    if (!options.speed_mm_min || !options.kerf_mm)
        return Unexpected("give --material and --thickness, or --speed and --kerf");
    if (options.taper_compensation)
        return Unexpected(
            "--taper-compensation requires --material and --thickness, which determine the taper");
    if (options.dynamic_pierce && !options.pierce_s)
        return Unexpected("--dynamic-pierce requires --material, or its time (--pierce)");
    ResolvedCutting resolved;
    resolved.rules.kerf_mm = *options.kerf_mm;
    resolved.rules.speed_mm_min = *options.speed_mm_min;
    resolved.rules.pierce_s = options.pierce_s.value_or(0);
    if (options.dynamic_pierce) resolved.rules.dynamic_pierce_s = resolved.rules.pierce_s;
    return resolved;
}

}  // namespace

Result<waterjet::Materials> read_materials_input(const Host& host, const std::string& name) {
    if (name.empty()) return waterjet::read_materials(waterjet::built_in_materials_toml(), "materials.toml");
    const auto file = resolve_name(host, NameKind::sample, name);
    if (!file) return tl::unexpected(file.error());
    return waterjet::load_materials(*file, os::NameSource::command_line, host.files.impl());
}

Result<ResolvedCutting> resolve_cutting_options(const CuttingOptions& options,
                                                const std::optional<waterjet::Materials>& materials,
                                                double plate_thickness_mm) {
    if (!materials) return resolve_by_parameters(options);
    return waterjet::plan_cutting(*materials, make_cutting_request(options, plate_thickness_mm))
        .map([&](waterjet::CuttingPlan plan) {
            ResolvedCutting resolved{.rules = make_cut_rules(plan, options)};
            resolved.plan = std::move(plan);
            return resolved;
        });
}

std::optional<std::string> thickness_mismatch(const CuttingOptions& options, double plate_thickness_mm) {
    constexpr double kEqualTolerance = 0.01;
    if (plate_thickness_mm <= 0 || options.thickness_mm == 0) return std::nullopt;
    if (std::abs(options.thickness_mm - plate_thickness_mm) <= kEqualTolerance * plate_thickness_mm)
        return std::nullopt;
    return fmt::format("the solid is {:.6g} mm thick, but --thickness is {:.6g} mm", plate_thickness_mm,
                       options.thickness_mm);
}

}  // namespace gsim::engine
