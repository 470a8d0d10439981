#pragma once

#include <vector>

#include "engine/machine_data.h"
#include "machine/data/machine_data_sections.h"

namespace gsim::engine {

/// The rules of all sections, as users of this library take them.
std::vector<MachineData::Section> data_sections(const machine::DataRules& rules);

}  // namespace gsim::engine
