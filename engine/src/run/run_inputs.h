#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "controller/module/rcs_host.h"
#include "engine/request.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/run_cell.h"
#include "engine/src/run/script_input.h"
#include "machine/data/machine_data_document.h"
#include "runtime/monitors/cell_watch.h"
#include "runtime/script/lua/script.h"
#include "runtime/simulator/probe.h"

namespace gsim::engine {

/// What a run has beside its request, while it lasts.
struct RunTools {
    os::CpuLimit& cpu;
    const TellDiagnostic& tell;  ///< Gets what is wrong with programs' texts.
};

/// A request with the files that its names mean, and those that its cell names.
struct FoundRequest {
    Request request;
    std::string cell_text = {};                                ///< Read once: it may be a pipe.
    os::NamedBy machine_named_by = os::NamedBy::command_line;  ///< Or by the cell file.
    os::NamedBy machine_data_named_by = os::NamedBy::command_line;
};

/// Why parts of a request do not go together, as a sentence; empty where they do.
std::string find_contradiction(const Request& request);

/// The error is a sentence.
tl::expected<FoundRequest, std::string> with_files_found(Request request);

/// The same of what a request says of the machine and what stands around it, without the rest.
tl::expected<FoundRequest, std::string> with_machine_files_found(const Request& request);

/// The names alone, without those of the cell and of the program.
tl::expected<Request, std::string> with_names_found(Request request);

/// The cell that is looked at.
CellChoice cell_choice(const FoundRequest& found);

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

/// The machine data of a request, or of what it takes in their place; empty where there are none. The error
/// is a sentence.
tl::expected<machine::MachineDataDocument, std::string> read_data_of(const FoundRequest& found,
                                                                     const MachineInput& input);

/// The controller module that is asked for, made for the machine; nothing where none is. The error is a
/// sentence.
tl::expected<std::optional<rrs::RcsModule>, std::string> load_module(const Request& request,
                                                                     const machine::Machine& machine);

/// `opened` is the program.
tl::expected<RunInputs, InputError> read_run_inputs(const FoundRequest& found, MachineInput input,
                                                    std::shared_ptr<const cell::Cell> cell,
                                                    OpenedScript& opened, const RunTools& tools);

/// The setup of a run, where one is asked for.
tl::expected<std::optional<script::Script>, InputError> read_setup(const Request& request,
                                                                   const Language& language,
                                                                   const TellDiagnostic& tell);

}  // namespace gsim::engine
