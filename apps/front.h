#pragma once

#include <span>
#include <string>

#include "apps/programs.h"

namespace gsim::apps {

/// Runs what the name that we were called by and the arguments ask for: one of front's programs by its own
/// name, or as a command of gsim. Returns the exit status; throws only if memory lacks.
int run_front(const FrontPrograms& front, const std::string& called, std::span<const std::string> arguments);

}  // namespace gsim::apps
