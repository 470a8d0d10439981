#include "runtime/simulator/program/program_calls.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gsim::simulation {

/// Programs past the max count are recorded as the main one.
std::uint16_t ProgramCalls::number(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    const auto index = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end() && index <= std::numeric_limits<std::uint16_t>::max()) names_.push_back(name);
    return index < names_.size() ? static_cast<std::uint16_t>(index) : std::uint16_t{0};
}

void ProgramCalls::enter(std::string name, const SourceLocation& location) {
    notifier_.notify([&](ProgramObserver& observer) { observer.enter_program(name); });
    numbers_.push_back(number(name));
    open_.discard_before(recorder_.move().target_id);
    open_.enter({std::move(name), location}, ids_.next());
}

void ProgramCalls::leave() {
    const bool was_open = open_.any();
    open_.leave(ids_.next());
    if (!numbers_.empty()) numbers_.pop_back();
    if (was_open) notifier_.notify([](ProgramObserver& observer) { observer.leave_program(); });
}

void ProgramCalls::repeat() {
    notifier_.notify([this](ProgramObserver& observer) {
        const std::vector<OpenCall> calls = open_.now();
        if (calls.empty()) return;
        observer.leave_program();
        observer.enter_program(calls.front().program);
    });
}

}  // namespace gsim::simulation
