#pragma once

#include <cstddef>
#include <deque>

#include "motion/klipper/queued_move.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// The look-ahead of Klipper (klippy, 2026): straight ramps along the path, corners by a square corner
/// velocity and by the circle that fits into short moves, and a minimum cruise ratio, which a second plan
/// with less acceleration keeps. Speeds and accelerations are the path's; an axis lowers them by its share of
/// the way. Prismatic joints beside the tool's path are extruders: see queued_move.cpp.
///
/// The look-ahead has no end. Moves leave as soon as nothing that can follow changes them, so what is held is
/// about what the machine needs to brake. Arcs become chords of at least arc_resolution_mm. What the operator
/// turns an override to is not followed: with Klipper that is a command of the program's stream (M220).
class KlipperModel final : public MotionModel {
  public:
    /// Both must outlive the model.
    KlipperModel(const PlannerSetup& setup, SegmentOutput& output);

    Planned add(const PathMove& move) override;
    void come_to_rest() override;
    void clear() override;

  private:
    Planned add_line(const PathMove& line);
    void reach_with_last(const PathMove& line);
    void put_out(std::size_t count);
    void put_out(const klipper::QueuedMove& move, double exit_speed);

    const PlannerSetup& setup_;
    SegmentOutput& output_;
    std::deque<klipper::QueuedMove> queue_;
    std::size_t plan_at_;    ///< Length of the queue at which it is planned next.
    double top_before_ = 0;  ///< Squared cruising speed of the last move that was put out,
    double speed_ = 0;       ///< and the speed at its end.
};

}  // namespace gsim::motion
