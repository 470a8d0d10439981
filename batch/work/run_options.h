#pragma once

#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "batch/work/job_request.h"

namespace gsim::batch {

/// Something that a run may be told beside its program, its machine and its settings.
struct RunOption {
    enum class Kind { text, file, flag, number, count };

    const char* name;
    Kind kind;
    const char* meaning;
    void (*set)(JobRequest& request, const nlohmann::json& value);  ///< Of a value of this kind.
};

/// All of them, as gsim-run has them.
std::span<const RunOption> run_options();
/// Null where there is none of this name.
const RunOption* find_option(std::string_view name);

/// Whether a value is what the option takes; the error is a sentence.
tl::expected<void, std::string> check_option(std::string_view name, const nlohmann::json& value);
/// Puts one into a request. The error is that of check_option().
tl::expected<void, std::string> set_option(JobRequest& request, std::string_view name,
                                           const nlohmann::json& value);

}  // namespace gsim::batch
