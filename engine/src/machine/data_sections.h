#pragma once

#include <vector>

#include "engine/machine_data.h"
#include "machine/data/machine_data_sections.h"

namespace gsim::engine {

/// Returns the rules of all sections, in the form for users of this library.
std::vector<MachineData::Section> data_sections(const machine::DataRules& rules);

}  // namespace gsim::engine
