#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"

namespace gsim::apps {

/// X Y Z B C, mm and deg, at the ends of moves, without lines of length 0; axes begin at 0.
using Ends = std::vector<std::array<double, 5>>;

/// Returns true if LinuxCNC's interpreter is installed.
bool has_rs274();
/// Runs a program of that folder by it. Prints the canonical calls that it makes.
Ended run_rs274(const std::filesystem::path& folder, const std::string& program);
/// Returns the ends in canonical calls.
Ends ends_of_canon(const std::string& calls);
/// Returns the ends in the output of gsim-run --moves; axes that the machine lacks are 0.
Ends ends_of_moves(const std::string& jsonl);

}  // namespace gsim::apps
