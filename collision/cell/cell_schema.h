#pragma once

#include <vector>

#include "machine/schema/key_schema.h"

namespace gsim::cell {

/// Returns all tables of a cell file, except those of a file of robots that may be in it. Their keys are
/// those that the reader accepts, which a test checks.
std::vector<machine::TableSchema> cell_schema();

}  // namespace gsim::cell
