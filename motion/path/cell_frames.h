#pragma once

#include <string_view>

#include <tl/expected.hpp>

#include "controller/services/types.h"
#include "motion/planner/plan_error.h"

namespace gsim::motion {

/// The frames of Cartesian targets: a target is where the tool frame comes to be in the object frame.
struct WorkFrames {
    rrs::CartPos tool = rrs::CartPos::Identity();    ///< In the frame of the tool centre point.
    rrs::CartPos object = rrs::CartPos::Identity();  ///< In the work frame of the machine.

    /// The tool frame in the object frame, by the tool centre point in the work frame.
    rrs::CartPos target_of(const rrs::CartPos& tool_centre) const;
    /// The way back.
    rrs::CartPos tool_centre_of(const rrs::CartPos& target) const;
    /// The origin of the tool frame seen from the tool centre point.
    Eigen::Vector3d tip_mm() const { return tool.translation(); }
};

/// The frames, by name, of the cell in which a controller's robot stands.
class CellFrames {
  public:
    virtual ~CellFrames() = default;

    /// A frame's value at a time of the run, relative to what it is attached to. RRS_UNKNOWN_FRAME.
    virtual tl::expected<rrs::CartPos, PlanError> frame(std::string_view name, double time_s) const = 0;
    /// Gives it another value from `time_s` of the run on, which is not before that of the last change.
    /// RRS_UNKNOWN_FRAME; RRS_INVALID_PARAMETER for what is no pose, for a frame of a conveyor, and for one
    /// of the machine but for those of MachineFrames.
    virtual Planned move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) = 0;
    /// The frame may be led from now on, and stands until then. Refused as by move_frame().
    virtual Planned carry_frame(std::string_view name) = 0;
    /// Leads such a frame straight and evenly to a pose, from `from_s` to `to_s`, which are not before the
    /// end of the way before.
    virtual void lead_frame(std::string_view name, const rrs::CartPos& pose, double from_s, double to_s) = 0;
    /// A tool frame and an object frame as targets need them. RRS_UNKNOWN_FRAME; RRS_INVALID_PARAMETER where
    /// the first does not move with the tool or the second not with the work frame.
    virtual tl::expected<WorkFrames, PlanError> work_frames(std::string_view tool_frame,
                                                            std::string_view object_frame) const = 0;
    /// How the machine has been moved in the world from where its kinematics have it (mm).
    virtual const rrs::CartPos& base_shift() const = 0;
};

}  // namespace gsim::motion
