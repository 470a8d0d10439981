#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/input_file.h"
#include "engine/host.h"
#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::engine {

/// A machine as a request, or a file of robots or a cell names it: a machine file, a sample by its
/// name, or the settings of a control (LinuxCNC's .ini, what grbl answers to $$).
struct MachineInput {
    machine::Machine machine;
    std::optional<machine::MachineData> data;  ///< Offsets and tools that the settings name.
    std::vector<std::string> notes;            ///< What of the settings is not taken over, in sentences.
};

/// Reads it; an empty name is the machine that is built in. The error is a sentence; `faults`, where given,
/// gets all that there are, the first one first.
tl::expected<MachineInput, std::string> read_machine_input(const Host& host, const std::string& name,
                                                           os::NamedBy named_by,
                                                           std::vector<std::string>* faults = nullptr);

/// Of that only what it says of programs: a machine file is not read any further.
tl::expected<machine::ProgramTable, std::string> read_program_input(const Host& host,
                                                                    const std::string& name);

}  // namespace gsim::engine
