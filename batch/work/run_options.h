#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text/json.h"
#include "batch/work/job_request.h"

namespace gsim::batch {

/// Option of a run in addition to its program, its machine and its settings.
struct RunOption {
    enum class Kind { text, file, flag, number, count };

    const char* name;
    Kind kind;
    const char* meaning;
    void (*set)(JobRequest& request, const nlohmann::json& value);  ///< For a value of this kind.
};

/// Returns all options, as in gsim-run.
std::span<const RunOption> run_options();
/// Returns null if no option has this name.
const RunOption* find_option(std::string_view name);

/// Checks that the option accepts a value; the error is a message.
Result<void> check_option(std::string_view name, const nlohmann::json& value);
/// Sets an option in a request. The error is that of check_option().
Result<void> set_option(JobRequest& request, std::string_view name, const nlohmann::json& value);

}  // namespace gsim::batch
