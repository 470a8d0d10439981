#pragma once

#include <tl/expected.hpp>

#include "motion/planner/planner.h"
#include "motion/services/frame_services.h"
#include "motion/services/selections.h"
#include "motion/services/target_services.h"

namespace gsim::motion {

/// Services that step along the motion, stop and continue it. Each service function does the same as the
/// service of its name. It requires Initialize.
///
/// StopMotion brakes from the instant of GetNextStep; GetNextStep then continues to the stop. Targets are
/// rejected until ContinueMotion or CancelMotion (RRS_QUEUE_FULL). Events occur in the steps of GetNextStep.
class StepServices {
  public:
    /// Makes the services of a planner for clients with `selections`. All must outlive them.
    StepServices(Planner& planner, Selections& selections, FrameServices& frames, TargetServices& targets)
        : planner_(planner), selections_(selections), frames_(frames), targets_(targets) {}

    PlanResult set_interpolation_time(double interpolation_s);
    tl::expected<rrs::Status, PlanError> get_next_step(rrs::JointPos& joints, rrs::CartPos& pose,
                                                       double& elapsed_s);
    PlanResult stop_motion();
    PlanResult continue_motion();
    PlanResult cancel_motion();

  private:
    Planner& planner_;
    Selections& selections_;
    FrameServices& frames_;
    TargetServices& targets_;
};

}  // namespace gsim::motion
