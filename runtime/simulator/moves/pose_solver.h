#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/axis_groups.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Relation of poses of the tool in the selected frames to axis values.
class PoseSolver {
  public:
    /// All arguments must outlive this.
    PoseSolver(const machine::Machine& machine, const MachineMotion& motion, const ProgramPosition& position,
               const ProgramState& program, const AxisGroups& groups, Warnings& warnings)
        : machine_(machine),
          motion_(motion),
          position_(position),
          program_(program),
          groups_(groups),
          warnings_(warnings) {}

    /// Returns the frames of poses: the selected ones (SelectWorkFrames), else those of the machine.
    motion::WorkFrames work_frames() const;
    /// Returns the axis values that bring the tool to a pose in these frames, nearest to the position of the
    /// machine; the error is a message.
    tl::expected<AxisVector, std::string> solve_axes(const rrs::CartPos& pose,
                                                     const std::vector<GroupTarget>& groups = {}) const;
    /// Returns true if a line of the axes between two poses is no line of the tool. PoseMove exists for such
    /// machines.
    bool rotary_joints_move_tcp() const;
    /// Warns if the tool has lost a direction of motion at these axis values, because some joints are
    /// aligned.
    void warn_if_singular(const AxisVector& axes, const SourceLocation& location);

  private:
    const machine::Machine& machine_;
    const MachineMotion& motion_;
    const ProgramPosition& position_;
    const ProgramState& program_;
    const AxisGroups& groups_;
    Warnings& warnings_;
};

}  // namespace gsim::simulation
