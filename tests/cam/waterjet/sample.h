#pragma once

#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/materials_file.h"

namespace gsim::waterjet {

/// samples/materials.toml.
inline const Materials& sample_materials() {
    static const Materials materials = read_materials(built_in_materials_toml(), "materials.toml").value();
    return materials;
}

/// Returns a plan from the sample file with only these values given.
inline CuttingPlan sample_plan(std::string material, double thickness_mm, double quality) {
    CuttingRequest request;
    request.material = std::move(material);
    request.thickness_mm = thickness_mm;
    request.quality = quality;
    return plan_cutting(sample_materials(), request).value();
}

}  // namespace gsim::waterjet
