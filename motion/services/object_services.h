#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/path/object_motion.h"
#include "motion/planner/planner.h"
#include "motion/services/frame_services.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services for the object that is moved in a cell. Each service function does the same as the service of its
/// name. It requires Initialize.
class ObjectServices {
  public:
    /// Makes the services of a planner for clients with `selections`. All must outlive them.
    ObjectServices(Planner& planner, FrameServices& frames, const Selections& selections)
        : planner_(planner), frames_(frames), selections_(selections) {}

    /// Returns to the state at the start of a session.
    void restart();

    /// Needs a cell.
    PlanResult select_object(std::string_view frame_name);
    PlanResult set_object_initial_position(const rrs::CartPos& pose);
    PlanResult set_object_speed(double speed_mm_s);
    PlanResult set_object_next_target(const rrs::CartPos& pose);
    rrs::Status get_next_object_step(rrs::CartPos& pose, double& elapsed_s);

  private:
    void move_object(const rrs::CartPos& pose, double duration_s);

    Planner& planner_;
    FrameServices& frames_;
    const Selections& selections_;
    ObjectMotion object_;
    std::optional<std::string> object_frame_;  ///< Cell frame that is the object.
    double object_idle_s_ = 0;                 ///< When it is at its last target.
};

}  // namespace gsim::motion
