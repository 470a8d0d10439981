#pragma once

#include <Eigen/Core>
#include <deque>
#include <string_view>

#include "motion/path/cell_frames.h"
#include "motion/planner/planner.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services for the frames of a cell, and the frames in which steps are reported. Each service function does
/// the same as the service of its name. It requires Initialize and a cell.
class FrameServices {
  public:
    /// Makes the services of a planner for clients with `selections`; both must outlive them.
    FrameServices(Planner& planner, Selections& selections) : planner_(planner), selections_(selections) {}

    /// Sets the cell of the robot, which must outlive the planner.
    void set_cell(CellFrames& cell) { cell_ = &cell; }
    /// Returns the cell; null without one.
    CellFrames* cell() const { return cell_; }
    /// Returns to the state at the start of a session: selects the frames of the cell that are the default.
    void restart();

    PlanResult get_cell_frame(std::string_view frame_name, rrs::CartPos& frame) const;
    PlanResult modify_cell_frame(std::string_view frame_name, const rrs::CartPos& frame);
    PlanResult select_work_frames(std::string_view tool_frame, std::string_view object_frame);

    /// Returns how the machine has been turned in the world relative to its kinematics.
    Eigen::Matrix3d base_rotation() const;
    /// True if a frame of the machine has been changed after motion that is not stepped yet was planned.
    bool machine_moved_after_step_clock() const;
    /// Returns the frames in which the step that began at `from_s` is reported.
    const WorkFrames& frames_of_step(double from_s);
    /// Drops the frames of queued motion, which has been dropped.
    void drop_queued() { frames_before_.clear(); }

  private:
    /// Frames in which the poses of queued motion are reported, until frames were moved.
    struct FramesUntil {
        double until_s;
        WorkFrames frames;
    };

    void store_frames();
    PlanResult select_frames();

    Planner& planner_;
    Selections& selections_;
    CellFrames* cell_ = nullptr;
    std::deque<FramesUntil> frames_before_;
    double machine_moved_s_ = 0;  ///< When one of MachineFrames was changed last.
};

}  // namespace gsim::motion
