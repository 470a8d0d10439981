#pragma once

#include <string>

#include "base/error.h"
#include "engine/src/run/script_input.h"
#include "machine/data/machine_data.h"

namespace gsim::engine {

/// Returns the combined language of a choice, the machine file and the machine data; the choice has priority
/// over the machine file.
Result<Language> make_language(const LanguageOptions& language_options, const machine::ProgramTable& program,
                               const machine::MachineData& data);

/// Returns mm of a program unit at the beginning of a run.
double start_unit_mm(const Language& language);

}  // namespace gsim::engine
