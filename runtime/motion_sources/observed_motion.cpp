#include "runtime/motion_sources/observed_motion.h"

#include <utility>

namespace gsim::simulation {

ObservedMotion::ObservedMotion(std::unique_ptr<MotionSource> motion, MotionObserver& observer)
    : motion_(std::move(motion)), observer_(observer) {
    observer_.stands_at(motion_->position());
    if (motion_->sampled()) observer_.untold("its controller is a module");
}

rrs::Shell& ObservedMotion::shell() {
    observer_.untold("it calls services of the controller");
    return motion_->shell();
}

bool ObservedMotion::set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) {
    observer_.untold("overrides are turned");
    return motion_->set_overrides(std::move(overrides));
}

motion::Planned ObservedMotion::start_at(const rrs::JointPos& joints) {
    auto stands = motion_->start_at(joints);
    observer_.stands_at(motion_->position());
    return stands;
}

motion::Put ObservedMotion::put(const motion::Move& move) {
    if (move.terms.machine) observer_.untold("it changes rules of the controller");
    auto put = motion_->put(move);
    if (put) observer_.asked(move);
    return put;
}

motion::Put ObservedMotion::put_until(const motion::Move& move, const motion::StopSearch& search) {
    observer_.untold("it probes");
    return motion_->put_until(move, search);
}

motion::Planned ObservedMotion::put_own(const rrs::JointPos& end) {
    auto put = motion_->put_own(end);
    if (put) observer_.asked(AskedOwn{end});
    return put;
}

motion::Planned ObservedMotion::put_rest(const AskedRest& rest) {
    auto put = motion_->put_rest(rest);
    if (put) observer_.asked(rest);
    return put;
}

void ObservedMotion::come_to_rest(bool waits) {
    observer_.asked(AskedStop{waits});
    motion_->come_to_rest(waits);
}

void ObservedMotion::end_program() {
    observer_.ended();
    motion_->end_program();
}

}  // namespace gsim::simulation
