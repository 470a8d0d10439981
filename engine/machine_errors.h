#pragma once

#include <vector>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/request.h"

namespace gsim::engine {

/// Returns all errors that prevent reading the machine of a request, and its cell, each with its source
/// location: the errors of the machine file or, if it has none, those of the cell file. Some checks need a
/// file without other errors (such as the existence of an inverse for such axes) and wait until these are
/// fixed. Empty if Machine::read() and read_bodies() work.
GSIM_API std::vector<Diagnostic> find_machine_errors(const Request& request);

}  // namespace gsim::engine
