#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/materials_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

constexpr double kThickness_mm = 10;
constexpr double kRadius_mm = 5;

std::optional<std::string> fault_of_plan(const waterjet::CuttingPlan& plan) {
    const std::array values{plan.cutting_speed_mm_min,
                            plan.separation_speed_mm_min,
                            plan.kerf_mm,
                            plan.water_l_min,
                            feed_for_radius_mm_min(plan, kRadius_mm),
                            feed_for_corner_mm_min(plan, 1)};
    for (const double metric : values) {
        if (!std::isfinite(metric) || metric <= 0)
            return fmt::format("{} is cut with {}", plan.material, metric);
    }
    if (!std::isfinite(plan.pierce_s) || plan.pierce_s < 0)
        return fmt::format("{} is pierced in {} s", plan.material, plan.pierce_s);
    return std::nullopt;
}

}  // namespace

Outcome check_materials(std::string_view toml) {
    const std::string file = name_beside(".toml");
    const auto materials = waterjet::read_materials(toml, file);
    if (!materials) return refused_with(materials.error().message, file);
    for (const waterjet::Material& material : materials->materials) {
        waterjet::CuttingRequest request;
        request.material = material.name;
        request.thickness_mm = kThickness_mm;
        const auto plan = waterjet::plan_cutting(*materials, request);
        if (auto violation = plan ? fault_of_plan(*plan) : fault_of_sentence(plan.error().message))
            return broken(*std::move(violation));
    }
    return accepted();
}

}  // namespace gsim::fuzz
