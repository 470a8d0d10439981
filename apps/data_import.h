#pragma once

#include <string>

#include "apps/data_commands.h"
#include "apps/findings.h"
#include "base/error.h"
#include "engine/machine.h"

namespace gsim::apps {

/// Returns the file that import reads.
const std::string& import_source(const DataArguments& arguments);

/// Returns true if that file is a table of tools or parameters, judged by its file extension. Otherwise it
/// holds settings, which may name tables.
bool imports_table(const DataArguments& arguments);

/// Runs gsim-data import: converts the settings of a controller to a machine file, or one of its tables to
/// machine data for the axes of `machine` (null: X, Y and Z). `findings` receives what is not converted, by
/// name. Returns the exit status or an error message.
Result<int> import_settings(const DataArguments& arguments, const engine::Machine* machine,
                            Findings& findings);

}  // namespace gsim::apps
