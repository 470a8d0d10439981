#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "cam/cutting/cut_rules.h"
#include "cam/waterjet/cutting_plan.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// Returns the materials file that a request names, or the built-in one.
Result<waterjet::Materials> read_materials_input(const Host& host, const std::string& name);

/// The cutting parameters, by a material or by values alone.
struct ResolvedCutting {
    cutting::CutRules rules;
    std::optional<waterjet::CuttingPlan> plan = {};  ///< By a material.
};

/// Settles the parameters. `materials`: none if no material is requested; `plate_thickness_mm`: thickness of
/// the flat part, 0: not known.
Result<ResolvedCutting> resolve_cutting_options(const CuttingOptions& options,
                                                const std::optional<waterjet::Materials>& materials,
                                                double plate_thickness_mm);

/// Returns a message if the material has another thickness than the flat part; nothing if it has the same.
std::optional<std::string> thickness_mismatch(const CuttingOptions& options, double plate_thickness_mm);

}  // namespace gsim::engine
