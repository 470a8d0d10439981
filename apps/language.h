#pragma once

#include <string>

#include <tl/expected.hpp>

#include "apps/command_line.h"
#include "apps/script_input.h"
#include "runtime/machine/machine_data.h"

namespace gsim::apps {

/// The options of both programs that say how G-code is read, as they are given.
struct LanguageNames {
    std::string dialect;  ///< Empty: as the machine file says, else ab9.
    std::string unknown = "error";
};

/// --dialect and --unknown.
void add_language_options(CommandLine& line, LanguageNames& names);

/// What the options, the machine file and the machine data mean together; --dialect goes before what the
/// machine file says. The error is a sentence.
tl::expected<Language, std::string> language_of(const LanguageNames& names,
                                                const machine::ProgramTable& program,
                                                const machine::MachineData& data);

/// mm of a program unit when a run begins.
double start_unit_mm(const Language& language);

}  // namespace gsim::apps
