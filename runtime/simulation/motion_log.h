#pragma once

#include <string>
#include <variant>
#include <vector>

#include "runtime/motion/move.h"

namespace gsim::simulation {

/// What a run asked of its controller, in order and whole: the same can be asked of another machine without
/// the program (motion_replay.h).
struct MotionLog {
    struct Rest {
        rrs::TargetId target_id = 0;
        double rest_s = 0;
    };
    /// What is planned ends at rest; `waits`: the controller waits for its program.
    struct Stop {
        bool waits = false;
    };
    /// Joints that go by themselves.
    struct Own {
        rrs::JointPos end;
    };
    using Entry = std::variant<motion::Move, Rest, Stop, Own>;

    rrs::JointPos start;  ///< Where the machine stands before the first one.
    std::vector<Entry> entries;
    /// Why this is not all that the motion depends on, as what the program does ("it probes"); empty: it is.
    std::string gap;
};

}  // namespace gsim::simulation
