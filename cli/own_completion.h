#pragma once

#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Scripts that complete one program.
std::string own_bash_completion(const CommandLine& line);
std::string own_zsh_completion(const CommandLine& line);
std::string own_fish_completion(const CommandLine& line);

}  // namespace gsim::apps
