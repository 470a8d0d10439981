#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cam/cutting/cut_rules.h"
#include "cam/waterjet/cutting_plan.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// Returns the materials file that a request names, or the built-in one. The error is a message.
tl::expected<waterjet::Materials, std::string> read_materials_input(const Host& host,
                                                                    const std::string& name);

/// The cutting parameters, by a material or by values alone.
struct SettledCutting {
    cutting::CutRules rules;
    std::optional<waterjet::CuttingPlan> plan = {};  ///< By a material.
};

/// Settles the parameters. `materials`: none if no material is requested; `plate_mm`: thickness of the flat
/// part, 0: not known. The error is a message.
tl::expected<SettledCutting, std::string> settle_cutting(const CuttingChoice& choice,
                                                         const std::optional<waterjet::Materials>& materials,
                                                         double plate_mm);

/// Returns a message if the material has another thickness than the flat part; nothing if it has the same.
std::optional<std::string> other_thickness(const CuttingChoice& choice, double plate_mm);

}  // namespace gsim::engine
