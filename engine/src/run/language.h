#pragma once

#include <string>

#include <tl/expected.hpp>

#include "engine/src/run/script_input.h"
#include "machine/data/machine_data.h"

namespace gsim::engine {

/// What a choice, the machine file and the machine data mean together; the choice goes before what the
/// machine file says. The error is a sentence.
tl::expected<Language, std::string> language_of(const LanguageChoice& choice,
                                                const machine::ProgramTable& program,
                                                const machine::MachineData& data);

/// mm of a program unit when a run begins.
double start_unit_mm(const Language& language);

}  // namespace gsim::engine
