#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"
#include "controller/services/controller_rules.h"
#include "engine/request.h"
#include "motion/planner/override_schedule.h"

namespace gsim::engine {

/// Returns the overrides of a run on this controller: at first as in the choice, then as in its file. The
/// error is a message; it names the range of the controller, and the source location in a file.
Result<motion::OverrideSchedule> read_overrides(const os::Files& files, const OverrideOptions& options,
                                                const rrs::ControllerRules& controller);

/// Does the same with a file's text. `first` applies at the start of the run.
Result<motion::OverrideSchedule> read_override_changes(std::string_view toml_text, std::string_view file_name,
                                                       const motion::Overrides& first,
                                                       const rrs::ControllerRules& controller);

}  // namespace gsim::engine
