#pragma once

#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Returns a script that completes one program.
std::string standalone_bash_completion(const CommandLine& line);
std::string standalone_zsh_completion(const CommandLine& line);
std::string standalone_fish_completion(const CommandLine& line);

}  // namespace gsim::apps
