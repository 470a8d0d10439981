#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "base/error.h"
#include "controller/module/rcs_host.h"
#include "engine/diagnostic.h"
#include "engine/request.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/run_cell.h"
#include "engine/src/run/script_input.h"
#include "machine/data/machine_data_document.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/script/lua/script.h"
#include "runtime/simulator/probe.h"

namespace gsim::engine {

/// Resources of a run in addition to its request.
struct RunContext {
    os::CpuLimit& cpu;
    const TextDiagnosticHandler& on_diagnostic;  ///< Receives errors in programs' texts.
};

/// A request with the files of its names, and those that its cell names.
struct ResolvedRequest {
    Request request;
    std::string cell_text = {};                                      ///< Read once: it may be a pipe.
    os::NameSource machine_named_by = os::NameSource::command_line;  ///< Or by the cell file.
    os::NameSource machine_data_named_by = os::NameSource::command_line;
};

/// Returns an error if parts of a request conflict.
std::optional<gsim::Error> find_contradiction(const Request& request);

/// Returns the request with its files.
Result<ResolvedRequest> resolve_files(Request request);

/// Does the same for the machine of a request and its surroundings, without the remainder.
Result<ResolvedRequest> resolve_machine_files(const Request& request);

/// Resolves the names alone, without those of the cell and of the program.
Result<Request> resolve_names(Request request);

/// Returns the cell to check.
CellSource make_cell_source(const ResolvedRequest& found);

/// All inputs that a run reads before the machine moves.
struct RunInputs {
    machine::Machine machine;
    machine::MachineDataDocument document;
    machine::MachineData data;  ///< With the permanent variables.
    Language language;
    script::Script program;
    std::optional<script::Script> setup;
    std::optional<rrs::RcsModule> module;  ///< Set if a controller module is requested.
    std::unique_ptr<simulation::CellMonitor> cell;
    simulation::ProbeSurface probe;
    motion::OverrideSchedule overrides;
};

/// Returns the machine data of a request, or those that replace them; empty if it has none.
Result<machine::MachineDataDocument> read_request_data(const ResolvedRequest& found,
                                                       const MachineInput& input);

/// Returns the requested controller module, made for the machine; nothing if none is requested.
Result<std::optional<rrs::RcsModule>> load_module(const Request& request, const machine::Machine& machine);

/// `opened` is the program.
tl::expected<RunInputs, Error> read_run_inputs(const ResolvedRequest& found, MachineInput input,
                                               std::shared_ptr<const cell::Cell> cell, OpenedScript& opened,
                                               const RunContext& tools);

/// Returns the setup of a run, if one is requested.
tl::expected<std::optional<script::Script>, Error> read_setup(const Request& request,
                                                              const Language& language,
                                                              const TextDiagnosticHandler& on_diagnostic);

}  // namespace gsim::engine
