#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "motion/segment/segment.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// A move of the program as it was made: all segments that carry its target id.
struct RecordedMove {
    std::uint64_t n = 0;  ///< Number of the move, from 1.
    MoveInfo info;
    double start_s = 0;
    double end_s = 0;
    double length_mm = 0;  ///< Of the tool's path.
    double deviation_mm =
        0;  ///< How far the tool passes from its corners where they are rounded; 0: nowhere.
    /// What kept its longest segment from being faster; none where it only rests.
    std::optional<motion::LimitedBy> limited_by;
    rrs::JointPos end;
    std::optional<motion::Arc> arc;                  ///< If it was circular.
    std::array<int, 3> position_joints{-1, -1, -1};  ///< Joints that carry x, y, z of the arc.
};

/// Takes what a Recorder has recorded, in the order of time.
class RunOutput {
  public:
    virtual ~RunOutput() = default;
    /// Called once, before all others: where the joints stand at time 0.
    virtual void begin(const rrs::JointPos& /*start*/) {}
    virtual void take(const motion::Segment& /*segment*/, const MoveInfo& /*info*/) {}
    virtual void take(const RecordedMove& /*move*/) {}
    /// Called once, behind all others: the end of the run.
    virtual void end(double /*end_s*/) {}
};

}  // namespace gsim::simulation
