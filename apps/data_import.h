#pragma once

#include <string>

#include <tl/expected.hpp>

#include "apps/data_commands.h"
#include "apps/findings.h"
#include "engine/machine.h"

namespace gsim::apps {

/// What import reads.
const std::string& import_source(const DataArguments& arguments);

/// Whether that is a table of tools or parameters, by its ending; else it is settings, which may name tables.
bool imports_table(const DataArguments& arguments);

/// gsim-data import: the settings of a control as a machine file, or one of its tables as machine data, for
/// the axes of `machine` (null: X, Y and Z). `findings` gets what is not taken over, by name. The exit
/// status; the error is a sentence.
tl::expected<int, std::string> import_settings(const DataArguments& arguments, const engine::Machine* machine,
                                               Findings& findings);

}  // namespace gsim::apps
