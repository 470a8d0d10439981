#pragma once

#include <span>
#include <string>

#include "machine/data/machine_data_row.h"

namespace gsim::engine {

/// Returns a section for people: its keyword, a line with the names of the fields in use, a line for each
/// entry, in columns.
std::string data_table(const machine::SectionRules& rules, std::span<const machine::DataRow> rows);

/// Returns one entry for people: a line for each of its fields, and its unit.
std::string data_list(const machine::SectionRules& rules, const machine::DataRow& row);

}  // namespace gsim::engine
