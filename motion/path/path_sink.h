#pragma once

#include "motion/planner/motion_model.h"

namespace gsim::motion {

/// Receiver of the paths that the program requests, in their order, for the moves that a MotionModel gets:
/// before it rounds their corners, merges them or makes chords of them.
class PathSink {
  public:
    virtual ~PathSink() = default;
    /// Receives a move that the model is about to get.
    virtual void on_programmed_move(const PathMove& move) = 0;
    /// Takes back the last reported move, which the model has rejected.
    virtual void discard_last_move() = 0;
    /// Drops what has not been driven so far, because it will not be.
    virtual void forget() = 0;
};

}  // namespace gsim::motion
