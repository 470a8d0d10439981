#pragma once

#include "apps/remedy.h"
#include "apps/run_arguments.h"
#include "apps/run_inputs.h"
#include "apps/script_input.h"
#include "runtime/machine/machine_data.h"
#include "runtime/script/engine.h"
#include "runtime/simulation/progress.h"
#include "runtime/simulation/report.h"

namespace gsim::apps {

/// How the options of a run set the engine up. `progress`, and what `tell` refers to, must outlive the
/// engine.
script::Engine::Options engine_options(const RunArguments& arguments, machine::MachineData data,
                                       const Language& language, simulation::Progress& progress,
                                       const TellDiagnostic& tell);

/// One program on one simulated machine, made of what was read for it.
class ProgramRun {
  public:
    /// Nothing has moved yet; `arguments` and what `tell` refers to must outlive the run.
    ProgramRun(const RunArguments& arguments, RunInputs inputs, bool show_progress,
               const TellDiagnostic& tell);

    simulation::Simulator& simulator() { return simulator_; }
    script::Engine& engine() { return engine_; }
    machine::MachineDataDocument& document() { return document_; }
    /// Name of the program.
    const std::string& program() const { return program_; }

    /// Runs to the end, an alarm or a limit; what happened.
    simulation::Report run();

  private:
    Remedy remedy_;
    simulation::Simulator simulator_;
    std::unique_ptr<simulation::CellWatch> cell_;
    machine::MachineDataDocument document_;
    simulation::Progress progress_;
    std::string program_;
    script::Script script_;
    script::Engine engine_;
};

/// Whether bodies of the cell met in a run.
bool has_collisions(const simulation::Report& report);

/// Whether a text that the run was to go on with could not be read: no fault of the program.
bool lacks_text(const simulation::Report& report);

/// What must be said even where no report is wanted, on standard error: collisions, and why the run did not
/// complete.
void print_faults(const simulation::Report& report);

}  // namespace gsim::apps
