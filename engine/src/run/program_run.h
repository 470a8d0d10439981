#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/src/run/run_inputs.h"
#include "engine/src/run/suggested_fix_search.h"
#include "runtime/report/report.h"
#include "runtime/script/engine/engine.h"

namespace gsim::engine {

using ProgressHandler = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Returns the options of the script interpreter for a request. The request, and everything that `tools`
/// refers to, must outlive it.
script::Engine::Options engine_options(const Request& request, machine::MachineData data,
                                       const Language& language, const RunContext& tools);

/// Returns the limits of a simulator.
simulation::RunLimits run_limits(const Request& request, os::CpuLimit& cpu);

/// One program on one simulated machine, made of the inputs that were read for it.
class ProgramRun {
  public:
    /// Creates a run before any motion; all arguments must outlive it.
    ProgramRun(const ResolvedRequest& found, RunInputs inputs, const RunContext& tools,
               ProgressHandler progress);

    simulation::Simulator& simulator() { return simulator_; }
    script::Engine& engine() { return engine_; }
    machine::MachineDataDocument& document() { return document_; }
    /// Returns the name of the program.
    const std::string& program() const { return program_; }

    /// Runs to the end, an alarm or a limit; returns the report.
    simulation::Report run();

  private:
    SuggestedFixSearch suggested_fix_search_;
    simulation::Simulator simulator_;
    std::unique_ptr<simulation::CellMonitor> cell_;
    machine::MachineDataDocument document_;
    std::string program_;
    script::Script script_;
    script::Engine engine_;
};

}  // namespace gsim::engine
