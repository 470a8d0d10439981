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

/// Controller of a run, which gets each move as one. Segments are passed to a sink in the order of time; the
/// source decides when. Its services are for clients that call them by themselves. Selections of clients hold
/// for their own targets, and for moves only as far as ProgramState copies them from selections().
class MotionSource {
  public:
    virtual ~MotionSource() = default;

    virtual rrs::Shell& shell() = 0;
    /// Returns the selections of clients of shell(); the defaults if the controller does not report them.
    virtual const motion::Selections& selections() const = 0;
    /// Returns the last result of a service other than plain success.
    virtual motion::PlanError last_error() = 0;

    /// Sets the cell in the controller; the cell must outlive this. Returns false if the controller has its
    /// own frames.
    virtual bool set_cell(motion::CellFrames& cell) = 0;
    /// Returns the frames of the controller's Cartesian targets; nullopt if it does not report them.
    virtual std::optional<motion::WorkFrames> work_frames() const = 0;
    /// Sets the overrides of the operator, before the first target; returns false if the controller does not
    /// accept them.
    virtual bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) = 0;
    /// Sets the source of axis accelerations for each move, before the first target; returns false if the
    /// controller does not accept it.
    virtual bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) = 0;
    /// Sets which of them the following targets of clients obey.
    virtual void set_enabled_overrides(const motion::EnabledOverrides& enabled_overrides) = 0;

    /// Sets the machine's position at the start of the run. The controller is ready then.
    virtual motion::PlanResult start_at(const rrs::JointPos& joints) = 0;
    /// Checks that moves may have other ramps than the machine's, and TCP control (nullopt: again without
    /// it). RRS_MODE_NOT_SUPPORTED, RRS_SERVICE_NOT_SUPPORTED.
    virtual motion::PlanResult check_ramps() const = 0;
    virtual motion::PlanResult check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) = 0;
    /// As the functions of motion::Planner.
    virtual motion::EnqueueResult enqueue(const motion::Move& move) = 0;
    virtual motion::EnqueueResult enqueue_until(const motion::Move& move,
                                                const motion::StopSearch& search) = 0;
    virtual motion::PlanResult enqueue_independent(const rrs::JointPos& end) = 0;
    virtual double independent_end_s() const = 0;
    virtual motion::PlanResult enqueue_dwell(const DwellRequest& request) = 0;
    /// Returns messages on settings of moves that the controller has not accepted since the last call, and
    /// replaces by its own.
    virtual std::vector<std::string> drain_warnings() = 0;
    /// Ends the planned motion at standstill; `waits`: the controller waits for its program.
    virtual void plan_to_standstill(bool waits) = 0;
    /// Ends the moves: all segments are passed to the sink.
    virtual void end_program() = 0;

    /// Returns the end of the planned motion; for a module the end of the stepped motion.
    virtual double time_s() const = 0;
    /// Returns the time up to which the sink has all motion; infinite if it has all existing motion.
    virtual double delivered_until_s() const = 0;
    /// Returns joint values at the last target.
    virtual const rrs::JointPos& position() const = 0;
    /// Returns true if segments are samples of a motion, not the motion itself.
    virtual bool is_sampled() const = 0;
    /// Returns the processor time that this used outside the thread of the run.
    virtual double external_cpu_s() const { return 0; }
    /// Returns a message about an error that makes the run worthless.
    virtual std::optional<std::string> error() const = 0;
};

}  // namespace gsim::simulation
