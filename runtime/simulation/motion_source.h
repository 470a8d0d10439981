#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "runtime/motion/cell_frames.h"
#include "runtime/motion/planner.h"
#include "runtime/rrs/shell.h"

namespace gsim::simulation {

/// The controller of a run: its services, and what a simulator has to know beside them. Segments go to a
/// sink in the order of time; when is the source's.
class MotionSource {
  public:
    virtual ~MotionSource() = default;

    virtual rrs::Shell& shell() = 0;
    /// Tells the controller of the cell, which must outlive this; false where it has frames of its own.
    virtual bool set_cell(motion::CellFrames& cell) = 0;
    /// The frames of the controller's Cartesian targets; none where it does not tell.
    virtual std::optional<motion::WorkFrames> work_frames() const = 0;
    /// What the operator turns the overrides to, before the first target; false where the controller cannot
    /// be told.
    virtual bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) = 0;
    /// What the targets that follow obey of them.
    virtual void set_obeyed(const motion::ObeyedOverrides& obeyed) = 0;
    /// Whether their speeds go by turns of the spindle.
    virtual void set_follows_spindle(bool follows) = 0;
    /// No speed of the tool is programmed any more; a module keeps the last one, as no service takes it back.
    virtual void forget_position_speed() = 0;
    /// As rrs::Shell::ComeToRest(); a controller that has not that service comes to rest by itself.
    virtual void come_to_rest(bool waits) = 0;
    /// As motion::DefaultPlanner::put_until().
    virtual rrs::Status put_until(const std::function<rrs::Status()>& put,
                                  const motion::StopSearch& search) = 0;
    /// No more targets will come: all segments go to the sink.
    virtual void end_program() = 0;
    /// The end of what is planned; of a module the end of what has been stepped.
    virtual double time_s() const = 0;
    /// Joint values at the last target.
    virtual const rrs::JointPos& position() const = 0;
    /// The last answer other than plain success.
    virtual motion::PlanError last_error() = 0;
    /// Whether segments are samples of a motion, not the motion itself.
    virtual bool sampled() const = 0;
    /// What makes the run worthless, as a sentence.
    virtual std::optional<std::string> fault() const = 0;
};

}  // namespace gsim::simulation
