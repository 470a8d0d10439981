#include "runtime/simulator/open_calls.h"

#include <algorithm>
#include <utility>

namespace gsim::simulation {

void OpenCalls::enter(OpenCall call, rrs::TargetId next) {
    change(std::make_shared<const Open>(Open{std::move(call), innermost_}), next);
}

void OpenCalls::leave(rrs::TargetId next) {
    if (innermost_) change(innermost_->outer, next);
}

void OpenCalls::change(Innermost innermost, rrs::TargetId next) {
    innermost_ = std::move(innermost);
    if (!history_.empty() && history_.back().from == next) history_.pop_back();
    history_.push_back({next, innermost_});
}

void OpenCalls::forget_before(rrs::TargetId id) {
    while (history_.size() > 1 && history_[1].from <= id) history_.pop_front();
}

std::vector<OpenCall> OpenCalls::list(const Open* innermost) {
    std::vector<OpenCall> calls;
    for (; innermost != nullptr; innermost = innermost->outer.get()) calls.push_back(innermost->call);
    return calls;
}

std::vector<OpenCall> OpenCalls::now() const {
    return list(innermost_.get());
}

std::vector<OpenCall> OpenCalls::at(rrs::TargetId id) const {
    const auto later =
        std::find_if(history_.begin(), history_.end(), [id](const Since& since) { return since.from > id; });
    return later == history_.begin() ? std::vector<OpenCall>() : list(std::prev(later)->innermost.get());
}

}  // namespace gsim::simulation
