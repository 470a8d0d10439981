#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "apps/machine_input.h"
#include "apps/run_arguments.h"
#include "apps/script_input.h"
#include "runtime/machine/machine_data_document.h"
#include "runtime/rrs/rcs_host.h"
#include "runtime/script/engine.h"
#include "runtime/simulation/cell_watch.h"
#include "runtime/simulation/probe.h"

namespace gsim::apps {

/// Files of the installation stand for names that are none of the user's files, and the files that the cell
/// file names for options that are not given. The error is a sentence.
tl::expected<RunArguments, std::string> with_files_found(RunArguments arguments);

/// The machine to check or to run; the built-in one where none is named.
tl::expected<MachineInput, std::string> read_machine(const RunArguments& arguments);

/// All that a run reads before the machine moves.
struct RunInputs {
    machine::Machine machine;
    machine::MachineDataDocument document;
    machine::MachineData data;  ///< With the permanent variables.
    Language language;
    script::Script program;
    std::optional<script::Script> setup;
    std::optional<rrs::RcsModule> module;  ///< Where a controller module is asked for.
    std::unique_ptr<simulation::CellWatch> cell;
    simulation::ProbeFeels probe;
    motion::OverrideSchedule overrides;
};

/// `opened` is the program; `tell` gets what is wrong with its text.
tl::expected<RunInputs, InputError> read_run_inputs(const RunArguments& arguments, MachineInput input,
                                                    OpenedScript& opened, const TellDiagnostic& tell);

}  // namespace gsim::apps
