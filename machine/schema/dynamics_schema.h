#pragma once

#include <vector>

#include "machine/schema/key_schema.h"

namespace gsim::machine {

/// Returns the keys of an axis for its drive.
std::vector<KeySchema> drive_schema(bool rotary);
/// Returns the keys for its servo loop.
std::vector<KeySchema> servo_schema();
/// Returns the tables of a machine file that are only for forces and torques.
std::vector<TableSchema> dynamics_schema();

}  // namespace gsim::machine
