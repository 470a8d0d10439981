#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"

namespace gsim::apps {

/// X Y Z B C, mm and deg, where moves end, without lines that go nowhere; axes begin at 0.
using Ends = std::vector<std::array<double, 5>>;

/// Whether LinuxCNC's interpreter is installed.
bool has_rs274();
/// Runs a program of that folder by it. Prints the canonical calls that it makes.
Ended run_rs274(const std::filesystem::path& folder, const std::string& program);
/// Of canonical calls.
Ends ends_of_canon(const std::string& calls);
/// Of what gsim-run --moves writes; axes that the machine lacks are 0.
Ends ends_of_moves(const std::string& jsonl);

}  // namespace gsim::apps
