#pragma once

#include <string_view>

#include <tl/expected.hpp>

#include "controller/services/types.h"
#include "motion/planner/plan_error.h"

namespace gsim::motion {

/// Frames of Cartesian targets: a target is the pose of the tool frame in the object frame.
struct WorkFrames {
    rrs::CartPos tool = rrs::CartPos::Identity();    ///< In the frame of the tool centre point.
    rrs::CartPos object = rrs::CartPos::Identity();  ///< In the work frame of the machine.

    /// Returns the tool frame in the object frame, from the TCP in the work frame.
    rrs::CartPos to_target(const rrs::CartPos& tcp_pose) const;
    /// Returns the inverse of to_target().
    rrs::CartPos to_tool_centre(const rrs::CartPos& target) const;
    /// Returns the origin of the tool frame seen from the TCP.
    Eigen::Vector3d tcp_mm() const { return tool.translation(); }
};

/// Frames, by name, of the cell with a controller's robot.
class CellFrames {
  public:
    virtual ~CellFrames() = default;

    /// Returns a frame's value at a time of the run, relative to its parent frame. Error: RRS_UNKNOWN_FRAME.
    virtual tl::expected<rrs::CartPos, PlanError> frame(std::string_view name, double time_s) const = 0;
    /// Sets another value of the frame from `time_s` of the run on, which is not before that of the last
    /// change. Errors: RRS_UNKNOWN_FRAME; RRS_INVALID_PARAMETER if `pose` is no pose, for a frame of a
    /// conveyor, and for one of the machine other than those of MachineFrames.
    virtual PlanResult move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) = 0;
    /// Allows interpolate_frame() for the frame from now on; it is at standstill until then. Errors as in
    /// move_frame().
    virtual PlanResult enable_frame_motion(std::string_view name) = 0;
    /// Moves such a frame straight and evenly to a pose, from `from_s` to `to_s`, which are not before the
    /// end of the previous path.
    virtual void interpolate_frame(std::string_view name, const rrs::CartPos& pose, double from_s,
                                   double to_s) = 0;
    /// Returns a tool frame and an object frame as targets need them. Errors: RRS_UNKNOWN_FRAME;
    /// RRS_INVALID_PARAMETER if the first does not move with the tool or the second not with the work frame.
    virtual tl::expected<WorkFrames, PlanError> work_frames(std::string_view tool_frame,
                                                            std::string_view object_frame) const = 0;
    /// Returns how the machine has been moved in the world relative to its kinematics (mm).
    virtual const rrs::CartPos& base_shift() const = 0;
};

}  // namespace gsim::motion
