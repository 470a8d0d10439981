#pragma once

#include <string>
#include <vector>

namespace gsim::batch {

/// Runs gsim-batch or gsim-optimise (`program_name`) with its arguments. Returns the exit status; errors are
/// reported on standard error. Throws only because of a lack of memory or a bug.
int run_command(const std::string& program_name, const std::vector<std::string>& words);

}  // namespace gsim::batch
