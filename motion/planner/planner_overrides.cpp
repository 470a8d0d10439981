// Operator overrides of Planner in motion from standstill to standstill. Models follow them themselves.

#include <algorithm>
#include <cmath>

#include "motion/exact_stop/arc_move.h"
#include "motion/exact_stop/line_move.h"
#include "motion/planner/planner.h"
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
struct Planner::ActiveMove {
    PathMove move;
    double length = 0;  ///< By the measure of its lead.
    TimeLaw law;
    LawLimits limits;
    LimitedBy limited_by;

    bool is_on_hold(const Overrides& overrides) const {
        return move.enabled_overrides.share(overrides, move.rapid) <= 0;
    }
};

Overrides Planner::current_overrides() const {
    return setup_.overrides ? setup_.overrides->at(end_s_) : Overrides{};
}

/// Returns the share of the programmed speed for the next move; a hold has ended before it begins.
double Planner::current_override_share(const EnabledOverrides& enabled_overrides, bool rapid) const {
    const double share = enabled_overrides.share(current_overrides(), rapid);
    return share > 0 ? share : 1;
}

void Planner::wait_out_hold(rrs::TargetId id, const rrs::JointPos& at,
                            const EnabledOverrides& enabled_overrides, bool rapid) {
    if (!setup_.overrides) return;
    const double release_time_s = setup_.overrides->release_time_s(end_s_, enabled_overrides, rapid);
    if (!(release_time_s > end_s_)) return;
    Segment& standstill = output_.begin(id);
    standstill.kind = SegmentKind::rest;
    standstill.start = standstill.end = at;
    standstill.reaches_target = false;
    plan_standstill(standstill, release_time_s - end_s_);
    if (tracking_) tracking_->frame.superimpose(standstill);
    output_.finish();
}

/// Appends a motion from standstill to standstill to the queue, in parts if the operator changes an override
/// during it. The next motion is the first to obey if joints have laws of their own, or the complete motion
/// has a time.
void Planner::append_overridden(const PathMove& path, Segment& segment) {
    const bool append_unchanged = !setup_.overrides || tracking_ || !segment.followers().empty() ||
                                  path.rules.min_duration_s > 0 ||
                                  setup_.overrides->next_change_s(end_s_) >= segment.end_s();
    if (append_unchanged) return append(segment);
    ActiveMove active_move{path, segment.master.length(), segment.master, segment.master_limits,
                           segment.limited_by};
    active_move.move.length_mm = segment.length_mm;
    while (emit_next_part(active_move)) {
    }
}

/// Outputs the part until the operator changes an override again, or stops the motion. Returns false if that
/// was the last part.
bool Planner::emit_next_part(ActiveMove& active_move) {
    const Overrides now = current_overrides();
    double start_speed = active_move.law.start_speed();
    const bool on_hold = active_move.is_on_hold(now);
    if (on_hold && start_speed <= kStandstillTolerance) {
        wait_out_hold(active_move.move.target_id, active_move.move.start, active_move.move.enabled_overrides,
                      active_move.move.rapid);
        plan_remainder(active_move, 0);
        return true;
    }
    const TimeLaw law = on_hold ? braking_law(active_move.law, 0, active_move.limits) : active_move.law;
    const double next_s = setup_.overrides->next_change_s(end_s_);
    const double change_time_s =
        std::isinf(next_s) ? next_s
                           : switchable_s(law, std::max(next_s - end_s_, 0.0), active_move.limits.jerk);
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

void Planner::emit_part(ActiveMove& active_move, const TimeLaw& law, double t_s) {
    const bool last = t_s >= law.duration_s() && law.length() >= active_move.length - kMinPart;
    const double to = last ? active_move.length : law.at(t_s).s;
    Segment& segment = output_.begin(active_move.move.target_id);
    set_path(move_part(active_move.move, active_move.length, 0, to, setup_.position_joints), segment);
    segment.master = law_until(law, t_s);
    segment.master_limits = active_move.limits;
    segment.master_limits.max_speed = std::max(active_move.limits.max_speed, segment.master.peak_speed());
    segment.duration_s = segment.master.duration_s();
    segment.limited_by = active_move.limited_by;
    output_.finish();
    if (last) return;
    active_move.move =
        move_part(active_move.move, active_move.length, to, active_move.length, setup_.position_joints);
    active_move.length -= to;
}

/// Plans the remainder of the path by the current overrides, from the speed that is reached.
void Planner::plan_remainder(ActiveMove& active_move, double start_speed) {
    Segment standstill;
    standstill.position_joints = setup_.position_joints;
    set_path(active_move.move, standstill);
    const MoveRules rules = active_move.move.rules.with_overrides(
        current_overrides(), active_move.move.enabled_overrides, active_move.move.rapid);
    const bool arc = standstill.kind == SegmentKind::circular;
    const auto setup = setup_for_move(active_move.move);
    if (setup && (arc ? plan_arc(**setup, rules, standstill) : plan_line(**setup, rules, standstill))) {
        // The move's own limits hold up to the speed that it was planned for.
        if (setup_.move_limits) cap_ramps(active_move.limits, standstill.master_limits);
        active_move.length = standstill.master.length();
        active_move.limits = standstill.master_limits;
        active_move.limited_by = standstill.limited_by;
    }
    active_move.law = TimeLaw::between(active_move.length, start_speed, 0, active_move.limits);
}

}  // namespace gsim::motion
