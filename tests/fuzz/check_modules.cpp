#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "controller/module/rcs_shell.h"
#include "machine/file/machine_file.h"
#include "runtime/rcs/rcs_machine.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/build_files/build_files.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/small_run.h"

namespace gsim::fuzz {
namespace {

using rrs::Status;

machine::Machine module_machine() {
    return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
}

/// Machine as modules receive it, and the answers that they must give.
class Description {
  public:
    Description(const machine::Machine& machine, std::string_view response_bytes)
        : rcs_(simulation::make_planner_setup(machine)),
          machine_(rcs_.get()),
          answers_(response_bytes),
          size_(std::to_string(response_bytes.size())),
          parameters_{{{"answers", answers_.data()}, {"answers_size", size_.c_str()}}} {
        machine_.parameters = parameters_.data();
        machine_.parameter_count = parameters_.size();
    }
    Description(const Description&) = delete;
    Description& operator=(const Description&) = delete;

    const gsim_rcs_machine& get() const { return machine_; }

  private:
    rcs::RcsMachine rcs_;
    gsim_rcs_machine machine_;
    std::string answers_;
    std::string size_;
    std::array<gsim_rcs_parameter, 2> parameters_;
};

/// Loaded once in a process, because its trial takes a process of its own.
const std::shared_ptr<const rrs::RcsLibrary>& answers_library() {
    static const std::shared_ptr<const rrs::RcsLibrary> library = [] {
        const Description description(module_machine(), "");
        auto loaded =
            rrs::RcsLibrary::load(tests::build_path("lib/fuzz_modules/answers.so"), description.get());
        if (!loaded) throw std::runtime_error(loaded.error().message);
        return *std::move(loaded);
    }();
    return library;
}

rrs::RcsModule module_with(const Description& description) {
    return rrs::RcsModule::create(answers_library(), description.get()).value();
}

/// Calls services of a shell and keeps the first thing that does not hold.
class Caller {
  public:
    Caller(rrs::RcsModule module, int joints) : shell_(std::move(module), joints), joints_(joints) {}

    std::optional<std::string> call_all() {
        note("Initialize", shell_.Initialize());
        ask_frames();
        const rrs::JointPos zero = rrs::JointPos::Zero(joints_);
        note("SetInitialPosition", shell_.SetInitialPosition(rrs::CartPos::Identity(), zero, ""));
        note("SetInterpolationTime", shell_.SetInterpolationTime(kStep_s));
        for (int i = 0; i < kTargets; ++i) move(i);
        note("StopMotion", shell_.StopMotion());
        note("ContinueMotion", shell_.ContinueMotion());
        note("Terminate", shell_.Terminate());
        return broken_;
    }

  private:
    static constexpr int kTargets = 3;
    static constexpr double kStep_s = 0.02;

    void fail(std::string_view service, std::string_view what) {
        if (!broken_) broken_ = fmt::format("{} {}", service, what);
    }

    /// Returns true if the service has given an answer.
    bool note(std::string_view service, Status status) {
        const bool is_fault = status == Status::RRS_MODULE_FAULT;
        if (is_fault != shell_.error().has_value())
            fail(service, "does not answer as the fault that there is");
        if (shell_.error()) {
            std::string message;
            shell_.GetMessage(message);
            if (message.empty()) fail(service, "has a fault and no message");
        }
        return static_cast<int>(status) >= 0;
    }

    void check(std::string_view service, const rrs::CartPos& pose) {
        if (!pose.matrix().allFinite()) fail(service, "hands on a pose that is not finite");
    }
    void check(std::string_view service, const rrs::JointPos& joints) {
        if (joints.size() != joints_ || !joints.allFinite()) fail(service, "hands on joints that are none");
    }

    void ask_frames() {
        rrs::CartPos pose = rrs::CartPos::Identity();
        rrs::JointPos joints = rrs::JointPos::Zero(joints_);
        if (note("GetForwardKinematics", shell_.GetForwardKinematics(joints, pose)))
            check("GetForwardKinematics", pose);
        if (note("GetInverseKinematics", shell_.GetInverseKinematics(pose, joints, joints)))
            check("GetInverseKinematics", joints);
        if (note("GetCellFrame", shell_.GetCellFrame("work", pose))) check("GetCellFrame", pose);
    }

    void move(int i) {
        const rrs::JointPos joints = rrs::JointPos::Constant(joints_, i);
        note("SetNextTarget",
             shell_.SetNextTarget(i, rrs::TargetParam::end, rrs::CartPos::Identity(), joints, "", 0));
        rrs::JointPos at = joints;
        rrs::CartPos pose = rrs::CartPos::Identity();
        double elapsed_s = 0;
        if (note("GetNextStep", shell_.GetNextStep(at, pose, elapsed_s))) {
            check("GetNextStep", at);
            check("GetNextStep", pose);
            if (!(elapsed_s >= 0 && elapsed_s <= kStep_s))
                fail("GetNextStep", "hands on a time out of its step");
        }
        int event = 0;
        double time_s = 0;
        note("GetEvent", shell_.GetEvent(i, event, time_s));
        rrs::TargetId id = 0;
        note("GetTargetOfLastStep", shell_.GetTargetOfLastStep(id));
    }

    rrs::RcsShell shell_;
    int joints_;
    std::optional<std::string> broken_;
};

}  // namespace

Outcome check_rcs_values(std::string_view bytes) {
    const machine::Machine machine = module_machine();
    const Description description(machine, bytes);
    Caller caller(module_with(description), static_cast<int>(machine.axes.size()));
    if (auto error = caller.call_all()) return broken(*std::move(error));
    return outcome_of(run_moves({.machine = machine, .module = module_with(description)}));
}

}  // namespace gsim::fuzz
