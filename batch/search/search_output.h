#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "batch/search/search.h"
#include "batch/search/verification_run.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Returns the result of a search, for people. `verification_run`: set if the best variant was run once more.
std::string to_text(const SearchPlan& search, const SearchState& state,
                    const std::optional<VerificationRun>& verification_run);
std::string to_json(const SearchPlan& search, const SearchState& state,
                    const std::optional<VerificationRun>& verification_run);
/// Returns one page that needs no other file, with a picture of all trials from the results.
Result<std::string> to_html(const SearchPlan& search, const SearchState& state,
                            const std::optional<VerificationRun>& verification_run, Database& results);

}  // namespace gsim::batch
