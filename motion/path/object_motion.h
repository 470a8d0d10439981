#pragma once

#include <cstddef>
#include <deque>

#include "controller/services/types.h"
#include "motion/planner/plan_error.h"

namespace gsim::motion {

/// Object of the cell that is moved from pose to pose: in straight lines at constant speed, and turned about
/// one axis in proportion to the distance (object motion, section 5.3.2 of the thesis). It has its own clock.
class ObjectMotion {
  public:
    struct Step {
        rrs::Status status = rrs::Status::RRS_SUCCESS;  ///< As GetNextStep returns.
        rrs::CartPos pose;
        double elapsed_s = 0;
    };

    ObjectMotion() : end_(rrs::CartPos::Identity()) {}

    /// Sets its pose before its next target; its targets are dropped.
    void set_position(const rrs::CartPos& pose);
    /// Sets the speed for the targets that follow, > 0.
    void set_speed(double speed_mm_s) { speed_mm_s_ = speed_mm_s; }
    /// Returns the time that the path takes, s. Errors: RRS_ZERO_SPEED without a speed, or if the object
    /// would turn without moving; RRS_QUEUE_FULL.
    tl::expected<double, PlanError> add_target(const rrs::CartPos& pose);
    /// Moves on by `step_s`, or to the end of the last path if that comes before.
    Step step(double step_s);

  private:
    struct PosePath {
        rrs::CartPos from;
        rrs::CartPos to;
        double duration_s;
    };

    std::deque<PosePath> moves_;
    double elapsed_s_ = 0;  ///< Time since the first path began.
    rrs::CartPos end_;      ///< End of the last path.
    double speed_mm_s_ = 0;
};

/// Returns the pose at `share` (0 to 1) of the path: positions on a line, orientations about one axis, by the
/// shorter rotation.
rrs::CartPos pose_between(const rrs::CartPos& from, const rrs::CartPos& to, double share);

}  // namespace gsim::motion
