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

waterjet::CuttingRequest cutting_request(const CuttingChoice& choice, double plate_mm) {
    waterjet::CuttingRequest request;
    request.material = choice.material;
    request.thickness_mm = choice.thickness_mm;
    if (plate_mm > 0 && choice.thickness_mm == 0) {
        request.thickness_mm = plate_mm;
        request.thickness_basis = "the solid";
    }
    request.quality = choice.quality;
    request.speed_mm_min = choice.speed_mm_min;
    request.kerf_mm = choice.kerf_mm;
    request.pierce_s = choice.pierce_s;
    request.moving_pierce = choice.moving_pierce;
    return request;
}

cutting::CutRules rules_of(const waterjet::CuttingPlan& plan, const CuttingChoice& choice) {
    cutting::CutRules rules{
        .kerf_mm = plan.kerf_mm,
        .speed_mm_min = plan.cutting_speed_mm_min,
        .pierce_s = plan.pierce_s,
        .moving_pierce_s = plan.moving_pierce_s,
        .feed_on_arc_mm_min =
            [plan](double radius_mm) { return waterjet::feed_for_radius_mm_min(plan, radius_mm); },
        .feed_in_corner_mm_min =
            [plan](double turn_rad) { return waterjet::feed_for_corner_mm_min(plan, turn_rad); },
        .corner_zone_mm = waterjet::corner_zone_mm(plan)};
    // A depth below the given thickness does not allow a higher feed, because more material may follow after
    // the wall.
    const double most_mm_min =
        choice.thickness_mm > 0 ? plan.cutting_speed_mm_min : std::numeric_limits<double>::infinity();
    rules.speed_at_depth_mm_min = [plan, most_mm_min](double depth_mm) {
        return std::min(most_mm_min, waterjet::speed_at_thickness_mm_min(plan, depth_mm));
    };
    if (choice.straighten) {
        rules.straightening_lean_deg = [plan](double feed_mm_min) {
            return waterjet::straightening_lean_deg(plan, feed_mm_min);
        };
    }
    return rules;
}

tl::expected<SettledCutting, std::string> settle_by_figures(const CuttingChoice& choice) {
    if (!choice.speed_mm_min || !choice.kerf_mm)
        return tl::unexpected(std::string("give --material and --thickness, or --speed and --kerf"));
    if (choice.straighten)
        return tl::unexpected(
            std::string("--straighten needs --material and --thickness: the taper is theirs"));
    if (choice.moving_pierce && !choice.pierce_s)
        return tl::unexpected(
            std::string("--moving-pierce needs --material, or how long it takes (--pierce)"));
    SettledCutting settled;
    settled.rules.kerf_mm = *choice.kerf_mm;
    settled.rules.speed_mm_min = *choice.speed_mm_min;
    settled.rules.pierce_s = choice.pierce_s.value_or(0);
    if (choice.moving_pierce) settled.rules.moving_pierce_s = settled.rules.pierce_s;
    return settled;
}

}  // namespace

tl::expected<waterjet::Materials, std::string> read_materials_input(const Host& host,
                                                                    const std::string& name) {
    if (name.empty()) return waterjet::read_materials(waterjet::built_in_materials_toml(), "materials.toml");
    const auto file = find_name(host, NameKind::sample, name);
    if (!file) return tl::unexpected(file.error());
    return waterjet::load_materials(*file, os::NamedBy::command_line, host.files.inner());
}

tl::expected<SettledCutting, std::string> settle_cutting(const CuttingChoice& choice,
                                                         const std::optional<waterjet::Materials>& materials,
                                                         double plate_mm) {
    if (!materials) return settle_by_figures(choice);
    return waterjet::plan_cutting(*materials, cutting_request(choice, plate_mm))
        .map([&](waterjet::CuttingPlan plan) {
            SettledCutting settled{.rules = rules_of(plan, choice)};
            settled.plan = std::move(plan);
            return settled;
        });
}

std::optional<std::string> other_thickness(const CuttingChoice& choice, double plate_mm) {
    constexpr double kSame = 0.01;
    if (plate_mm <= 0 || choice.thickness_mm == 0) return std::nullopt;
    if (std::abs(choice.thickness_mm - plate_mm) <= kSame * plate_mm) return std::nullopt;
    return fmt::format("the solid is {:.6g} mm thick; --thickness says {:.6g} mm", plate_mm,
                       choice.thickness_mm);
}

}  // namespace gsim::engine
