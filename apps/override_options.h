#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/motion/override_schedule.h"
#include "runtime/rrs/controller_rules.h"

namespace gsim::apps {

/// What an operator's overrides are turned to, in percent, as options say it.
struct OverrideOptions {
    std::optional<double> feed_percent;
    std::optional<double> rapid_percent;
    std::optional<double> spindle_percent;
    std::string file;  ///< Of changes in the course of the run; empty: none.

    /// The option that is given, or the first of them; empty where none is.
    std::string_view given() const;
};

/// The overrides of a run on this controller: from its start on as the options say, then as the file has it.
/// The error is a sentence; it names the range of the controller, and of a file the place.
tl::expected<motion::OverrideSchedule, std::string> read_overrides(const OverrideOptions& options,
                                                                   const rrs::ControllerRules& controller);

/// The same of a file's text. `first` holds at the start of the run.
tl::expected<motion::OverrideSchedule, std::string> read_override_changes(
    std::string_view toml_text, std::string_view file_name, const motion::Overrides& first,
    const rrs::ControllerRules& controller);

}  // namespace gsim::apps
