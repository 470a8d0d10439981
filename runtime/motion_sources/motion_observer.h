#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "motion/planner/move.h"

namespace gsim::simulation {

/// Dwell, by the id of its target, or standstill for something that a word has started.
struct AskedRest {
    rrs::TargetId target_id = 0;
    double rest_s = 0;
    std::string time_key;  ///< Key of [times] in the machine file, which gives the duration; empty: none.
};

/// Request that the planned motion ends at standstill; `waits`: the controller waits for its program.
struct AskedStop {
    bool waits = false;
};

/// Request that joints move independently.
struct AskedOwn {
    rrs::JointPos end;
};

/// One complete request of a run to its controller.
using MotionAsk = std::variant<motion::Move, AskedRest, AskedStop, AskedOwn>;

/// Observer of a run's requests to its controller, in order: the same can be requested from another machine
/// without the program.
class MotionObserver {
  public:
    virtual ~MotionObserver() = default;
    /// Reports the position of the machine before the first request.
    virtual void stands_at(const rrs::JointPos& joints) = 0;
    /// Reports a request after the controller has accepted it.
    virtual void asked(const MotionAsk& ask) = 0;
    /// Reports that the motion depends on more than these calls: `why`, as what the program does ("it
    /// probes").
    virtual void untold(std::string_view why) = 0;
    /// Reports that the program has ended.
    virtual void ended() = 0;
};

}  // namespace gsim::simulation
