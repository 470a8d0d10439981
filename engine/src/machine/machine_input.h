#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/os/input_file.h"
#include "base/text/diagnostic.h"
#include "engine/host.h"
#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::engine {

/// A machine as named by a request, a file of robots or a cell: a machine file, a sample by its name, or the
/// settings of a controller (LinuxCNC's .ini, the response of grbl to $$).
struct MachineInput {
    machine::Machine machine;
    std::optional<machine::MachineData> data;  ///< Offsets and tools that the settings name.
    std::vector<std::string> notes;            ///< Messages about settings that are not imported.
    std::vector<std::string> warnings;         ///< As of machine::FileMessages.
};

/// Returns the warnings about the file and the notes.
std::vector<text::Diagnostic> machine_diagnostics(const MachineInput& input);

/// Reads it; an empty name is the built-in machine. The error is a message; `errors`, if given, receives all
/// errors, the first one first.
Result<MachineInput> read_machine_input(const Host& host, const std::string& name, os::NameSource name_source,
                                        std::vector<std::string>* errors = nullptr);

/// Reads only its data about programs: a machine file is not read any further.
Result<machine::ProgramTable> read_program_input(const Host& host, const std::string& name);

}  // namespace gsim::engine
