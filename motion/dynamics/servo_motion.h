#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "motion/dynamics/servo_history.h"
#include "motion/dynamics/servo_loop.h"
#include "motion/segment/segment.h"

namespace gsim::dynamics {

/// The set points over a step in which all of them are smooth.
struct SetPointStep {
    double start_s = 0;  ///< On the planner's clock.
    double duration_s = 0;
    motion::JointState from, to;
    bool begins_segment = false;
    bool straight = false;  ///< All joints go in proportion, as in all of this segment.
};

/// Simulation of the servo loops of all joints along a motion, step by step. A step is exact except for
/// rounding if a set point is a polynomial of time, which it is everywhere but on arcs and great circles. On
/// those its speed is approximated by the polynomial of third order with the speed and acceleration of both
/// ends, and no step turns by more than `kMaxRotation_rad`. Steps are long if no change remains: joints at
/// constant speeds with errors that no longer change.
class ServoMotion {
  public:
    static constexpr double kStep_s = 1e-3;
    static constexpr double kMaxRotation_rad = 0.05;
    /// Max number of steps of a segment; if it takes longer, steps are longer.
    static constexpr double kMaxSteps = 65'536;

    using StepHandler = std::function<void(const SetPointStep&)>;

    /// Takes one loop for each joint. `is_rotary`: true if the joint turns the tool or the work.
    ServoMotion(std::vector<ServoLoop> loops, std::vector<bool> is_rotary, double step_s = kStep_s);

    /// Sets all joints to this position at time 0, without an error.
    void begin(const rrs::JointPos& start);
    /// Enters the next segment, after a standstill if it begins later than the last one ended. It must
    /// outlive leave().
    void enter(const motion::Segment& segment, const StepHandler& on_step);
    /// Advances to an instant of the segment that was entered; between segments the set points do not move.
    void go_to(double t_s, const StepHandler& on_step);
    /// Advances to its end.
    void leave(const StepHandler& on_step);

    double now_s() const { return now_s_; }
    /// Returns the set points and positions of the last steps.
    const ServoHistory& history() const { return history_; }

  private:
    /// The end of the last step of a joint.
    struct JointEnd {
        double set_point = 0;
        double speed = 0;
        ServoError error;
    };

    void begin_part();
    double next_step_s(double remaining_s) const;
    bool is_steady() const;
    void make_step(double duration_s, const StepHandler& on_step);
    motion::JointState state_inside(double from_s, double to_s, bool at_end) const;
    ServoHistory::JointStep joint_step(std::size_t joint, double duration_s) const;

    std::vector<ServoLoop> loops_;
    std::vector<bool> is_rotary_;
    double step_s_;
    std::vector<JointEnd> ends_;
    ServoHistory history_;
    double now_s_ = 0;

    motion::Segment standstill_;                // between segments
    const motion::Segment* segment_ = nullptr;  // that is gone through
    double segment_time_s_ = 0;                 // in it
    std::vector<double> part_ends_s_;           // of the parts in which its laws are polynomials
    std::size_t part_ = 0;
    bool part_begun_ = false;
    bool part_constant_ = false;  // no speed changes in it
    double curve_step_s_ = 0;     // that its arcs allow
    SetPointStep set_points_;
};

}  // namespace gsim::dynamics
