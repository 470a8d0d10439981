#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "motion/segment/segment.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Move of the program as it was made: all segments that carry its target id.
struct RecordedMove {
    std::uint64_t n = 0;  ///< Number of the move, from 1.
    MoveInfo info;
    double start_s = 0;
    double end_s = 0;
    double length_mm = 0;     ///< Length of the tool's path.
    double deviation_mm = 0;  ///< Distance at which the tool passes its rounded corners; 0: not rounded.
    /// Cause that kept its longest segment from being faster; nullopt if it is only a standstill.
    std::optional<motion::LimitCause> limited_by;
    rrs::JointPos end;
    std::optional<motion::Arc> arc;                  ///< If it was circular.
    std::array<int, 3> position_joints{-1, -1, -1};  ///< Joints that carry x, y, z of the arc.
};

/// Receiver of the recordings of a Recorder, in the order of time.
class RunOutput {
  public:
    virtual ~RunOutput() = default;
    /// Begins, once and before all other calls, with the joint values at time 0.
    virtual void begin(const rrs::JointPos& /*start*/) {}
    virtual void on_segment(const motion::Segment& /*segment*/, const MoveInfo& /*info*/) {}
    virtual void on_move(const RecordedMove& /*move*/) {}
    /// Ends the run, once and after all other calls.
    virtual void end(double /*end_s*/) {}
};

}  // namespace gsim::simulation
