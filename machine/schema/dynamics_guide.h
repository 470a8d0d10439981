#pragma once

#include <vector>

#include "machine/schema/key_guide.h"

namespace gsim::machine {

/// The keys of an axis that tell of its drive.
std::vector<GuideKey> drive_guide(bool rotary);
/// Those that tell of its servo loop.
std::vector<GuideKey> servo_guide();
/// The tables of a machine file that tell of forces and torques alone.
std::vector<GuideTable> dynamics_guide();

}  // namespace gsim::machine
