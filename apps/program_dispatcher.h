#pragma once

#include <span>
#include <string>

#include "apps/programs.h"

namespace gsim::apps {

/// Runs the program selected by the name that we were called by and the arguments: one of the programs of
/// `front` by its name, or as a command of gsim. Returns the exit status; throws only if memory is exhausted.
int dispatch_program(const ProgramSet& front, const std::string& invoked_name,
                     std::span<const std::string> arguments);

}  // namespace gsim::apps
