#include "runtime/simulator/open_calls.h"

#include <algorithm>
#include <utility>

namespace gsim::simulation {

void OpenCalls::enter(OpenCall call, rrs::TargetId next) {
    change(std::make_shared<const OpenCallNode>(OpenCallNode{std::move(call), call_stack_}), next);
}

void OpenCalls::leave(rrs::TargetId next) {
    if (call_stack_) change(call_stack_->outer, next);
}

void OpenCalls::change(CallStack call_stack, rrs::TargetId next) {
    call_stack_ = std::move(call_stack);
    if (!history_.empty() && history_.back().from == next) history_.pop_back();
    history_.push_back({next, call_stack_});
}

void OpenCalls::discard_before(rrs::TargetId id) {
    while (history_.size() > 1 && history_[1].from <= id) history_.pop_front();
}

std::vector<OpenCall> OpenCalls::list(const OpenCallNode* call_stack) {
    std::vector<OpenCall> calls;
    for (; call_stack != nullptr; call_stack = call_stack->outer.get()) calls.push_back(call_stack->call);
    return calls;
}

std::vector<OpenCall> OpenCalls::now() const {
    return list(call_stack_.get());
}

std::vector<OpenCall> OpenCalls::at(rrs::TargetId id) const {
    const auto later = std::find_if(history_.begin(), history_.end(),
                                    [id](const StackChange& stack_change) { return stack_change.from > id; });
    return later == history_.begin() ? std::vector<OpenCall>() : list(std::prev(later)->call_stack.get());
}

}  // namespace gsim::simulation
