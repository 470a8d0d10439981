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

/// Planner behind the services: what a client selects and sets is kept here, in Selections, until it puts a
/// target, which becomes a Move with all of it. `configuration` and `param_value` of targets are not looked
/// at.
///
/// Services of time: StopMotion brakes from the instant at which GetNextStep stands; GetNextStep then goes on
/// to the stop. Until ContinueMotion or CancelMotion targets are refused (RRS_QUEUE_FULL). Events come true
/// in the steps of GetNextStep. The dwell of SetRestParameter is a segment of its own with its target's id. A
/// via point has no segment.
class PlannerShell : public rrs::Shell {
  public:
    /// `planner` must outlive the shell. Moves that others put to it go between this one's.
    explicit PlannerShell(Planner& planner);
    PlannerShell(const PlannerShell&) = delete;
    PlannerShell& operator=(const PlannerShell&) = delete;

    /// The robot stands in this cell, which must outlive the planner, on whose clock the run's time is.
    void set_cell(CellFrames& cell) { cell_ = &cell; }
    /// What the targets that follow obey of the operator's overrides, which no service says.
    void set_obeyed(const ObeyedOverrides& obeyed) { selections_.terms.obeyed = obeyed; }
    const Selections& selections() const { return selections_; }
    /// The last answer other than plain success, with its numbers; GetMessage gives its sentence.
    const PlanError& last_error() const { return error_; }

#define GSIM_RCS_SERVICE(method, opcode, number, rrs_number, input, answers, parameters, arguments) \
    rrs::Status method parameters override;
#include "controller/module/rcs_services.def"

  protected:
    rrs::Status not_supported(std::string_view service) override;

  private:
    rrs::Status tell(PlanError error);
    rrs::Status tell(Planned planned);
    rrs::Status refuse(rrs::Status status, std::string message);
    rrs::Status not_initialized();
    rrs::Status set_positive(double& value, double wanted, std::string_view what);
    rrs::Status set_percent(double& factor, double percent, std::string_view what);
    rrs::Status set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                 std::span<const double> wanted, std::string_view what);
    rrs::Status set_joint_terms(rrs::JointPos JointTerms::*values, std::span<const int> joints,
                                std::span<const double> wanted, std::string_view what);
    ProgrammedRamps ramps() const;
    void set_ramps(const ProgrammedRamps& ramps);
    rrs::Status check_criterion(int criterion);
    rrs::Status check_accuracy(int accuracy_type);
    template <typename Change>
    void change_machine(const Change& change);
    void set_corner_rule(rrs::CornerRule rule);
    rrs::Status define_event(int event_id, rrs::TargetId target, EventOffset offset);

    void start_over();
    Goal goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const;
    Move move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const;
    rrs::Status put(const Move& move);
    rrs::Status keep_via(const Goal& goal);

    void keep_frames();
    Planned select_frames();
    const WorkFrames& frames_of_step(double from_s);
    void lead_object(const rrs::CartPos& pose, double duration_s);

    Planner& planner_;
    Selections selections_;
    std::optional<rrs::JointPos> via_;
    CellFrames* cell_ = nullptr;
    /// Frames in which the poses of what was queued are told, until frames were moved.
    struct FramesUntil {
        double until_s;
        WorkFrames frames;
    };
    std::deque<FramesUntil> frames_before_;
    double machine_moved_s_ = 0;  ///< When one of MachineFrames was changed last.
    ObjectMotion object_;
    std::optional<std::string> object_frame_;  ///< Of the cell; that the object is.
    double object_free_s_ = 0;                 ///< When it is at its last target.
    PlanError error_;
    bool initialized_ = false;
};

}  // namespace gsim::motion
