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

void keep_ramps(const LawLimits& before, LawLimits& limits) {
    limits.acceleration = std::min(limits.acceleration, before.acceleration);
    limits.deceleration = std::min(limits.deceleration, before.deceleration);
}

}  // namespace

/// Remainder of an active move, and the law by which it would continue.
struct Planner::OnWay {
    PathMove move;
    double length = 0;  ///< By the measure of its lead.
    TimeLaw law;
    LawLimits limits;
    LimitedBy limited_by;

    bool is_held(const Overrides& overrides) const { return move.obeyed.share(overrides, move.rapid) <= 0; }
};

Overrides Planner::overrides_now() const {
    return setup_.overrides ? setup_.overrides->at(end_s_) : Overrides{};
}

/// Returns the share of the programmed speed for the next move; a hold has ended before it begins.
double Planner::share_now(const ObeyedOverrides& obeyed, bool rapid) const {
    const double share = obeyed.share(overrides_now(), rapid);
    return share > 0 ? share : 1;
}

void Planner::wait_out_hold(rrs::TargetId id, const rrs::JointPos& at, const ObeyedOverrides& obeyed,
                            bool rapid) {
    if (!setup_.overrides) return;
    const double free_s = setup_.overrides->free_s(end_s_, obeyed, rapid);
    if (!(free_s > end_s_)) return;
    Segment& rest = output_.begin(id);
    rest.kind = SegmentKind::rest;
    rest.start = rest.end = at;
    rest.reaches_target = false;
    plan_stay(rest, free_s - end_s_);
    if (tracked_) tracked_->frame.carry(rest);
    output_.finish();
}

/// Appends a motion from standstill to standstill to the queue, in parts if the operator changes an override
/// during it. The next motion is the first to obey if joints have laws of their own, or the complete motion
/// has a time.
void Planner::append_overridden(const PathMove& path, Segment& segment) {
    const bool whole = !setup_.overrides || tracked_ || !segment.followers().empty() ||
                       path.rules.least_duration_s > 0 ||
                       setup_.overrides->next_change_s(end_s_) >= segment.end_s();
    if (whole) return append(segment);
    OnWay on_way{path, segment.lead.length(), segment.lead, segment.lead_limits, segment.limited_by};
    on_way.move.length_mm = segment.length_mm;
    while (put_next_part(on_way)) {
    }
}

/// Outputs the part until the operator changes an override again, or stops the motion. Returns false if that
/// was the last part.
bool Planner::put_next_part(OnWay& on_way) {
    const Overrides now = overrides_now();
    double start_speed = on_way.law.start_speed();
    const bool held = on_way.is_held(now);
    if (held && start_speed <= kNoSpeed) {
        wait_out_hold(on_way.move.target_id, on_way.move.start, on_way.move.obeyed, on_way.move.rapid);
        plan_rest_of(on_way, 0);
        return true;
    }
    const TimeLaw law = held ? braking_law(on_way.law, 0, on_way.limits) : on_way.law;
    const double next_s = setup_.overrides->next_change_s(end_s_);
    const double turn_s =
        std::isinf(next_s) ? next_s : turning_s(law, std::max(next_s - end_s_, 0.0), on_way.limits.jerk);
    const double cut_s = std::min(turn_s, law.duration_s());
    const double done = cut_s < law.duration_s() ? law.at(cut_s).s : law.length();
    if (on_way.length - done <= kLeastPart) {
        put_part(on_way, law, law.duration_s());
        return false;
    }
    start_speed = cut_s < law.duration_s() ? law.at(cut_s).v : law.end_speed();
    put_part(on_way, law, cut_s);
    plan_rest_of(on_way, start_speed);
    return true;
}

void Planner::put_part(OnWay& on_way, const TimeLaw& law, double t_s) {
    const bool last = t_s >= law.duration_s() && law.length() >= on_way.length - kLeastPart;
    const double to = last ? on_way.length : law.at(t_s).s;
    Segment& segment = output_.begin(on_way.move.target_id);
    set_way(move_part(on_way.move, on_way.length, 0, to, setup_.position_joints), segment);
    segment.lead = law_until(law, t_s);
    segment.lead_limits = on_way.limits;
    segment.lead_limits.max_speed = std::max(on_way.limits.max_speed, segment.lead.peak_speed());
    segment.duration_s = segment.lead.duration_s();
    segment.limited_by = on_way.limited_by;
    output_.finish();
    if (last) return;
    on_way.move = move_part(on_way.move, on_way.length, to, on_way.length, setup_.position_joints);
    on_way.length -= to;
}

/// Plans the remainder of the path by the current overrides, from the speed that is reached.
void Planner::plan_rest_of(OnWay& on_way, double start_speed) {
    Segment rest;
    rest.position_joints = setup_.position_joints;
    set_way(on_way.move, rest);
    const MoveRules rules =
        on_way.move.rules.overridden(overrides_now(), on_way.move.obeyed, on_way.move.rapid);
    const bool arc = rest.kind == SegmentKind::circular;
    const auto setup = setup_on(on_way.move);
    if (setup && (arc ? plan_arc(**setup, rules, rest) : plan_line(**setup, rules, rest))) {
        // The move's own limits hold up to the speed that it was planned for.
        if (setup_.move_limits) keep_ramps(on_way.limits, rest.lead_limits);
        on_way.length = rest.lead.length();
        on_way.limits = rest.lead_limits;
        on_way.limited_by = rest.limited_by;
    }
    on_way.law = TimeLaw::between(on_way.length, start_speed, 0, on_way.limits);
}

}  // namespace gsim::motion
