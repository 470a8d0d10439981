#pragma once

#include <functional>

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// Block as it is prepared for the motors, along its path; lengths mm, times min, as the controller counts.
struct SteppedBlock {
    float length_mm = 0;
    float entry_mm_min = 0;
    float exit_mm_min = 0;
    float speed_mm_min = 0;               ///< Cruise speed.
    float mean_acceleration_mm_min2 = 0;  ///< By which its ramps were planned.
    float acceleration_mm_min2 = 0;       ///< Max acceleration of its ramps,
    float jerk_mm_min3 = 0;               ///< and how fast it grows and falls.
};

/// Motion of a block in a time interval.
struct SteppedSection {
    LawSection law;            ///< From 0 on; mm, s.
    bool stops_short = false;  ///< Its brakes have ended before the block: it crawls to the end of it.
};

/// Ramps of grblHAL with ENABLE_JERK_ACCELERATION (planner.c, stepper.c st_prep_buffer(); core f80fc34 of
/// 2026-08-18). Blocks are planned with a mean acceleration. They are driven in steps of time in which the
/// acceleration stays the same; it grows or falls by the jerk from one step to the next. A ramp up ends at
/// its planned position, by a jump to its speed. A ramp down that has lost its speed before the end of the
/// block continues to there with the remaining speed. That may take many times as long as the complete block.
/// An acceleration that is active at the end of a block is still active at the start of the next.
///
/// Numbers have 32 bits, as there: the speed that remains at the end of braking depends on their rounding.
class SteppedRamps {
  public:
    explicit SteppedRamps(double step_s) : step_min_(static_cast<float>(step_s / 60)) {}

    /// Returns the acceleration for which a block is planned: that of a ramp from standstill to its
    /// programmed speed.
    static float mean_acceleration(float speed_mm_min, float acceleration_mm_min2, float jerk_mm_min3);

    /// Returns the same in mm and s, as planners count.
    static double mean_acceleration_s(double speed, double acceleration, double jerk);

    /// Delivers the motion of the block, in order; together its length.
    void drive(const SteppedBlock& block, const std::function<void(const SteppedSection&)>& on_part);

  private:
    enum class Phase { slow_down, up, cruise, down };  // slow_down: to a speed that was turned down

    void plan(const SteppedBlock& block);
    void finish_at_constant_speed(const SteppedBlock& block,
                                  const std::function<void(const SteppedSection&)>& on_part);
    void advance_step(const SteppedBlock& block, const std::function<void(const SteppedSection&)>& on_part);
    float slow_down(const SteppedBlock& block, float time_min, float step_from_mm);
    float ramp_up(const SteppedBlock& block, float time_min, float step_from_mm);
    float cruise(float time_min);
    float ramp_down(const SteppedBlock& block, float time_min);
    void change_acceleration(const SteppedBlock& block, float time_min, bool increases);

    float step_min_;
    // State of the active block; the first three outlive it, as there.
    float acceleration_ = 0;
    float down_from_mm_ = 0;  ///< Before its end.
    float top_mm_min_ = 0;
    float up_until_mm_ = 0;  ///< Before its end.
    float remaining_mm_ = 0;
    float speed_mm_min_ = 0;
    Phase phase_ = Phase::up;
    bool stops_short_ = false;
};

}  // namespace gsim::motion
