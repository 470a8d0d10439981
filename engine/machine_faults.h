#pragma once

#include <vector>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/request.h"

namespace gsim::engine {

/// All that keeps the machine of a request, and its cell, from being read, each with its place: the faults of
/// the machine file or, where it has none, those of the cell file. What can be told only of a file without
/// other faults (whether there is an inverse of such axes) waits until these are gone. Empty where
/// Machine::read() and read_bodies() work.
GSIM_API std::vector<Diagnostic> find_machine_faults(const Request& request);

}  // namespace gsim::engine
