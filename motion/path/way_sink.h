#pragma once

#include "motion/planner/motion_model.h"

namespace gsim::motion {

/// Is told the ways that the program asks for, in their order, of the moves that a MotionModel gets: before
/// it rounds their corners, merges them or makes chords of them.
class WaySink {
  public:
    virtual ~WaySink() = default;
    /// A move that the model is about to get.
    virtual void programmed(const PathMove& move) = 0;
    /// The model has refused the move that was told last.
    virtual void take_back() = 0;
    /// What has not been driven so far will not be.
    virtual void forget() = 0;
};

}  // namespace gsim::motion
