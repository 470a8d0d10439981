#pragma once

#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Returns a script that completes one program.
std::string own_bash_completion(const CommandLine& line);
std::string own_zsh_completion(const CommandLine& line);
std::string own_fish_completion(const CommandLine& line);

}  // namespace gsim::apps
