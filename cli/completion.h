#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/command_line.h"

namespace gsim::apps {

/// A program for shell completion: under its own name, and as a command of gsim.
struct CompletedProgram {
    std::string command;  ///< "run"
    const CommandLine* line = nullptr;
};

/// Return scripts that complete `gsim` and the programs.
std::string bash_completion(const CommandLine& front, std::span<const CompletedProgram> programs);
std::string zsh_completion(const CommandLine& front, std::span<const CompletedProgram> programs);
std::string fish_completion(const CommandLine& front, std::span<const CompletedProgram> programs);

}  // namespace gsim::apps
