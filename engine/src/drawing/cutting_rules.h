#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cam/cutting/cut_rules.h"
#include "cam/waterjet/cutting_plan.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// The materials file that a request names, or the one built in. The error is a sentence.
tl::expected<waterjet::Materials, std::string> read_materials_input(const Host& host,
                                                                    const std::string& name);

/// How something is cut, by a material or by figures alone.
struct SettledCutting {
    cutting::CutRules rules;
    std::optional<waterjet::CuttingPlan> plan = {};  ///< By a material.
};

/// Settles it. `materials`: none where no material is asked for; `plate_mm`: thickness of the flat part, 0:
/// not known. The error is a sentence.
tl::expected<SettledCutting, std::string> settle_cutting(const CuttingChoice& choice,
                                                         const std::optional<waterjet::Materials>& materials,
                                                         double plate_mm);

/// That the material has another thickness than the flat part, as a sentence; nothing where it has the same.
std::optional<std::string> other_thickness(const CuttingChoice& choice, double plate_mm);

}  // namespace gsim::engine
