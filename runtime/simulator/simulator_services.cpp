// Controller services in addition to the moves of a program.

#include "runtime/motion_sources/observed_motion.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr std::string_view kServiceMotion =
    "the script moves by services of the controller (SetNextTarget and its kin), which tell no path; use "
    "words "
    "such as G1, or move";

}  // namespace

Status Simulator::set_start(const std::function<Status()>& set) {
    if (time_s() > 0) return Status::RRS_INVALID_PARAMETER;
    const Status status = set();
    position_ = position_at(motion_->position());
    return status;
}

Status Simulator::queue_target(MoveKind kind, const SourceLocation& location,
                               const std::function<Status(rrs::TargetId)>& queue) {
    MoveInfo info = make_move_info(kind, location, 0);
    apply_override_rules(info, {});
    motion_->set_obeyed_overrides(info.enabled_overrides);
    recorder_.expect(info);
    const Status status = queue(info.target_id);
    position_ = position_at(motion_->position());
    if (observer_ != nullptr) observer_->on_unrecordable_motion(kServiceMotion);
    return status;
}

bool Simulator::set_overrides(const motion::OverrideSchedule& overrides) {
    overrides_ = overrides.changes();
    std::vector<motion::OverrideChange> active_overrides = overrides_;
    for (motion::OverrideChange& change : active_overrides) {
        if (change.at_s > 0) change.at_s += machine_.controller.overrides.delay_s;
    }
    return motion_->set_overrides(
        std::make_shared<const motion::OverrideSchedule>(std::move(active_overrides)));
}

void Simulator::observe_motion(MotionObserver& observer) {
    motion_ = std::make_unique<ObservedMotion>(std::move(motion_), observer);
    if (!overrides_.empty()) observer.on_unrecordable("overrides are turned");
}

/// A move in step with the spindle by its position ignores the feed override.
void Simulator::apply_override_rules(MoveInfo& info, const Feed& feed) const {
    info.follows_spindle = feed.linear_mm_rev.has_value();
    const bool is_synchronized = info.kind == MoveKind::thread && info.follows_spindle;
    const bool ignores_feed_override =
        info.kind == MoveKind::probe && !machine_.controller.overrides.override_probe_feed;
    info.enabled_overrides = {.feed = !locks_.feed && !is_synchronized && !ignores_feed_override,
                              .rapid = !locks_.rapid,
                              .spindle = info.follows_spindle && !locks_.spindle};
}

Status Simulator::cancel_motion() {
    const Status status = shell().CancelMotion();
    if (status == Status::RRS_SUCCESS) position_ = position_at(motion_->position());
    if (observer_ != nullptr) observer_->on_unrecordable_motion(kServiceMotion);
    return status;
}

}  // namespace gsim::simulation
