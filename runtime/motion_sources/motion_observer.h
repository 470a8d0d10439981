#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "motion/planner/move.h"

namespace gsim::simulation {

/// Dwell, by the id of its target, or standstill for something that a word has started.
struct DwellRequest {
    rrs::TargetId target_id = 0;
    double dwell_s = 0;
    std::string time_key;  ///< Key of [times] in the machine file, which gives the duration; empty: none.
};

/// Request that the planned motion ends at standstill; `waits`: the controller waits for its program.
struct StopRequest {
    bool waits = false;
};

/// Request that joints move independently.
struct IndependentMoveRequest {
    rrs::JointPos end;
};

/// One complete request of a run to its controller.
using MotionRequest = std::variant<motion::Move, DwellRequest, StopRequest, IndependentMoveRequest>;

/// Observer of a run's requests to its controller, in order: the same can be requested from another machine
/// without the program.
class MotionObserver {
  public:
    virtual ~MotionObserver() = default;
    /// Reports the position of the machine before the first request.
    virtual void on_start_position(const rrs::JointPos& joints) = 0;
    /// Reports a request that the controller has accepted.
    virtual void on_request(const MotionRequest& request) = 0;
    /// Reports that the motion depends on more than these calls: `reason`, as what the program does ("it
    /// probes").
    virtual void on_unrecordable(std::string_view reason) = 0;
    /// Reports that the program has ended.
    virtual void ended() = 0;
};

}  // namespace gsim::simulation
