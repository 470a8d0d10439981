#pragma once

#include <span>
#include <string>

#include "apps/programs.h"

namespace gsim::apps {

/// What the name that we were called by and the arguments ask for: one of the programs by its own name, or as
/// a command of gsim. The exit status; does not throw but for want of memory.
int run_front(const FrontPrograms& front, const std::string& called, std::span<const std::string> arguments);

}  // namespace gsim::apps
