// Operator overrides in LookAhead.

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/exact_stop/line_move.h"
#include "motion/lookahead/corner.h"
#include "motion/lookahead/look_ahead.h"
#include "motion/path/limited_path.h"
#include "motion/profile/law_cut.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

namespace {

constexpr double kFullPathTolerance = 1e-12;  // relative

}  // namespace

/// Handles one action of the operator while the oldest block is active. Returns false if no action is left
/// before the remainder of the block can be output.
bool LookAhead::handle_override_change() {
    const double now_s = output_.time_s();
    update_overrides(now_s);
    if (is_on_hold() && speed_ <= kStandstillTolerance) {
        emit_hold(now_s);
        return true;
    }
    const Block& front = window_.front();
    const double distance = front.distance();
    if (!(distance > kMinPart) || front.steps) return false;
    const TimeLaw law =
        is_on_hold() ? braking_law(distance, speed_, speed_, front.limits()) : front_law(front_exit_speed());
    const bool stops_inside = is_on_hold() && law.length() < distance * (1 - kFullPathTolerance);
    const double next_s = setup_.overrides->next_change_s(std::max(now_s, overrides_s_));
    const double change_time_s = std::isinf(next_s) ? next_s : switchable_s(law, next_s - now_s, front.jerk);
    if (change_time_s < law.duration_s()) {
        const double done = law.at(change_time_s).s;
        if (distance - done <= kMinPart) return false;
        if (done > kMinPart) {
            emit_part(law, change_time_s);
        } else {
            update_overrides(next_s);
        }
        return true;
    }
    if (!stops_inside || distance - law.length() <= kMinPart) return false;
    if (law.length() > kMinPart) {
        emit_part(law, law.duration_s());
    } else {
        speed_ = 0;
    }
    return true;
}

/// Plans the window for the overrides of an instant.
void LookAhead::update_overrides(double now_s) {
    overrides_s_ = std::max(overrides_s_, now_s);
    const Overrides current_overrides = setup_.overrides->at(overrides_s_);
    if (current_overrides == overrides_) return;
    overrides_ = current_overrides;
    std::vector<double> speed_caps;
    for (std::size_t i = 1; i < window_.size(); ++i)
        speed_caps.push_back(std::min(window_[i - 1].max_speed, window_[i].max_speed));
    for (Block& block : window_) update_limits(block);
    for (std::size_t i = 1; i < window_.size(); ++i) {
        Block& to = window_[i];
        const double shared = std::min(window_[i - 1].max_speed, to.max_speed);
        if (shared >= to.entry_cap) continue;
        to.entry_cap = shared;
        to.entry_limit = LimitKind::feed;
    }
    rejoin_corners(speed_caps);
}

/// Rebuilds the paths of corners where both blocks may now be faster than in `speed_caps`. A longer blend
/// leaves less of its blocks for braking. All paths stay if the oldest block is too fast for that.
void LookAhead::rejoin_corners(const std::vector<double>& speed_caps) {
    const std::deque<Block> before = window_;
    for (std::size_t i = 1; i < window_.size(); ++i) {
        Block& to = window_[i];
        if (std::min(window_[i - 1].max_speed, to.max_speed) > speed_caps[i - 1]) join(i, to);
    }
    replan();
    if (window_.size() < 2 || min_exit_speed() <= window_[1].entry) return;
    window_ = before;
    replan();
}

void LookAhead::replan() {
    planned_count_ = 0;
    if (!window_.empty()) plan_backward(is_ending_ ? 0 : largest_exit_cut(setup_, window_.back()));
}

/// Sets the limits of a block under the current overrides. A block with curvature or many corners keeps the
/// acceleration that these leave at the higher speed.
void LookAhead::update_limits(Block& block) const {
    const auto replanned = setup_.move_limits ? limited_block(block.move, setup_, overrides_)
                                              : make_block(block.move, setup_, overrides_);
    if (!replanned || !*replanned) return;
    const Block& limits = **replanned;
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
bool LookAhead::is_on_hold() const {
    const PathMove& move = window_.front().move;
    return move.enabled_overrides.share(overrides_, move.rapid) <= 0;
}

/// Returns the lowest speed at which the oldest block can end. It is above 0 if the block is entered faster
/// than it can brake. That was planned before the operator changed an override, so the corner allows it.
double LookAhead::min_exit_speed() const {
    const Block& block = window_.front();
    if (window_.size() < 2 || !(speed_ > 0)) return 0;
    if (!(block.distance() > 0)) return speed_;
    const TimeLaw law = braking_law(block.distance(), speed_, speed_, block.limits());
    return law.length() < block.distance() * (1 - kFullPathTolerance) ? 0 : law.end_speed();
}

/// Returns the fastest law of the oldest block to its end. It brakes all along the path if it cannot be slow
/// enough there.
TimeLaw LookAhead::front_law(double exit_speed) const {
    const Block& block = window_.front();
    LawLimits limits = block.limits();
    limits.max_speed = std::max(limits.max_speed, exit_speed);
    return TimeLaw::between(block.distance(), speed_, exit_speed, limits);
}

/// Outputs the motion of the oldest block by `law` until `t_s`; the remainder replaces the block.
void LookAhead::emit_part(const TimeLaw& law, double t_s) {
    Block& front = window_.front();
    const double length = front.master.length;
    const double from = front.entry_blend.cut;
    const double to = from + law.at(t_s).s;
    Segment& segment = output_.begin(front.move.target_id);
    set_path(move_part(front.move, length, from, to, setup_.position_joints), segment);
    segment.master = law_until(law, t_s);
    segment.master_limits = front.limits();
    segment.master_limits.max_speed = std::max(front.max_speed, segment.master.peak_speed());
    segment.duration_s = segment.master.duration_s();
    segment.limited_by = limited_by(front, segment.master, law.at(t_s).v);
    output_.finish();
    speed_ = t_s < law.duration_s() ? law.at(t_s).v : law.end_speed();
    front.move = move_part(front.move, length, to, length, setup_.position_joints);
    front.master.length = length - to;
    front.entry_blend = {};
    if (const auto standstill = make_block(front.move, setup_, overrides_); standstill && *standstill) {
        front.slope_in = (*standstill)->slope_in;
        front.master.length = (*standstill)->master.length;
    }
    replan();
}

/// Outputs a dwell until the operator lets the machine continue.
void LookAhead::emit_hold(double now_s) {
    const PathMove& move = window_.front().move;
    Segment& standstill = output_.begin(move.target_id);
    standstill.kind = SegmentKind::rest;
    standstill.start = standstill.end = window_.front().line_at(window_.front().entry_blend.cut);
    standstill.reaches_target = false;
    plan_standstill(standstill,
                    setup_.overrides->release_time_s(now_s, move.enabled_overrides, move.rapid) - now_s);
    output_.finish();
    speed_ = 0;
}

}  // namespace gsim::motion
