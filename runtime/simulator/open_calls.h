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
    void discard_before(rrs::TargetId id);

    bool any() const { return call_stack_ != nullptr; }
    /// Returns the open calls from the innermost to the first.
    std::vector<OpenCall> now() const;
    std::vector<OpenCall> at(rrs::TargetId id) const;

  private:
    struct OpenCallNode {
        OpenCall call;
        std::shared_ptr<const OpenCallNode> outer;
    };
    using CallStack = std::shared_ptr<const OpenCallNode>;
    struct StackChange {
        rrs::TargetId from;
        CallStack call_stack;
    };

    void change(CallStack call_stack, rrs::TargetId next);
    static std::vector<OpenCall> list(const OpenCallNode* call_stack);

    CallStack call_stack_;
    std::deque<StackChange>
        history_;  ///< In the order of their targets; no call is open before the first one.
};

}  // namespace gsim::simulation
