#pragma once

// The implementation of a Run.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/diagnostic.h"
#include "engine/run.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/run/diagnostic_log.h"
#include "engine/src/run/output_set.h"
#include "engine/src/run/program_run.h"
#include "engine/src/run/robots_run.h"
#include "engine/src/run/run_inputs.h"
#include "engine/src/run/scene.h"

namespace gsim::engine {

class Run::State {
  public:
    State(ResolvedRequest found, DiagnosticHandler on_diagnostic)
        : found_(std::move(found)),
          cpu_limit_(found_.request.limits.cpu_s),
          diagnostics_(std::move(on_diagnostic)) {
        cpu_limit_.set_cancel_flag(found_.request.cancel.flag());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    tl::expected<void, Error> open();
    tl::expected<void, Error> open_on_machine(const Machine::Parts& parts);
    tl::expected<void, Error> prepare();
    tl::expected<Report, Error> go();
    tl::expected<std::string, Error> variables();
    tl::expected<std::string, Error> machine_data();
    Report make_report(const Error& error) const;

    const ResolvedRequest& found() const { return found_; }
    const std::vector<std::string>& names() const { return names_; }
    const std::vector<std::vector<Axis>>& axes() const { return axes_; }
    const std::vector<Error>& errors() const { return errors_; }
    simulation::Simulator& simulator(std::size_t robot) { return *simulators_[robot]; }
    OutputSet& outputs(std::size_t robot) { return *output_sets_[robot]; }
    void on_progress(Progress progress) { progress_ = std::move(progress); }
    std::vector<NamedFile> named_files() const;
    Scene scene(std::size_t robot) const {
        if (robots_ == nullptr) return make_scene(*simulators_[robot]);
        return make_scene(*simulators_[robot], robots_->stations()[robot].entry.base);
    }

  private:
    tl::expected<void, Error> open_single_robot();
    tl::expected<void, Error> open_program();
    tl::expected<void, Error> open_module();
    tl::expected<void, Error> open_dynamics();
    void add(simulation::Simulator& simulator);
    ProgressHandler progress() {
        return [this](std::uint64_t done, std::uint64_t total) {
            if (progress_) progress_(done, total);
        };
    }
    simulation::Report run_single_robot();
    simulation::RobotsReport run_robots();
    /// Returns the kept data of a run of one robot; other runs keep no data.
    tl::expected<ProgramRun*, Error> kept();

    ResolvedRequest found_;
    os::CpuLimit cpu_limit_;
    DiagnosticLog diagnostics_;
    RunContext run_context_{cpu_limit_, diagnostics_.handler()};
    std::optional<MachineInput> machine_;
    std::shared_ptr<const cell::Cell> cell_;
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<OpenedScript> program_;
    std::optional<rrs::RcsModule> module_;
    std::unique_ptr<ProgramRun> program_run_;
    std::unique_ptr<RobotsRun> robots_;
    std::vector<std::string> names_;
    std::vector<std::vector<Axis>> axes_;
    std::vector<simulation::Simulator*> simulators_;
    std::vector<std::unique_ptr<OutputSet>> output_sets_;
    std::vector<Error> errors_;
    Progress progress_;
};

}  // namespace gsim::engine
