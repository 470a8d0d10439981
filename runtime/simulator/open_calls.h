#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "controller/services/types.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Calls of programs that have not ended: now, and at the time of each target with pending motion.
class OpenCalls {
  public:
    /// Records that a program is called, or the last called one ends, before the target `next` is given.
    void enter(OpenCall call, rrs::TargetId next);
    void leave(rrs::TargetId next);
    /// Forgets earlier calls, because no later query is for a target before this one.
    void forget_before(rrs::TargetId id);

    bool any() const { return innermost_ != nullptr; }
    /// Returns the open calls from the innermost to the first.
    std::vector<OpenCall> now() const;
    std::vector<OpenCall> at(rrs::TargetId id) const;

  private:
    struct Open {
        OpenCall call;
        std::shared_ptr<const Open> outer;
    };
    using Innermost = std::shared_ptr<const Open>;
    struct Since {
        rrs::TargetId from;
        Innermost innermost;
    };

    void change(Innermost innermost, rrs::TargetId next);
    static std::vector<OpenCall> list(const Open* innermost);

    Innermost innermost_;
    std::deque<Since> history_;  ///< In the order of their targets; no call is open before the first one.
};

}  // namespace gsim::simulation
