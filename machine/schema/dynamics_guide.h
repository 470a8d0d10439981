#pragma once

#include <vector>

#include "machine/schema/key_guide.h"

namespace gsim::machine {

/// Returns the keys of an axis for its drive.
std::vector<GuideKey> drive_guide(bool rotary);
/// Returns the keys for its servo loop.
std::vector<GuideKey> servo_guide();
/// Returns the tables of a machine file that are only for forces and torques.
std::vector<GuideTable> dynamics_guide();

}  // namespace gsim::machine
