// Operator overrides in LookAhead.

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/exact_stop/line_move.h"
#include "motion/lookahead/corner.h"
#include "motion/lookahead/look_ahead.h"
#include "motion/path/limited_way.h"
#include "motion/profile/law_cut.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

namespace {

constexpr double kWholeWay = 1e-12;  // relative

}  // namespace

/// Handles one action of the operator while the oldest block is active. Returns false if no action is left
/// before the remainder of the block can be output.
bool LookAhead::turn_overrides() {
    const double now_s = output_.time_s();
    take_overrides(now_s);
    if (is_held() && speed_ <= kNoSpeed) {
        put_out_hold(now_s);
        return true;
    }
    const Block& front = window_.front();
    const double way = front.way();
    if (!(way > kLeastPart) || front.steps) return false;
    const TimeLaw law =
        is_held() ? braking_law(way, speed_, speed_, front.limits()) : front_law(front_exit_speed());
    const bool stands_inside = is_held() && law.length() < way * (1 - kWholeWay);
    const double next_s = setup_.overrides->next_change_s(std::max(now_s, overrides_s_));
    const double turn_s = std::isinf(next_s) ? next_s : turning_s(law, next_s - now_s, front.jerk);
    if (turn_s < law.duration_s()) {
        const double done = law.at(turn_s).s;
        if (way - done <= kLeastPart) return false;
        if (done > kLeastPart) {
            put_out_part(law, turn_s);
        } else {
            take_overrides(next_s);
        }
        return true;
    }
    if (!stands_inside || way - law.length() <= kLeastPart) return false;
    if (law.length() > kLeastPart) {
        put_out_part(law, law.duration_s());
    } else {
        speed_ = 0;
    }
    return true;
}

/// Plans the window for the overrides of an instant.
void LookAhead::take_overrides(double now_s) {
    overrides_s_ = std::max(overrides_s_, now_s);
    const Overrides turned = setup_.overrides->at(overrides_s_);
    if (turned == overrides_) return;
    overrides_ = turned;
    std::vector<double> most;
    for (std::size_t i = 1; i < window_.size(); ++i)
        most.push_back(std::min(window_[i - 1].max_speed, window_[i].max_speed));
    for (Block& block : window_) limit_again(block);
    for (std::size_t i = 1; i < window_.size(); ++i) {
        Block& to = window_[i];
        const double shared = std::min(window_[i - 1].max_speed, to.max_speed);
        if (shared >= to.entry_cap) continue;
        to.entry_cap = shared;
        to.entry_limit = LimitKind::feed;
    }
    join_faster(most);
}

/// Rebuilds the paths of corners at which both blocks may now be faster than `most`. A longer blend leaves
/// less of its blocks for braking. All paths stay if the oldest block is too fast for that.
void LookAhead::join_faster(const std::vector<double>& most) {
    const std::deque<Block> before = window_;
    for (std::size_t i = 1; i < window_.size(); ++i) {
        Block& to = window_[i];
        if (std::min(window_[i - 1].max_speed, to.max_speed) > most[i - 1]) join(i, to);
    }
    plan_anew();
    if (window_.size() < 2 || least_exit() <= window_[1].entry) return;
    window_ = before;
    plan_anew();
}

void LookAhead::plan_anew() {
    planned_ = 0;
    if (!window_.empty()) plan_back(ending_ ? 0 : largest_exit_cut(setup_, window_.back()));
}

/// Sets the limits of a block under the current overrides. A block with curvature or many corners keeps the
/// acceleration that these leave at the higher speed.
void LookAhead::limit_again(Block& block) const {
    const auto again = setup_.move_limits ? limited_block_of(block.move, setup_, overrides_)
                                          : block_of(block.move, setup_, overrides_);
    if (!again || !*again) return;
    const Block& limits = **again;
    block.max_speed = limits.max_speed;
    block.speed_limit = limits.speed_limit;
    block.jerk = limits.jerk;
    block.jerk_limit = limits.jerk_limit;
    if (limits.acceleration > block.acceleration) return;
    block.acceleration = limits.acceleration;
    block.acceleration_limit = limits.acceleration_limit;
    block.deceleration = limits.deceleration;
}

/// True if the operator keeps the oldest block from continuing.
bool LookAhead::is_held() const {
    const PathMove& move = window_.front().move;
    return move.obeyed.share(overrides_, move.rapid) <= 0;
}

/// Returns the lowest speed at which the oldest block can end. It is above 0 if the block is entered faster
/// than it can brake. That was planned before the operator changed an override, so the corner allows it.
double LookAhead::least_exit() const {
    const Block& block = window_.front();
    if (window_.size() < 2 || !(speed_ > 0)) return 0;
    if (!(block.way() > 0)) return speed_;
    const TimeLaw law = braking_law(block.way(), speed_, speed_, block.limits());
    return law.length() < block.way() * (1 - kWholeWay) ? 0 : law.end_speed();
}

/// Returns the fastest law of the oldest block to its end. It brakes all along the path if it cannot be slow
/// enough there.
TimeLaw LookAhead::front_law(double exit_speed) const {
    const Block& block = window_.front();
    LawLimits limits = block.limits();
    limits.max_speed = std::max(limits.max_speed, exit_speed);
    return TimeLaw::between(block.way(), speed_, exit_speed, limits);
}

/// Outputs the motion of the oldest block by `law` until `t_s`; the remainder replaces the block.
void LookAhead::put_out_part(const TimeLaw& law, double t_s) {
    Block& front = window_.front();
    const double length = front.lead.length;
    const double from = front.entry_blend.cut;
    const double to = from + law.at(t_s).s;
    Segment& segment = output_.begin(front.move.target_id);
    set_way(move_part(front.move, length, from, to, setup_.position_joints), segment);
    segment.lead = law_until(law, t_s);
    segment.lead_limits = front.limits();
    segment.lead_limits.max_speed = std::max(front.max_speed, segment.lead.peak_speed());
    segment.duration_s = segment.lead.duration_s();
    segment.limited_by = limited_by(front, segment.lead, law.at(t_s).v);
    output_.finish();
    speed_ = t_s < law.duration_s() ? law.at(t_s).v : law.end_speed();
    front.move = move_part(front.move, length, to, length, setup_.position_joints);
    front.lead.length = length - to;
    front.entry_blend = {};
    if (const auto rest = block_of(front.move, setup_, overrides_); rest && *rest) {
        front.slope_in = (*rest)->slope_in;
        front.lead.length = (*rest)->lead.length;
    }
    plan_anew();
}

/// Outputs a dwell until the operator lets the machine continue.
void LookAhead::put_out_hold(double now_s) {
    const PathMove& move = window_.front().move;
    Segment& rest = output_.begin(move.target_id);
    rest.kind = SegmentKind::rest;
    rest.start = rest.end = window_.front().line_at(window_.front().entry_blend.cut);
    rest.reaches_target = false;
    plan_stay(rest, setup_.overrides->free_s(now_s, move.obeyed, move.rapid) - now_s);
    output_.finish();
    speed_ = 0;
}

}  // namespace gsim::motion
