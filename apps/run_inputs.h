#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "apps/run_arguments.h"
#include "apps/script_input.h"
#include "runtime/machine/machine_data_document.h"
#include "runtime/rrs/rcs_host.h"
#include "runtime/script/engine.h"
#include "runtime/simulation/cell_watch.h"

namespace gsim::apps {

/// The files that the cell file names stand for options that are not given.
tl::expected<RunArguments, std::string> with_files_of_cell(RunArguments arguments);

/// The machine to check or to run; the built-in one where none is named.
tl::expected<machine::Machine, std::string> read_machine(const RunArguments& arguments);

/// All that a run reads before the machine moves.
struct RunInputs {
    machine::Machine machine;
    machine::MachineDataDocument document;
    machine::MachineData data;  ///< With the permanent variables.
    Language language;
    script::Script program;
    std::optional<script::Script> setup;
    std::optional<rrs::RcsModule> module;         ///< Where a controller module is asked for.
    std::unique_ptr<simulation::CellWatch> cell;  ///< Null where no cell is asked for.
};

tl::expected<RunInputs, InputError> read_run_inputs(const RunArguments& arguments, machine::Machine machine);

}  // namespace gsim::apps
