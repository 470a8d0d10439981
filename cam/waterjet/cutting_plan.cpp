#include "cam/waterjet/cutting_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/waterjet/value_range.h"
#include "cam/waterjet/water_flow.h"

namespace gsim::waterjet {

namespace {

// Usual ranges (thesis, 2.5 and 2.5.1); outside of them the equation has not been tested.
constexpr ValueRange kTypicalPressure{"pressure_mpa", 170, 415};
constexpr ValueRange kTypicalOrifice{"orifice_mm", 0.076, 0.89};

std::optional<Error> find_error(const std::optional<double>& value, const ValueRange& range) {
    return value ? range.find_error(*value) : std::nullopt;
}

std::optional<Error> find_error(const CuttingRequest& request) {
    const std::pair<std::optional<double>, ValueRange> all[] = {
        {request.thickness_mm, range::kThickness},    {request.quality, range::kQuality},
        {request.pressure_mpa, range::kPressure},     {request.orifice_mm, range::kOrifice},
        {request.mixing_tube_mm, range::kMixingTube}, {request.abrasive_g_min, range::kAbrasive},
        {request.speed_mm_min, range::kSpeed},        {request.kerf_mm, range::kKerf},
        {request.pierce_s, range::kPierce},
    };
    for (const auto& [value, range] : all) {
        if (auto error = find_error(value, range)) return error;
    }
    return std::nullopt;
}

double resolve_machinability(ValueResolver& resolver, const Materials& file, const Material& material) {
    constexpr std::string_view kName = "machinability";
    const double machinability = material_machinability(file, material);
    if (material.machinability) return resolver.from_file(kName, {}, machinability, material.source);
    if (const auto& cut = material.measured) {
        return resolver.inferred(
            kName, {},
            {machinability, fmt::format("a measured cut of {} mm at {} mm/min, quality {}", cut->thickness_mm,
                                        cut->speed_mm_min, cut->quality)});
    }
    const std::string reason =
        material.source.empty() ? std::string() : fmt::format(" ({})", material.source);
    return resolver.inferred(kName, {}, {machinability, fmt::format("{}{}", material.like, reason)});
}

JetSetting resolve_jet(ValueResolver& resolver, const JetRule& rule, const CuttingRequest& request,
                       CuttingPlan& plan) {
    const auto none = [] { return InferredValue{}; };  // the file always has these
    JetSetting jet;
    jet.abrasive_factor = rule.abrasive_factor;
    jet.pressure_mpa = resolver.resolve("pressure", "MPa", request.pressure_mpa, rule.pressure_mpa, none);
    jet.orifice_mm = resolver.resolve("orifice", "mm", request.orifice_mm, rule.orifice_mm, none);
    jet.mixing_tube_mm =
        resolver.resolve("mixing tube", "mm", request.mixing_tube_mm, rule.mixing_tube_mm, [&] {
            return InferredValue{rule.tube_to_orifice * jet.orifice_mm,
                                 fmt::format("{} times the orifice", rule.tube_to_orifice)};
        });
    plan.water_l_min =
        resolver.inferred("water", "l/min",
                          {water_flow_l_min(jet.orifice_mm, jet.pressure_mpa, rule.discharge),
                           fmt::format("pressure and orifice, coefficient of discharge {}", rule.discharge)});
    jet.abrasive_g_min =
        resolver.resolve("abrasive", "g/min", request.abrasive_g_min, rule.abrasive_g_min, [&] {
            return InferredValue{1000 * rule.abrasive_to_water * plan.water_l_min,
                                 fmt::format("{} times the mass of the water", rule.abrasive_to_water)};
        });
    return jet;
}

void resolve_speeds(ValueResolver& resolver, const CuttingRequest& request, CuttingPlan& plan) {
    plan.separation_speed_mm_min = resolver.inferred(
        "separation speed", "mm/min",
        {cutting_speed_mm_min(plan.jet, plan.machinability, plan.thickness_mm, kSeparationQuality),
         "the cutting equation at quality 1"});
    plan.cutting_speed_mm_min =
        resolver.resolve("cutting speed", "mm/min", request.speed_mm_min, std::nullopt, [&] {
            return InferredValue{
                cutting_speed_mm_min(plan.jet, plan.machinability, plan.thickness_mm, plan.quality),
                fmt::format("the cutting equation at quality {}", plan.quality)};
        });
}

/// A given time is that of the requested kind of pierce.
void resolve_pierce(ValueResolver& resolver, const PierceRule& rule, const CuttingRequest& request,
                    CuttingPlan& plan) {
    plan.pierce_s = resolver.resolve("pierce", "s", request.pierce_s, std::nullopt, [&] {
        return InferredValue{
            pierce_s(rule, plan.thickness_mm, plan.separation_speed_mm_min),
            fmt::format("thickness and separation speed, factor {}, at least {} s", rule.factor, rule.min_s)};
    });
    if (!request.dynamic_pierce) return;
    plan.dynamic_pierce_s = resolver.resolve("dynamic pierce", "s", request.pierce_s, std::nullopt, [&] {
        return InferredValue{*rule.dynamic_pierce_share * plan.pierce_s,
                             fmt::format("{} times the stationary pierce", *rule.dynamic_pierce_share)};
    });
}

void resolve_shape(ValueResolver& resolver, const Materials& file, const CuttingRequest& request,
                   CuttingPlan& plan) {
    const double share = plan.cutting_speed_mm_min / plan.separation_speed_mm_min;
    plan.kerf_mm = resolver.resolve("kerf", "mm", request.kerf_mm, std::nullopt, [&] {
        return InferredValue{kerf_mm(file.kerf, plan.jet.mixing_tube_mm),
                             fmt::format("{} times the mixing tube", file.kerf.width_to_tube)};
    });
    plan.exit_kerf_mm =
        resolver.inferred("kerf at the exit", "mm",
                          {exit_kerf_mm(file.kerf, plan.kerf_mm, share), "kerf, taper and cutting speed"});
    plan.taper_mm = resolver.inferred("taper each side", "mm",
                                      {taper_mm(file.kerf, plan.kerf_mm, share),
                                       "the file's taper, and the ratio to the separation speed"});
    resolve_pierce(resolver, file.pierce, request, plan);
    plan.lag_mm = resolver.inferred(
        "jet lag", "mm",
        {lag_mm(file.lag, {plan.thickness_mm, plan.separation_speed_mm_min}, plan.cutting_speed_mm_min),
         "thickness, and the ratio to the separation speed"});
    plan.contour_error_mm =
        resolver.inferred("contour error", "mm",
                          {contour_error_mm(file.lag, plan.quality), "the file's errors for each quality"});
}

void add_warnings(CuttingPlan& plan) {
    const auto warn_if_unusual = [&](double value, const ValueRange& typical_range) {
        if (!typical_range.find_error(value)) return;
        plan.warnings.push_back(fmt::format("{} is {}, outside the usual range of {} to {}",
                                            typical_range.key, value, typical_range.min, typical_range.max));
    };
    warn_if_unusual(plan.jet.pressure_mpa, kTypicalPressure);
    warn_if_unusual(plan.jet.orifice_mm, kTypicalOrifice);
    if (plan.cutting_speed_mm_min > plan.separation_speed_mm_min) {
        plan.warnings.push_back(
            fmt::format("at {:.1f} mm/min the jet does not cut through; the max speed is {:.1f}",
                        plan.cutting_speed_mm_min, plan.separation_speed_mm_min));
    }
}

double limited_feed(const CuttingPlan& plan, double allowed_lag_mm) {
    const double speed =
        speed_for_lag_mm_min(plan.lag, {plan.thickness_mm, plan.separation_speed_mm_min}, allowed_lag_mm);
    return std::clamp(speed, plan.lag.min_feed_share * plan.cutting_speed_mm_min, plan.cutting_speed_mm_min);
}

}  // namespace

Result<CuttingPlan> plan_cutting(const Materials& materials, const CuttingRequest& request) {
    if (auto error = find_error(request)) return tl::unexpected(*std::move(error));
    const auto material = find_material(materials, request.material);
    if (!material) return tl::unexpected(material.error());
    CuttingPlan plan;
    ValueResolver resolver;
    plan.material = (*material)->name;
    if (request.dynamic_pierce && !request.pierce_s && !materials.pierce.dynamic_pierce_share) {
        return Unexpected(
            "the materials file has no 'dynamic_share' in [pierce]: the time of a dynamic pierce must be "
            "given");
    }
    plan.lag = materials.lag;
    plan.kerf = materials.kerf;
    plan.thickness_mm =
        request.thickness_basis.empty()
            ? resolver.from_request("thickness", "mm", request.thickness_mm)
            : resolver.inferred("thickness", "mm", {request.thickness_mm, request.thickness_basis});
    plan.machinability = resolve_machinability(resolver, materials, **material);
    plan.quality = resolver.resolve("quality", {}, request.quality, materials.jet.quality,
                                    [] { return InferredValue{}; });
    plan.jet = resolve_jet(resolver, materials.jet, request, plan);
    if (plan.jet.mixing_tube_mm <= plan.jet.orifice_mm) {
        return Unexpected(fmt::format("the mixing tube ({} mm) must be wider than the orifice ({} mm)",
                                      plan.jet.mixing_tube_mm, plan.jet.orifice_mm));
    }
    resolve_speeds(resolver, request, plan);
    resolve_shape(resolver, materials, request, plan);
    plan.values = resolver.release();
    plan.warnings = materials.warnings;
    add_warnings(plan);
    return plan;
}

double feed_for_radius_mm_min(const CuttingPlan& plan, double radius_mm) {
    const double radius = radius_mm > 0 ? radius_mm : 0;
    return limited_feed(plan, lag_allowed_on_arc_mm(radius, plan.contour_error_mm));
}

double feed_for_corner_mm_min(const CuttingPlan& plan, double turn_rad) {
    return limited_feed(plan, lag_allowed_in_corner_mm(turn_rad, plan.contour_error_mm));
}

double corner_zone_mm(const CuttingPlan& plan) {
    return plan.lag_mm;
}

double speed_at_thickness_mm_min(const CuttingPlan& plan, double thickness_mm) {
    return plan.cutting_speed_mm_min * std::pow(plan.thickness_mm / thickness_mm, kSpeedExponent);
}

double taper_compensation_deg(const CuttingPlan& plan, double feed_mm_min) {
    const double taper_per_side_mm =
        taper_mm(plan.kerf, plan.kerf_mm, feed_mm_min / plan.separation_speed_mm_min);
    return std::atan(taper_per_side_mm / plan.thickness_mm) * kDegPerRad;
}

}  // namespace gsim::waterjet
