#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "motion/planner/move.h"

namespace gsim::simulation {

/// A dwell, by the id of its target, or a rest for what a word has set going.
struct AskedRest {
    rrs::TargetId target_id = 0;
    double rest_s = 0;
    std::string time_key;  ///< Of [times] in the machine file, which says how long; empty: of none.
};

/// What is planned is to end at rest; `waits`: the controller waits for its program.
struct AskedStop {
    bool waits = false;
};

/// Joints are to go by themselves.
struct AskedOwn {
    rrs::JointPos end;
};

/// One thing that a run asks of its controller, whole.
using MotionAsk = std::variant<motion::Move, AskedRest, AskedStop, AskedOwn>;

/// Is told what a run asks of its controller, in order: the same can be asked of another machine without the
/// program.
class MotionObserver {
  public:
    virtual ~MotionObserver() = default;
    /// Where the machine stands, before the first one.
    virtual void stands_at(const rrs::JointPos& joints) = 0;
    /// The controller has taken it.
    virtual void asked(const MotionAsk& ask) = 0;
    /// The motion depends on more than what is told here: `why`, as what the program does ("it probes").
    virtual void untold(std::string_view why) = 0;
    /// The program has ended.
    virtual void ended() = 0;
};

}  // namespace gsim::simulation
