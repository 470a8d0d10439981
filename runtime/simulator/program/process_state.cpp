#include "runtime/simulator/program/process_state.h"

#include <utility>

namespace gsim::simulation {

ProcessState::ProcessState(const machine::Machine& machine, Recorder& recorder, const TargetIds& ids)
    : machine_(machine), ids_(ids), monitor_(machine) {
    recorder.add_output(monitor_);
}

void ProcessState::set(bool on, bool with_motion) {
    ++switches_;
    if (with_motion) {
        on_with_motion_ = on;
    } else {
        on_ = on;
    }
}

void ProcessState::begin_move(MoveInfo& info) {
    if (info.kind != MoveKind::dwell && on_with_motion_) on_ = *std::exchange(on_with_motion_, std::nullopt);
    info.process_on = on_;
    info.switches = switches_;
}

/// A spindle may turn until the end stops it.
void ProcessState::end_program(const SourceLocation& location) {
    const bool turns = machine_.process && machine_.process->kind == machine::ProcessKind::spindle;
    if (on_ && !turns) monitor_.end_program(ids_.next(), location);
    on_ = false;
    on_with_motion_.reset();
}

void ProcessState::end_run() {
    if (on_) monitor_.end_program(ids_.next(), ids_.last_location());
}

}  // namespace gsim::simulation
