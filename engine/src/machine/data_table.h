#pragma once

#include <span>
#include <string>

#include "machine/data/machine_data_row.h"

namespace gsim::engine {

/// A section for people: its keyword, a line with the names of the fields that are in use, a line for each
/// entry, in columns.
std::string data_table(const machine::SectionRules& rules, std::span<const machine::DataRow> rows);

/// One entry for people: a line for each field that it has, and its unit.
std::string data_list(const machine::SectionRules& rules, const machine::DataRow& row);

}  // namespace gsim::engine
