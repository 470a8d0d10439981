#include "runtime/simulation/logging_motion.h"

namespace gsim::simulation {

LoggingMotion::LoggingMotion(std::unique_ptr<MotionSource> motion, MotionLog& log)
    : motion_(std::move(motion)), log_(log) {
    log_.start = motion_->position();
    if (motion_->sampled()) note_gap("its controller is a module");
}

void LoggingMotion::note_gap(const char* what) {
    if (log_.gap.empty()) log_.gap = what;
}

rrs::Shell& LoggingMotion::shell() {
    note_gap("it calls services of the controller");
    return motion_->shell();
}

bool LoggingMotion::set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) {
    note_gap("overrides are turned");
    return motion_->set_overrides(std::move(overrides));
}

motion::Planned LoggingMotion::start_at(const rrs::JointPos& joints) {
    auto stands = motion_->start_at(joints);
    log_.start = motion_->position();
    return stands;
}

motion::Put LoggingMotion::put(const motion::Move& move) {
    if (move.terms.machine) note_gap("it changes rules of the controller");
    auto put = motion_->put(move);
    if (put) log_.entries.emplace_back(move);
    return put;
}

motion::Put LoggingMotion::put_until(const motion::Move& move, const motion::StopSearch& search) {
    note_gap("it probes");
    return motion_->put_until(move, search);
}

motion::Planned LoggingMotion::put_own(const rrs::JointPos& end) {
    auto put = motion_->put_own(end);
    if (put) log_.entries.emplace_back(MotionLog::Own{end});
    return put;
}

motion::Planned LoggingMotion::put_rest(rrs::TargetId id, double rest_s) {
    auto put = motion_->put_rest(id, rest_s);
    if (put) log_.entries.emplace_back(MotionLog::Rest{id, rest_s});
    return put;
}

void LoggingMotion::come_to_rest(bool waits) {
    log_.entries.emplace_back(MotionLog::Stop{waits});
    motion_->come_to_rest(waits);
}

}  // namespace gsim::simulation
