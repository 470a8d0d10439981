#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Writes what a variant of a plan comes to into a folder, which is made: for each program on each machine
/// the program (of a path, what is written of it), and machine file, cell, robots and machine data, where
/// settings change them. What files name goes by whole names, so that they may lie elsewhere. Gives the jobs
/// of these files, with options alone.
tl::expected<std::vector<Job>, std::string> write_variant(const Plan& plan,
                                                          const std::vector<SettingValue>& settings,
                                                          const std::string& folder);

/// Why the files of a variant cannot be written into a folder, which is made, in a sentence: one is there
/// already, or, where they may be overwritten, the search itself reads it. Nothing where all is well.
std::string fault_of_folder(const Plan& plan, const std::string& folder, bool overwrite);

}  // namespace gsim::batch
