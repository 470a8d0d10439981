#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "batch/plan/plan.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Writes the files of a variant of a plan into a folder, which is created. Each program on each machine gets
/// its program file (for a path, the generated program). Machine file, cell, robots and machine data are
/// added if settings change them. File names inside become absolute, so that the files may lie elsewhere.
/// Returns the jobs of these files, which have only options.
Result<std::vector<Job>> write_variant(const Plan& plan, const std::vector<SettingValue>& settings,
                                       const std::string& folder);

/// Returns an error if the files of a variant cannot be written into a folder, which is created. Either one
/// exists already, or, if overwriting is allowed, the search itself reads it.
std::optional<Error> find_output_folder_error(const Plan& plan, const std::string& folder, bool overwrite);

}  // namespace gsim::batch
