#pragma once

#include <string>
#include <string_view>

#include "controller/services/shell.h"
#include "motion/path/cell_frames.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner.h"
#include "motion/services/event_services.h"
#include "motion/services/frame_services.h"
#include "motion/services/kinematics_services.h"
#include "motion/services/object_services.h"
#include "motion/services/path_mode_services.h"
#include "motion/services/rule_services.h"
#include "motion/services/selections.h"
#include "motion/services/speed_services.h"
#include "motion/services/step_services.h"
#include "motion/services/target_services.h"

namespace gsim::motion {

/// Services of Planner. The selections and settings of a client are kept here, in Selections, until it
/// enqueues a target, which becomes a Move with all of them. `configuration` and `param_value` of targets are
/// not checked. The dwell of SetRestParameter is a separate segment with its target's id. A via point has no
/// segment.
///
/// The Realistic Robot Simulation interface is one interface of a controller, so rrs::Shell has one virtual
/// function for each of its services, and this class must override each. It has the session and the last
/// error only: each group of services is a class of its own, to which the functions delegate.
class PlannerShell : public rrs::Shell {
  public:
    /// Makes a shell; `planner` must outlive it. Moves that others enqueue in the planner run between those
    /// of this shell.
    explicit PlannerShell(Planner& planner);
    PlannerShell(const PlannerShell&) = delete;
    PlannerShell& operator=(const PlannerShell&) = delete;

    /// Sets the cell of the robot. It must outlive the planner; the run's time is on the planner's clock.
    void set_cell(CellFrames& cell) { frames_.set_cell(cell); }
    /// Sets the operator's overrides that the targets that follow obey; no service sets this.
    void set_enabled_overrides(const EnabledOverrides& enabled_overrides) {
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
    template <typename Service>
    rrs::Status serve(const Service& service);
    rrs::Status to_status(PlanError error);
    void restart();

    Planner& planner_;
    Selections selections_;
    FrameServices frames_;
    KinematicsServices kinematics_;
    TargetServices targets_;
    StepServices steps_;
    EventServices events_;
    SpeedServices speeds_;
    PathModeServices path_modes_;
    RuleServices rules_;
    ObjectServices objects_;
    PlanError error_;
    bool initialized_ = false;
};

}  // namespace gsim::motion
