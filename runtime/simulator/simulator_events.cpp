// Events between the moves of a program.

#include <utility>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

void Simulator::event(std::string kind, std::string detail, const SourceLocation& location,
                      EventTiming timing) {
    Event event{.location = location, .kind = std::move(kind), .detail = std::move(detail)};
    if (observer_ != nullptr) observer_->event(position_, event, timing == EventTiming::at_standstill);
    if (timing != EventTiming::at_standstill)
        return events_.add_before(next_id_, std::move(event), timing == EventTiming::with_motion);
    motion_->plan_to_standstill(true);
    events_.add(motion_->time_s(), std::move(event));
}

void Simulator::wait() {
    if (observer_ != nullptr) observer_->standstill(position_);
    motion_->plan_to_standstill(true);
}

void Simulator::set_spindle_speed(double rev_min) {
    if (observer_ != nullptr) observer_->spindle_speed(position_, rev_min);
}

void Simulator::set_process(bool on, bool with_motion) {
    ++process_switches_;
    if (with_motion) {
        process_with_motion_ = on;
    } else {
        process_on_ = on;
    }
}

void Simulator::set_observer(ProgramObserver& observer) {
    observer_ = &observer;
    if (selected_offset_) observer.work_offset(*selected_offset_);
}

/// A spindle may turn until the end stops it.
void Simulator::end_program(const SourceLocation& location) {
    const bool turns = machine_.process && machine_.process->kind == machine::ProcessKind::spindle;
    if (process_on_ && !turns) process_.end_program(next_id_, location);
    process_on_ = false;
    process_with_motion_.reset();
}

void Simulator::enter_program(std::string name, const SourceLocation& location) {
    if (observer_ != nullptr) observer_->enter_program(name);
    open_program(name);
    calls_.discard_before(recorder_.move().target_id);
    calls_.enter({std::move(name), location}, next_id_);
}

void Simulator::leave_program() {
    const bool open = calls_.any();
    calls_.leave(next_id_);
    if (!open_programs_.empty()) open_programs_.pop_back();
    if (open && observer_ != nullptr) observer_->leave_program();
}

void Simulator::repeat_program() {
    if (observer_ == nullptr) return;
    const std::vector<OpenCall> calls = calls_.now();
    if (calls.empty()) return;
    observer_->leave_program();
    observer_->enter_program(calls.front().program);
}

}  // namespace gsim::simulation
