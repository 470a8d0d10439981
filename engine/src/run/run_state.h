#pragma once

// The implementation of a Run.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/run.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/run/documents.h"
#include "engine/src/run/program_run.h"
#include "engine/src/run/robots_run.h"
#include "engine/src/run/run_inputs.h"
#include "engine/src/run/scene.h"
#include "engine/src/values.h"

namespace gsim::engine {

class Run::State {
  public:
    State(FoundRequest found, Tell tell)
        : found_(std::move(found)), cpu_(found_.request.limits.cpu_s), user_(std::move(tell)) {
        cpu_.end_when(found_.request.cancel.flag());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    tl::expected<void, Failure> open();
    tl::expected<void, Failure> open_on(const Machine::Parts& parts);
    tl::expected<void, Failure> prepare();
    tl::expected<Report, Failure> go();
    tl::expected<std::string, Failure> variables();
    tl::expected<std::string, Failure> machine_data();
    Report report_of(const Failure& failure) const;

    const FoundRequest& found() const { return found_; }
    const std::vector<std::string>& names() const { return names_; }
    const std::vector<std::vector<Axis>>& axes() const { return axes_; }
    const std::vector<Failure>& faults() const { return faults_; }
    simulation::Simulator& simulator(std::size_t robot) { return *simulators_[robot]; }
    Documents& documents(std::size_t robot) { return *documents_[robot]; }
    void show_progress(Progress progress) { progress_ = std::move(progress); }
    std::vector<NamedFile> named_files() const;
    Scene scene(std::size_t robot) const {
        if (robots_ == nullptr) return scene_of(*simulators_[robot]);
        return scene_of(*simulators_[robot], robots_->stations()[robot].entry.base);
    }

  private:
    tl::expected<void, Failure> open_one();
    tl::expected<void, Failure> open_program();
    tl::expected<void, Failure> open_module();
    tl::expected<void, Failure> open_dynamics();
    void add(simulation::Simulator& simulator);
    ShowProgress progress() {
        return [this](std::uint64_t done, std::uint64_t total) {
            if (progress_) progress_(done, total);
        };
    }
    simulation::Report run_one();
    simulation::RobotsReport run_robots();
    /// Returns the kept data of a run of one robot; other runs keep no data.
    tl::expected<ProgramRun*, Failure> kept();

    FoundRequest found_;
    os::CpuLimit cpu_;
    Tell user_;
    std::vector<text::Diagnostic> told_;
    TellDiagnostic tell_ = [this](const text::Diagnostic& told) {
        told_.push_back(told);
        if (user_) user_(diagnostic_of(told));
    };
    RunTools tools_{cpu_, tell_};
    std::optional<MachineInput> machine_;
    std::shared_ptr<const cell::Cell> cell_;
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<OpenedScript> program_;
    std::optional<rrs::RcsModule> module_;
    std::unique_ptr<ProgramRun> one_;
    std::unique_ptr<RobotsRun> robots_;
    std::vector<std::string> names_;
    std::vector<std::vector<Axis>> axes_;
    std::vector<simulation::Simulator*> simulators_;
    std::vector<std::unique_ptr<Documents>> documents_;
    std::vector<Failure> faults_;
    Progress progress_;
};

}  // namespace gsim::engine
