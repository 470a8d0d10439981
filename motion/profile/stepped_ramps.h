#pragma once

#include <functional>

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// A block as it is prepared for the motors, along its way; lengths mm, times min, as the control counts.
struct SteppedBlock {
    float length_mm = 0;
    float entry_mm_min = 0;
    float exit_mm_min = 0;
    float speed_mm_min = 0;               ///< Of its cruise.
    float mean_acceleration_mm_min2 = 0;  ///< By which its ramps were planned.
    float acceleration_mm_min2 = 0;       ///< That they reach at most,
    float jerk_mm_min3 = 0;               ///< and how fast it grows and falls.
};

/// What a block does in a piece of time.
struct SteppedPiece {
    LawPiece law;              ///< From 0 on; mm, s.
    bool falls_short = false;  ///< Its brakes have ended before the block: it crawls to the end of it.
};

/// The ramps of grblHAL with ENABLE_JERK_ACCELERATION (planner.c, stepper.c st_prep_buffer(); core f80fc34 of
/// 2026-08-18): blocks are planned with a mean acceleration, and driven in steps of time in which the
/// acceleration stays the same and from one to the next grows or falls by the jerk. A ramp up ends where it
/// was planned to, by a jump to its speed; one down that has lost its speed before the end of the block goes
/// on to there with what is left of it, which may take many times as long as all of the block. An
/// acceleration under way when a block ends is there at the start of the next.
///
/// Numbers are of 32 bits, as there: how much speed is left when the brakes end depends on their rounding.
class SteppedRamps {
  public:
    explicit SteppedRamps(double step_s) : step_min_(static_cast<float>(step_s / 60)) {}

    /// The acceleration for which a block is planned: that of a ramp from rest to its programmed speed.
    static float mean_acceleration(float speed_mm_min, float acceleration_mm_min2, float jerk_mm_min3);

    /// The same in mm and s, as planners count.
    static double mean_acceleration_s(double speed, double acceleration, double jerk);

    /// Hands out what the block does, in order; together its length.
    void drive(const SteppedBlock& block, const std::function<void(const SteppedPiece&)>& take);

  private:
    enum class Phase { slow_down, up, cruise, down };  // slow_down: to a speed that was turned down

    void plan(const SteppedBlock& block);
    void finish_evenly(const SteppedBlock& block, const std::function<void(const SteppedPiece&)>& take);
    void take_step(const SteppedBlock& block, const std::function<void(const SteppedPiece&)>& take);
    float slow_down(const SteppedBlock& block, float time_min, float step_from_mm);
    float ramp_up(const SteppedBlock& block, float time_min, float step_from_mm);
    float cruise(float time_min);
    float ramp_down(const SteppedBlock& block, float time_min);
    void change_acceleration(const SteppedBlock& block, float time_min, bool grows);

    float step_min_;
    // Of the block under way; the first three outlive it, as there.
    float acceleration_ = 0;
    float down_from_mm_ = 0;  ///< Before its end.
    float top_mm_min_ = 0;
    float up_until_mm_ = 0;  ///< Before its end.
    float left_mm_ = 0;
    float speed_mm_min_ = 0;
    Phase phase_ = Phase::up;
    bool falls_short_ = false;
};

}  // namespace gsim::motion
