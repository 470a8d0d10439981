#include "motion/moves/operator_overrides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/exact_stop/arc_move.h"
#include "motion/exact_stop/line_move.h"
#include "motion/path/limited_path.h"
#include "motion/profile/law_cut.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

namespace {

void cap_ramps(const LawLimits& before, LawLimits& limits) {
    limits.acceleration = std::min(limits.acceleration, before.acceleration);
    limits.deceleration = std::min(limits.deceleration, before.deceleration);
}

}  // namespace

/// Remainder of an active move, and the law by which it would continue.
struct OperatorOverrides::ActiveMove {
    PathMove move;
    double length = 0;  ///< By the measure of its master law.
    TimeLaw law;
    LawLimits limits;
    LimitCause limited_by;

    bool is_on_hold(const Overrides& overrides) const {
        return move.enabled_overrides.share(overrides, move.rapid) <= 0;
    }
};

Overrides OperatorOverrides::current() const {
    const auto& schedule = machine_.setup().overrides;
    return schedule ? schedule->at(timeline_.time_s()) : Overrides{};
}

double OperatorOverrides::current_share(const EnabledOverrides& enabled_overrides, bool rapid) const {
    const double share = enabled_overrides.share(current(), rapid);
    return share > 0 ? share : 1;
}

void OperatorOverrides::wait_out_hold(rrs::TargetId id, const rrs::JointPos& position,
                                      const EnabledOverrides& enabled_overrides, bool rapid) {
    const auto& schedule = machine_.setup().overrides;
    if (!schedule) return;
    const double now_s = timeline_.time_s();
    const double release_time_s = schedule->release_time_s(now_s, enabled_overrides, rapid);
    if (!(release_time_s > now_s)) return;
    Segment& standstill = timeline_.begin(id);
    standstill.kind = SegmentKind::rest;
    standstill.start = standstill.end = position;
    standstill.reaches_target = false;
    plan_standstill(standstill, release_time_s - now_s);
    tracked_frame_.superimpose(standstill);
    timeline_.finish();
}

tl::expected<const PlannerSetup*, PlanError> OperatorOverrides::setup_for_move(const PathMove& path) {
    if (!machine_.setup().move_limits) return &tracked_frame_.setup_for_motion();
    auto limited = setup_for_path(path, machine_.setup(), current());
    if (!limited) return tl::unexpected(std::move(limited.error()));
    limited_setup_ = *std::move(limited);
    return &limited_setup_;
}

void OperatorOverrides::finish(const PathMove& path, Segment& segment) {
    const auto& schedule = machine_.setup().overrides;
    const bool unchanged = !schedule || tracked_frame_.is_active() || !segment.followers().empty() ||
                           path.rules.min_duration_s > 0 ||
                           schedule->next_change_s(timeline_.time_s()) >= segment.end_s();
    if (unchanged) return timeline_.finish();
    ActiveMove active_move{path, segment.master.length(), segment.master, segment.master_limits,
                           segment.limited_by};
    active_move.move.length_mm = segment.length_mm;
    while (emit_next_part(active_move)) {
    }
}

/// Outputs the part until the operator changes an override again, or stops the motion. Returns false if that
/// was the last part.
bool OperatorOverrides::emit_next_part(ActiveMove& active_move) {
    const double now_s = timeline_.time_s();
    double start_speed = active_move.law.start_speed();
    const bool on_hold = active_move.is_on_hold(current());
    if (on_hold && start_speed <= kStandstillTolerance) {
        wait_out_hold(active_move.move.target_id, active_move.move.start, active_move.move.enabled_overrides,
                      active_move.move.rapid);
        plan_remainder(active_move, 0);
        return true;
    }
    const TimeLaw law = on_hold ? braking_law(active_move.law, 0, active_move.limits) : active_move.law;
    const double next_s = machine_.setup().overrides->next_change_s(now_s);
    const double change_time_s =
        std::isinf(next_s) ? next_s
                           : switchable_s(law, std::max(next_s - now_s, 0.0), active_move.limits.jerk);
    const double cut_s = std::min(change_time_s, law.duration_s());
    const double done = cut_s < law.duration_s() ? law.at(cut_s).s : law.length();
    if (active_move.length - done <= kMinPart) {
        emit_part(active_move, law, law.duration_s());
        return false;
    }
    start_speed = cut_s < law.duration_s() ? law.at(cut_s).v : law.end_speed();
    emit_part(active_move, law, cut_s);
    plan_remainder(active_move, start_speed);
    return true;
}

void OperatorOverrides::emit_part(ActiveMove& active_move, const TimeLaw& law, double t_s) {
    const bool last = t_s >= law.duration_s() && law.length() >= active_move.length - kMinPart;
    const double to = last ? active_move.length : law.at(t_s).s;
    Segment& segment = timeline_.begin(active_move.move.target_id);
    set_path(move_part(active_move.move, active_move.length, 0, to, machine_.setup().position_joints),
             segment);
    segment.master = law_until(law, t_s);
    segment.master_limits = active_move.limits;
    segment.master_limits.max_speed = std::max(active_move.limits.max_speed, segment.master.peak_speed());
    segment.duration_s = segment.master.duration_s();
    segment.limited_by = active_move.limited_by;
    timeline_.finish();
    if (last) return;
    active_move.move = move_part(active_move.move, active_move.length, to, active_move.length,
                                 machine_.setup().position_joints);
    active_move.length -= to;
}

/// Plans the remainder of the path by the current overrides, from the speed that is reached.
void OperatorOverrides::plan_remainder(ActiveMove& active_move, double start_speed) {
    Segment standstill;
    standstill.position_joints = machine_.setup().position_joints;
    set_path(active_move.move, standstill);
    const MoveRules rules = active_move.move.rules.with_overrides(
        current(), active_move.move.enabled_overrides, active_move.move.rapid);
    const bool arc = standstill.kind == SegmentKind::circular;
    const auto setup = setup_for_move(active_move.move);
    if (setup && (arc ? plan_arc(**setup, rules, standstill) : plan_line(**setup, rules, standstill))) {
        // The move's own limits hold up to the speed that it was planned for.
        if (machine_.setup().move_limits) cap_ramps(active_move.limits, standstill.master_limits);
        active_move.length = standstill.master.length();
        active_move.limits = standstill.master_limits;
        active_move.limited_by = standstill.limited_by;
    }
    active_move.law = TimeLaw::between(active_move.length, start_speed, 0, active_move.limits);
}

}  // namespace gsim::motion
