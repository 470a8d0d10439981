#pragma once

#include <vector>

#include "machine/data/machine_data.h"
#include "machine/data/machine_data_row.h"

namespace gsim::machine {

/// Adds an entry that read_row() accepted to the data. Further axes of points only if they are known.
void add_row(MachineData& data, const SectionRules& rules, const DataRow& row, bool has_known_axes);

/// Returns the entries of a section in mm, by number, code or name. Axes of points that have no field are
/// omitted.
std::vector<DataRow> section_rows(const MachineData& data, const SectionRules& rules);

}  // namespace gsim::machine
