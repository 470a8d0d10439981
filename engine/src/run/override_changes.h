#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "controller/services/controller_rules.h"
#include "engine/request.h"
#include "motion/planner/override_schedule.h"

namespace gsim::engine {

/// The overrides of a run on this controller: from its start on as the choice says, then as its file has it.
/// The error is a sentence; it names the range of the controller, and of a file the place.
tl::expected<motion::OverrideSchedule, std::string> read_overrides(const os::Files& files,
                                                                   const OverrideChoice& choice,
                                                                   const rrs::ControllerRules& controller);

/// The same of a file's text. `first` holds at the start of the run.
tl::expected<motion::OverrideSchedule, std::string> read_override_changes(
    std::string_view toml_text, std::string_view file_name, const motion::Overrides& first,
    const rrs::ControllerRules& controller);

}  // namespace gsim::engine
