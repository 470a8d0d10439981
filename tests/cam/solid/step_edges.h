#pragma once

#include <filesystem>
#include <string>

#include "tests/cam/solid/solids.h"

namespace gsim::solid {

/// Returns the number, "#95", of the first edge of a STEP file in mm between two vertices at these positions.
/// It is from the text of the file, and empty if the file has none.
std::string edge_between(const std::filesystem::path& step, const Position& a, const Position& b);

}  // namespace gsim::solid
