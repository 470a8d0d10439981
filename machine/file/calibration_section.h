#pragma once

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"
#include "machine/schema/key_schema.h"

namespace gsim::machine {

/// Reads [calibration] and [[calibrated]], if present, into a machine whose axes and controller have been
/// read.
void read_calibration(base::FirstError& error, base::TomlSection& file, Machine& machine);

void print_calibration(base::TomlWriter& out, const Calibration& calibration);

/// Returns the tables as people fill them in.
std::vector<TableSchema> calibration_schema();

}  // namespace gsim::machine
