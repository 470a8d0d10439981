#pragma once

#include <vector>

#include "tests/faults/job.h"

namespace gsim::faults {

/// Returns small examples of the programs' uses: runs with outputs and without confinement, in a cell, with
/// variables and machine data that are kept; translations; paths; machine data that are changed; a check.
std::vector<Job> jobs();

/// The job of this name.
Job job_named(const std::string& name);

/// Returns a program with enough lines that its Lua passes through a temporary file.
std::string long_program();

}  // namespace gsim::faults
