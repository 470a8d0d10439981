#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "controller/services/shell.h"
#include "motion/path/cell_frames.h"
#include "motion/path/machine_frames.h"
#include "motion/path/object_motion.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services of Planner. The selections and settings of a client are kept here, in Selections, until it
/// enqueues a target, which becomes a Move with all of them. `configuration` and `param_value` of targets are
/// not checked.
///
/// Time services: StopMotion brakes from the instant of GetNextStep; GetNextStep then continues to the stop.
/// Targets are rejected until ContinueMotion or CancelMotion (RRS_QUEUE_FULL). Events occur in the steps of
/// GetNextStep. The dwell of SetRestParameter is a separate segment with its target's id. A via point has no
/// segment.
class PlannerShell : public rrs::Shell {
  public:
    /// Makes a shell; `planner` must outlive it. Moves that others enqueue in the planner run between those
    /// of this shell.
    explicit PlannerShell(Planner& planner);
    PlannerShell(const PlannerShell&) = delete;
    PlannerShell& operator=(const PlannerShell&) = delete;

    /// Sets the cell of the robot. It must outlive the planner; the run's time is on the planner's clock.
    void set_cell(CellFrames& cell) { cell_ = &cell; }
    /// Sets the operator's overrides that the targets that follow obey; no service sets this.
    void set_obeyed_overrides(const EnabledOverrides& enabled_overrides) {
        selections_.move_parameters.enabled_overrides = enabled_overrides;
    }
    const Selections& selections() const { return selections_; }
    /// Returns the last result other than plain success, with its values; GetMessage returns its message.
    const PlanError& last_error() const { return error_; }

#define GSIM_RCS_SERVICE(method, opcode, number, rrs_number, input, statuses, parameters, arguments) \
    rrs::Status method parameters override;
#include "controller/module/rcs_services.def"

  protected:
    rrs::Status not_supported(std::string_view service) override;

  private:
    rrs::Status to_status(PlanError error);
    rrs::Status to_status(PlanResult planned);
    rrs::Status reject(rrs::Status status, std::string message);
    rrs::Status not_initialized();
    rrs::Status set_positive(double& value, double requested, std::string_view what);
    rrs::Status set_percent(double& factor, double percent, std::string_view what);
    rrs::Status set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                 std::span<const double> requested, std::string_view what);
    rrs::Status set_joint_parameters(rrs::JointPos JointParameters::*values, std::span<const int> joints,
                                     std::span<const double> requested, std::string_view what);
    ProgrammedRamps ramps() const;
    void set_ramps(const ProgrammedRamps& ramps);
    rrs::Status check_criterion(int criterion);
    rrs::Status check_accuracy(int accuracy_type);
    template <typename Change>
    void change_machine(const Change& change);
    void set_corner_rule(rrs::CornerRule rule);
    rrs::Status define_event(int event_id, rrs::TargetId target, EventOffset offset);

    void restart();
    Goal goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const;
    Move move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const;
    rrs::Status enqueue(const Move& move);
    rrs::Status store_via(const Goal& goal);

    void store_frames();
    PlanResult select_frames();
    const WorkFrames& frames_of_step(double from_s);
    void move_object(const rrs::CartPos& pose, double duration_s);

    Planner& planner_;
    Selections selections_;
    std::optional<rrs::JointPos> via_;
    CellFrames* cell_ = nullptr;
    /// Frames in which the poses of queued motion are reported, until frames were moved.
    struct FramesUntil {
        double until_s;
        WorkFrames frames;
    };
    std::deque<FramesUntil> frames_before_;
    double machine_moved_s_ = 0;  ///< When one of MachineFrames was changed last.
    ObjectMotion object_;
    std::optional<std::string> object_frame_;  ///< Cell frame that is the object.
    double object_idle_s_ = 0;                 ///< When it is at its last target.
    PlanError error_;
    bool initialized_ = false;
};

}  // namespace gsim::motion
