#pragma once

#include "controller/services/types.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Ids of the targets of a run, in their order, and the source location of the last one.
class TargetIds {
  public:
    /// Returns the id that the next target gets. Changes that hold from the next move on refer to it.
    rrs::TargetId next() const { return next_; }
    /// Returns the id of a new target with this source location.
    rrs::TargetId assign(const SourceLocation& location) {
        last_location_ = location;
        return next_++;
    }
    /// Returns the source location of the last move.
    const SourceLocation& last_location() const { return last_location_; }
    /// Sets the source location of a move that has no target of its own.
    void set_last_location(const SourceLocation& location) { last_location_ = location; }
    /// Returns the source location of a move. An unexpected move has none, so it is that of the last move.
    const SourceLocation& location_of(const MoveInfo& move) const {
        return move.location.line > 0 ? move.location : last_location_;
    }

  private:
    rrs::TargetId next_ = 1;
    SourceLocation last_location_;
};

}  // namespace gsim::simulation
