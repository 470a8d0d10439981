#include "runtime/motion_sources/observed_motion.h"

#include <utility>

namespace gsim::simulation {

ObservedMotion::ObservedMotion(std::unique_ptr<MotionSource> motion, MotionObserver& observer)
    : motion_(std::move(motion)), observer_(observer) {
    observer_.on_start_position(motion_->position());
    if (motion_->is_sampled()) observer_.on_unrecordable("its controller is a module");
}

rrs::Shell& ObservedMotion::shell() {
    observer_.on_unrecordable("it calls services of the controller");
    return motion_->shell();
}

bool ObservedMotion::set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) {
    observer_.on_unrecordable("overrides are changed");
    return motion_->set_overrides(std::move(overrides));
}

motion::PlanResult ObservedMotion::start_at(const rrs::JointPos& joints) {
    auto started = motion_->start_at(joints);
    observer_.on_start_position(motion_->position());
    return started;
}

motion::EnqueueResult ObservedMotion::enqueue(const motion::Move& move) {
    if (move.move_parameters.machine) observer_.on_unrecordable("it changes rules of the controller");
    auto enqueue = motion_->enqueue(move);
    if (enqueue) observer_.on_request(move);
    return enqueue;
}

motion::EnqueueResult ObservedMotion::enqueue_until(const motion::Move& move,
                                                    const motion::StopSearch& search) {
    observer_.on_unrecordable("it probes");
    return motion_->enqueue_until(move, search);
}

motion::PlanResult ObservedMotion::enqueue_independent(const rrs::JointPos& end) {
    auto enqueue = motion_->enqueue_independent(end);
    if (enqueue) observer_.on_request(IndependentMoveRequest{end});
    return enqueue;
}

motion::PlanResult ObservedMotion::enqueue_dwell(const DwellRequest& request) {
    auto enqueue = motion_->enqueue_dwell(request);
    if (enqueue) observer_.on_request(request);
    return enqueue;
}

void ObservedMotion::plan_to_standstill(bool waits) {
    observer_.on_request(StopRequest{waits});
    motion_->plan_to_standstill(waits);
}

void ObservedMotion::end_program() {
    observer_.ended();
    motion_->end_program();
}

}  // namespace gsim::simulation
