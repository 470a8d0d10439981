#pragma once

#include <vector>

#include "machine/schema/key_guide.h"

namespace gsim::cell {

/// All tables of a cell file, but those of a file of robots that may be in it; their keys are those that the
/// reader takes, which a test holds.
std::vector<machine::GuideTable> cell_guide();

}  // namespace gsim::cell
