#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/services/shell.h"
#include "motion/path/cell_frames.h"
#include "motion/planner/planner.h"
#include "motion/services/selections.h"
#include "runtime/motion_sources/motion_observer.h"

namespace gsim::simulation {

/// The controller of a run, which gets each move whole. Segments go to a sink in the order of time; when is
/// the source's. Its services are for clients that call them by themselves: what these select holds for
/// their own targets, and for moves only what the Simulator takes over from selections().
class MotionSource {
  public:
    virtual ~MotionSource() = default;

    virtual rrs::Shell& shell() = 0;
    /// What clients of shell() have selected; the defaults where the controller does not tell.
    virtual const motion::Selections& selections() const = 0;
    /// The last answer of a service other than plain success.
    virtual motion::PlanError last_error() = 0;

    /// Tells the controller of the cell, which must outlive this; false where it has frames of its own.
    virtual bool set_cell(motion::CellFrames& cell) = 0;
    /// The frames of the controller's Cartesian targets; none where it does not tell.
    virtual std::optional<motion::WorkFrames> work_frames() const = 0;
    /// What the operator turns the overrides to, before the first target; false where the controller cannot
    /// be told.
    virtual bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) = 0;
    /// What sets the accelerations of the axes for each move, before the first target; false where the
    /// controller cannot be told.
    virtual bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) = 0;
    /// What targets of clients that follow obey of them.
    virtual void set_obeyed(const motion::ObeyedOverrides& obeyed) = 0;

    /// Where the machine stands when the run begins. The controller is ready then.
    virtual motion::Planned start_at(const rrs::JointPos& joints) = 0;
    /// Whether moves may have other ramps than the machine's, and a tip that is led (none: again as without).
    /// RRS_MODE_NOT_SUPPORTED, RRS_SERVICE_NOT_SUPPORTED.
    virtual motion::Planned check_ramps() const = 0;
    virtual motion::Planned check_tip(const std::optional<Eigen::Vector3d>& tip_mm) = 0;
    /// As the functions of motion::Planner.
    virtual motion::Put put(const motion::Move& move) = 0;
    virtual motion::Put put_until(const motion::Move& move, const motion::StopSearch& search) = 0;
    virtual motion::Planned put_own(const rrs::JointPos& end) = 0;
    virtual double own_end_s() const = 0;
    virtual motion::Planned put_rest(const AskedRest& rest) = 0;
    /// Sentences on what the controller has not taken of the moves since it was asked last, and makes in its
    /// own way.
    virtual std::vector<std::string> take_remarks() = 0;
    /// What is planned ends at rest; `waits`: the controller waits for its program.
    virtual void come_to_rest(bool waits) = 0;
    /// No more moves will come: all segments go to the sink.
    virtual void end_program() = 0;

    /// The end of what is planned; of a module the end of what has been stepped.
    virtual double time_s() const = 0;
    /// Up to here the sink has all motion; infinite where it has all that there is.
    virtual double passed_on_s() const = 0;
    /// Joint values at the last target.
    virtual const rrs::JointPos& position() const = 0;
    /// Whether segments are samples of a motion, not the motion itself.
    virtual bool sampled() const = 0;
    /// Processor time that was spent for this beside the thread of the run.
    virtual double cpu_beside_s() const { return 0; }
    /// What makes the run worthless, as a sentence.
    virtual std::optional<std::string> fault() const = 0;
};

}  // namespace gsim::simulation
