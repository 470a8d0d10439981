#pragma once

#include <cstddef>
#include <deque>

#include "motion/klipper/queued_move.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Look-ahead of Klipper (klippy, 2026): straight ramps along the path, and corners by a square corner
/// velocity and by the circle that fits into short moves. A second plan with less acceleration keeps a
/// minimum cruise ratio. Speeds and accelerations are those of the path; an axis lowers them by its share of
/// the distance. Prismatic joints outside the tool path are extruders: see queued_move.cpp.
///
/// The look-ahead has no fixed end. Moves leave as soon as no later move can change them, so the pending part
/// is about what the machine needs to brake. Arcs become chords of at least arc_resolution_mm. Override
/// changes by the operator are not followed: in Klipper that is a command of the program's stream (M220).
class KlipperModel final : public MotionModel {
  public:
    /// Both must outlive the model.
    KlipperModel(const PlannerSetup& setup, SegmentOutput& output);

    PlanResult add(const PathMove& move) override;
    void plan_to_standstill() override;
    void clear() override;

  private:
    PlanResult add_line(const PathMove& line);
    void mark_target_reached(const PathMove& line);
    void emit(std::size_t count);
    void emit(const klipper::QueuedMove& move, double exit_speed);

    const PlannerSetup& setup_;
    SegmentOutput& output_;
    std::deque<klipper::QueuedMove> queue_;
    std::size_t next_plan_size_;      ///< Length of the queue at which it is planned next.
    double last_cruise_squared_ = 0;  ///< Squared cruising speed of the last move that was output,
    double speed_ = 0;                ///< and the speed at its end.
};

}  // namespace gsim::motion
