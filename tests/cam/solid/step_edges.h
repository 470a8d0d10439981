#pragma once

#include <filesystem>
#include <string>

#include "tests/cam/solid/solids.h"

namespace gsim::solid {

/// The number, "#95", of the first edge of a STEP file in mm between two vertices at these places, by the
/// text of the file; empty: it has none.
std::string edge_between(const std::filesystem::path& step, const Place& a, const Place& b);

}  // namespace gsim::solid
