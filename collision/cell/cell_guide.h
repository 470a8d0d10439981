#pragma once

#include <vector>

#include "machine/schema/key_guide.h"

namespace gsim::cell {

/// Returns all tables of a cell file, except those of a file of robots that may be in it. Their keys are
/// those that the reader accepts, which a test checks.
std::vector<machine::GuideTable> cell_guide();

}  // namespace gsim::cell
