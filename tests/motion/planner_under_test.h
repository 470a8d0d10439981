#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "controller/module/rcs_process.h"
#include "controller/module/rcs_shell.h"
#include "runtime/rcs/rcs_machine.h"
#include "tests/build_files/build_files.h"
#include "tests/motion/machines.h"

namespace gsim::motion {

/// Access to our planner through the services: in this process, or through a controller module here or in a
/// process of its own.
struct PlannerMaker {
    const char* name;
    std::unique_ptr<rrs::Shell> (*make)(const PlannerSetup& setup);
};

inline std::unique_ptr<rrs::Shell> make_in_process(const PlannerSetup& setup) {
    return std::make_unique<DefaultPlanner>(setup);
}

inline std::unique_ptr<rrs::Shell> make_through_module(const PlannerSetup& setup) {
    const rcs::RcsMachine machine(setup);
    static const auto library = rrs::RcsLibrary::load(tests::default_module_path(), machine.get());
    if (!library) throw std::runtime_error(library.error().message);
    auto module = rrs::RcsModule::create(*library, machine.get());
    if (!module) throw std::runtime_error(module.error().message);
    return std::make_unique<rrs::RcsShell>(*std::move(module), setup.joint_count());
}

inline std::unique_ptr<rrs::Shell> make_through_process(const PlannerSetup& setup) {
    auto module = rrs::start_rcs_process(tests::program_path("gsim-rcs-host"), tests::default_module_path(),
                                         rcs::RcsMachine(setup).get());
    if (!module) throw std::runtime_error(module.error().message);
    return std::make_unique<rrs::RcsShell>(*std::move(module), setup.joint_count());
}

/// Test of the services alone, for all variants.
class AnyPlanner : public testing::TestWithParam<PlannerMaker> {
  protected:
    static std::unique_ptr<rrs::Shell> make(const PlannerSetup& setup) { return GetParam().make(setup); }
};

/// For INSTANTIATE_TEST_SUITE_P.
inline auto all_ways() {
    return testing::Values(PlannerMaker{"in_process", make_in_process},
                           PlannerMaker{"through_module", make_through_module},
                           PlannerMaker{"through_process", make_through_process});
}

inline std::string way_name(const testing::TestParamInfo<PlannerMaker>& info) {
    return info.param.name;
}

/// Result of stepping to the end of the queue.
struct Stepped {
    double time_s = 0;
    double distance_mm = 0;  ///< Tool distance, from step to step.
    rrs::JointPos joints;
    rrs::CartPos pose = rrs::CartPos::Identity();
};

/// Takes steps of `step_s` until the queue is empty.
inline Stepped step_to_end(rrs::Shell& planner, double step_s) {
    planner.SetInterpolationTime(step_s);
    Stepped stepped;
    for (bool first = true;; first = false) {
        const Eigen::Vector3d before = stepped.pose.translation();
        double elapsed_s = 0;
        const rrs::Status status = planner.GetNextStep(stepped.joints, stepped.pose, elapsed_s);
        if (static_cast<int>(status) < 0) throw std::runtime_error(std::string(rrs::name(status)));
        if (status == rrs::Status::RRS_NEED_MORE_DATA) return stepped;
        stepped.time_s += elapsed_s;
        if (!first) stepped.distance_mm += (stepped.pose.translation() - before).norm();
    }
}

/// Returns the planner's position with an empty queue.
inline rrs::JointPos position(rrs::Shell& planner) {
    return step_to_end(planner, 1).joints;
}

inline std::string message(rrs::Shell& planner) {
    std::string text;
    planner.GetMessage(text);
    return text;
}

/// Queues the end of a motion in joint values.
inline rrs::Status enqueue(rrs::Shell& planner, const rrs::JointPos& joints, rrs::TargetId id = 1) {
    return planner.SetNextTarget(id, rrs::TargetParam::end, rrs::CartPos::Identity(), joints, "", 0);
}

/// Result of a step of GetNextStep.
struct Step {
    rrs::Status status;
    rrs::JointPos joints;
    double elapsed_s;
};

/// Planner with its services, ready for targets in joint values, with a clock of its own.
class ReadyShell {
  public:
    ReadyShell(std::unique_ptr<rrs::Shell> shell, const rrs::JointPos& start)
        : planner(*shell), owner_(std::move(shell)) {
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), start, "");
    }

    rrs::Status to(const rrs::JointPos& joints) { return enqueue(planner, joints, ++id); }
    rrs::Status arc_to(const rrs::JointPos& joints, const Eigen::Vector3d& center,
                       const Eigen::Vector3d& axis, double sweep_rad) {
        return planner.SetNextArcTarget(++id, center, axis, sweep_rad, rrs::CartPos::Identity(), joints);
    }
    Step step() {
        Step step{};
        rrs::CartPos pose;
        step.status = planner.GetNextStep(step.joints, pose, step.elapsed_s);
        time_s += step.elapsed_s;
        return step;
    }
    /// Takes steps until the robot is at standstill; returns the number of steps in which it reached a
    /// target.
    int run_out(rrs::JointPos& at) {
        int reached = 0;
        for (int i = 0; i < 1'000'000; ++i) {
            const Step now = step();
            at = now.joints;
            if (now.status == rrs::Status::RRS_NEED_MORE_DATA) return reached;
            if (now.status == rrs::Status::RRS_TARGET_REACHED) ++reached;
        }
        throw std::runtime_error("it does not come to an end");
    }
    /// Returns the time of a move that is enqueued alone.
    double time_to(const rrs::JointPos& joints) {
        const rrs::Status status = to(joints);
        if (status != rrs::Status::RRS_SUCCESS) throw std::runtime_error(message(planner));
        return step_to_end(planner, 1).time_s;
    }

    rrs::Shell& planner;
    rrs::TargetId id = 0;
    double time_s = 0;  ///< Sum of all steps.

  private:
    std::unique_ptr<rrs::Shell> owner_;
};

}  // namespace gsim::motion
