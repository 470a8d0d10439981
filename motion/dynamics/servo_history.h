#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "motion/dynamics/servo_loop.h"
#include "motion/segment/segment.h"

namespace gsim::dynamics {

/// Last steps of servo loops: as many as the longest delay needs.
class ServoHistory {
  public:
    struct JointStep {
        double at = 0;  ///< Set point at the start.
        SpeedPolynomial speed{};
        ServoStep error;

        double set_point(double t_s) const {
            return at + t_s * (speed[0] + t_s * (speed[1] / 2 + t_s * (speed[2] / 3 + t_s * speed[3] / 4)));
        }
        double speed_at(double t_s) const {
            return speed[0] + t_s * (speed[1] + t_s * (speed[2] + t_s * speed[3]));
        }
    };
    struct Step {
        double start_s = 0;
        double duration_s = 0;
        std::vector<JointStep> joints;
    };

    explicit ServoHistory(const std::vector<ServoLoop>& loops);

    /// Sets the position of the joints before the first step.
    void begin(const rrs::JointPos& start) { start_ = start; }
    /// Returns a step to fill, with the memory of one that is no longer needed.
    Step release_spare() { return std::move(spare_); }
    void add(Step step);

    /// Returns the set points at an instant up to the end of the last step, as far back as the longest delay
    /// or in one of the last three steps.
    rrs::JointPos set_points(double t_s) const;
    /// Returns the actual positions of the joints.
    rrs::JointPos positions(double t_s) const;

  private:
    const Step* step_at(double t_s) const;

    std::vector<double> delays_s_;  ///< By joint.
    double longest_delay_s_ = 0;
    rrs::JointPos start_;
    std::deque<Step> steps_;
    Step spare_;
};

}  // namespace gsim::dynamics
