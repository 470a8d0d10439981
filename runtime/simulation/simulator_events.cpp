// What happens between the moves of a program.

#include <utility>

#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

void Simulator::event(std::string kind, std::string detail, const Place& place, When when) {
    Event event{.place = place, .kind = std::move(kind), .detail = std::move(detail)};
    if (observer_ != nullptr) observer_->event(position_, event);
    if (when != When::at_rest)
        return events_.add_before(next_id_, std::move(event), when == When::with_motion);
    wait();
    events_.add(motion_->time_s(), std::move(event));
}

void Simulator::set_jet(bool on) {
    jet_ = on;
}

void Simulator::enter_program(std::string name, const Place& place) {
    if (observer_ != nullptr) observer_->enter_program(name);
    calls_.forget_before(recorder_.move().target_id);
    calls_.enter({std::move(name), place}, next_id_);
}

void Simulator::leave_program() {
    const bool open = calls_.any();
    calls_.leave(next_id_);
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
