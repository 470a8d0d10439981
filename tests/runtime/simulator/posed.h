#pragma once

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "motion/services/default_planner.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/build_files/build_files.h"

namespace gsim::simulation {

inline constexpr const char* kFrames = R"(
[cell]
name = "frames"
[[frame]]
name = "stand"
frame = { x_mm = 30.0, y_mm = -20.0, roll_deg = 90.0 }
[[object]]
name = "fixture 1"
attached_to = "stand"
shape = { box_mm = [1.0, 1.0, 1.0] }
frame = { x_mm = 10.0, z_mm = -400.0, roll_deg = 20.0, pitch_deg = -10.0 }
[[frame]]
name = "turned tool"
attached_to = "tool"
frame = { roll_deg = 40.0 }
[[frame]]
name = "nozzle tip"
attached_to = "turned tool"
frame = { x_mm = 5.0, z_mm = -80.0 }
)";

inline machine::Machine sample(const std::string& name) {
    return machine::load_machine(tests::source_path("samples/machines/") + name + ".toml").value();
}

/// A planner that makes lines to poses, and the frames of its cell.
class Posed {
  public:
    explicit Posed(const std::string& name)
        : machine(sample(name)),
          setup(make_planner_setup(machine)),
          cell(cell::read_cell(kFrames, "frames.toml", machine).value(), machine),
          planner(setup) {
        planner.set_cell(cell);
        planner.Initialize();
        planner.SetCartesianPositionSpeed(100);
        planner.SelectTargetType(rrs::TargetType::cartesian);
        planner.SelectMotionType(rrs::MotionType::linear);
    }
    /// Sets a standstill: slides in the middle, other joints a little off home.
    void start() {
        rrs::JointPos joints(setup.joint_count());
        for (int i = 0; i < setup.joint_count(); ++i) {
            const auto index = static_cast<std::size_t>(i);
            const machine::Axis& axis = machine.axes[index];
            const motion::JointSetup& joint = setup.joints[index];
            const bool slides = joint.kind == rrs::JointKind::prismatic;
            joints[i] =
                slides ? (joint.min + joint.max) / 2 : machine::joint_value(axis, axis.home) + 0.1 + 0.05 * i;
        }
        planner.SelectTargetType(rrs::TargetType::joint);
        ASSERT_EQ(planner.SetInitialPosition(rrs::CartPos::Identity(), joints, ""), rrs::Status::RRS_SUCCESS)
            << message();
        planner.SelectTargetType(rrs::TargetType::cartesian);
        planner.SelectMotionType(rrs::MotionType::linear);
    }
    rrs::Status to(const rrs::CartPos& pose) {
        return planner.SetNextTarget(1, rrs::TargetParam::end, pose, rrs::JointPos(), "", 0);
    }
    std::string message() {
        std::string text;
        planner.GetMessage(text);
        return text;
    }
    struct Step {
        rrs::Status status;
        rrs::JointPos joints;
        rrs::CartPos pose;
    };
    Step step() {
        Step s{};
        double elapsed_s = 0;
        s.status = planner.GetNextStep(s.joints, s.pose, elapsed_s);
        return s;
    }

    machine::Machine machine;
    motion::PlannerSetup setup;
    CellMonitor cell;
    motion::DefaultPlanner planner;
};

}  // namespace gsim::simulation
