#include "motion/planner/active_machine.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gsim::motion {

using rrs::Status;

namespace {

PlannerSetup validated(PlannerSetup setup) {
    if (auto error = setup.validate()) throw std::invalid_argument(*error);
    return setup;
}

}  // namespace

int slide_count(const PlannerSetup& setup) {
    return static_cast<int>(std::count_if(setup.position_joints.begin(), setup.position_joints.end(),
                                          [](int joint) { return joint >= 0; }));
}

ActiveMachine::ActiveMachine(PlannerSetup setup)
    : original_(validated(std::move(setup))), setup_(original_), axis_space_(AxisSpace::of(setup_)) {}

// The models refer to setup_; their pending moves keep the limits that they were given.
void ActiveMachine::use(const MoveParameters& move_parameters) {
    if (move_parameters.machine == used_machine_ && move_parameters.ramps == used_ramps_) return;
    used_machine_ = move_parameters.machine;
    used_ramps_ = move_parameters.ramps;
    setup_ = move_parameters.machine ? *move_parameters.machine : original_;
    if (move_parameters.ramps) activate_ramps(*move_parameters.ramps, original_, setup_);
}

void ActiveMachine::restart() {
    setup_ = original_;
    used_machine_.reset();
    used_ramps_.reset();
}

PlanResult ActiveMachine::check_ramps() const {
    if (original_.controller.capabilities().accepts_programmed_ramps) return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "This controller has separate ramps, which a program cannot change.");
}

PlanResult ActiveMachine::check_tcp_control() const {
    if (slide_count(setup_) >= 3) return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "TCP control needs the linear axes X, Y and Z, which this machine does not have.");
}

}  // namespace gsim::motion
