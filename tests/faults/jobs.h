#pragma once

#include <vector>

#include "tests/faults/job.h"

namespace gsim::faults {

/// What the programs are for, in small: runs with outputs and without confinement, in a cell, with variables
/// and machine data that are kept; translations; paths; machine data that are changed; a check.
std::vector<Job> jobs();

/// The job of this name.
Job job_named(const std::string& name);

/// A program of so many lines that its Lua goes through a temporary file.
std::string long_program();

}  // namespace gsim::faults
