#include "motion/lookahead/look_ahead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/exact_stop/line_move.h"
#include "motion/lookahead/blend.h"
#include "motion/lookahead/corner.h"
#include "motion/lookahead/corner_window.h"
#include "motion/path/chords.h"
#include "motion/path/limited_path.h"
#include "motion/profile/ramp.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

constexpr double kBlockSpeedTolerance = 1e-9;  // relative
constexpr std::size_t kMaxInnerSubSegments = 2'000;

bool continues_move(const Block& block) {
    return block.move.sub_segment && !block.move.reaches_target;
}

rrs::JointPos snap_to_grid(const PlannerSetup& setup, rrs::JointPos position) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double step = setup.joints[static_cast<std::size_t>(joint)].step;
        if (step > 0) position[joint] = std::round(position[joint] / step) * step;
    }
    return position;
}

}  // namespace

PlanResult LookAhead::add(const PathMove& move) {
    const bool uses_chords =
        move.kind == SegmentKind::circular && setup_.controller.curves.arc_chord_tolerance_mm > 0;
    if (!uses_chords) return add_line(move);
    PlanResult planned;
    for_each_chord(move, setup_, [&](const PathMove& line) {
        if (planned) planned = add_line(line);
    });
    return planned;
}

/// Controllers that know only lines count steps. They plan from step to step, so that short blocks have ends
/// off their line.
PlanResult LookAhead::add_line(const PathMove& move) {
    if (setup_.controller.curves.arc_chord_tolerance_mm <= 0) return add_block(move);
    PathMove line = move;
    if (has_rounded_end_) line.start = rounded_end_;
    line.end = snap_to_grid(setup_, move.end);
    PlanResult planned = add_block(line);
    if (planned) {
        rounded_end_ = line.end;
        has_rounded_end_ = true;
    }
    return planned;
}

PlanResult LookAhead::add_block(const PathMove& move) {
    if (setup_.overrides && window_.empty()) update_overrides(output_.time_s());
    auto block =
        setup_.move_limits ? limited_block(move, setup_, overrides_) : make_block(move, setup_, overrides_);
    if (!block) return tl::unexpected(std::move(block.error()));
    if (!*block) {
        mark_target_reached(move);
        return {};
    }
    if (!window_.empty()) join(window_.size(), **block);
    if (continues_move(**block)) ++inner_count_;
    window_.push_back(*std::move(*block));
    if (!is_window_full()) return {};
    if (!is_exit_known()) plan_backward(largest_exit_cut(setup_, window_.back()));
    emit_front_block();
    return {};
}

/// Rounding may remove the last chord of an arc.
void LookAhead::mark_target_reached(const PathMove& move) {
    if (window_.empty() || window_.back().move.target_id != move.target_id) return;
    window_.back().move.reaches_target = move.reaches_target;
}

/// Further blocks only raise planned speeds. So the end speed of the oldest block is final if it is the
/// highest that the corner allows or that the block can reach.
bool LookAhead::is_exit_known() const {
    if (window_.size() < 2) return true;
    const Block& next = window_[1];
    return next.entry >= next.entry_cap || next.entry > reachable_exit_speed();
}

bool LookAhead::is_window_full() const {
    const std::size_t max = std::max<std::size_t>(setup_.controller.blocks.look_ahead, 1);
    return window_.size() - inner_count_ >= max || inner_count_ >= kMaxInnerSubSegments;
}

/// Joins the first `count` blocks of the window and `to` at their corner.
void LookAhead::join(std::size_t count, Block& to) {
    Block& from = window_[count - 1];
    const PrecedingBlocks before{window_, count};
    const CornerSpeed corner =
        setup_.move_limits ? limited_corner_speed(before, to) : corner_speed(setup_, before, to);
    to.entry_cap = corner.speed;
    to.entry_limit = corner.limit;
    to.entry_blend = corner.blend;
    from.exit_cut = corner.blend.cut;
    if (!corner.uses_acceleration) return;
    if (to.corner_accelerations) {
        reserve_for_corners(setup_for_corner(setup_, *to.corner_accelerations), before, to);
    } else {
        reserve_for_corners(setup_, before, to);
    }
}

/// Returns the speed of a corner that has its own accelerations.
CornerSpeed LookAhead::limited_corner_speed(const PrecedingBlocks& before, Block& to) {
    to.corner_accelerations = corner_accelerations(setup_, before.back(), to);
    if (!to.corner_accelerations) return {};
    return corner_speed(setup_for_corner(setup_, *to.corner_accelerations), before, to);
}

/// Plans from the newest block, which stops `reserved_length` before its end, back to the first block that
/// was planned before and does not get faster.
void LookAhead::plan_backward(double reserved_length) {
    double exit_speed = 0;
    double distance = std::max(window_.back().distance() - reserved_length, 0.0);
    bool is_window_limited = true;
    for (std::size_t i = window_.size() - 1; i > 0; --i) {
        Block& block = window_[i];
        const double reachable = reachable_speed(distance, exit_speed, block.deceleration, block.jerk);
        const bool corner = block.entry_cap <= reachable;
        const double entry = corner ? block.entry_cap : reachable;
        is_window_limited = is_window_limited && !corner;
        if (i < planned_count_ && entry <= block.entry && is_window_limited == block.is_window_limited) break;
        block.entry = entry;
        block.is_window_limited = is_window_limited;
        exit_speed = entry;
        distance = window_[i - 1].distance();
    }
    planned_count_ = window_.size();
}

/// Returns the speed at which the next block begins, as far as the oldest one can reach it.
double LookAhead::front_exit_speed() const {
    const double planned = std::min(window_.size() > 1 ? window_[1].entry : 0, reachable_exit_speed());
    return setup_.overrides ? std::max(is_on_hold() ? 0 : planned, min_exit_speed()) : planned;
}

double LookAhead::reachable_exit_speed() const {
    const Block& block = window_.front();
    return reachable_speed(block.distance(), speed_, block.acceleration, block.jerk);
}

/// A stop may take less time than a slow blend if few blocks are known. The cut is long enough for that stop.
void LookAhead::drop_slow_blend() {
    if (window_.size() < 2) return;
    Block& from = window_[0];
    Block& to = window_[1];
    if (to.entry_blend.cut <= 0 || front_exit_speed() >= min_blend_speed(from, to)) return;
    if (setup_.overrides && min_exit_speed() > 0) return;
    to.entry_blend = {};
    to.entry = to.entry_cap = 0;
    to.entry_limit = LimitKind::stop;
    from.exit_cut = 0;
}

/// A slow blend needs a smaller cut, which leaves more of both lines for speeding up.
void LookAhead::shrink_blend(double speed) {
    if (window_.size() < 2 || window_[1].entry_blend.cut <= 0 || !(speed > 0)) return;
    Block& to = window_[1];
    to.entry_blend = to.corner_accelerations
                         ? blend_at(setup_for_corner(setup_, *to.corner_accelerations), window_[0], to, speed)
                         : blend_at(setup_, window_[0], to, speed);
    window_[0].exit_cut = window_[1].entry_blend.cut;
}

void LookAhead::emit_front_block() {
    if (setup_.overrides) {
        while (handle_override_change()) {
        }
    }
    drop_slow_blend();
    const double exit = front_exit_speed();
    shrink_blend(exit);
    const Block& block = window_.front();
    const bool blended = block.exit_cut > 0;
    const bool settles = exit == 0 && block.move.mode == rrs::PathMode::exact_stop;
    // The wait depends on the motion before it, which is output first.
    const bool may_wait =
        settles && (block.settling.fixed_s > 0 || std::isfinite(block.settling.in_position_mm));
    const bool reaches_target = block.move.reaches_target && !blended && !may_wait;
    if (block.steps) {
        emit_steps(block, exit, reaches_target);
    } else {
        emit_path(block, exit, reaches_target);
    }
    if (blended) {
        const Block& next = window_[1];
        emit_blend(block, next, exit, blend_limited_by(block, next, exit), output_);
    }
    if (may_wait) emit_dwell(block.move.target_id, block.move.end, settle_s(block));
    if (continues_move(block)) --inner_count_;
    window_.pop_front();
    planned_count_ = std::max<std::size_t>(planned_count_, 1) - 1;
    speed_ = exit;
}

void LookAhead::emit_path(const Block& block, double exit_speed, bool reaches_target) {
    const double distance = block.distance();
    if (!(distance > 0)) return;
    const double length = block.master.length;
    Segment& segment = output_.begin(block.move.target_id);
    segment.kind = block.move.kind;
    segment.start = block.entry_blend.cut > 0 ? block.line_at(block.entry_blend.cut) : block.move.start;
    segment.end = block.exit_cut > 0 ? block.line_at(length - block.exit_cut) : block.move.end;
    segment.arc = block.move.arc;
    segment.orientation = block.move.orientation;
    segment.length_mm = block.move.length_mm * (distance / length);
    segment.reaches_target = reaches_target;
    segment.master = front_law(exit_speed);
    segment.master_limits = block.limits();
    segment.master_limits.max_speed = std::max(block.max_speed, segment.master.peak_speed());
    segment.duration_s = segment.master.duration_s();
    segment.limited_by = limited_by(block, segment.master, exit_speed);
    output_.finish();
}

/// Returns the fixed time plus what the joint that is farthest out of its band needs.
double LookAhead::settle_s(const Block& block) const {
    double worst = 0;  // error over band
    for (int joint = 0; joint < setup_.joint_count(); ++joint) {
        const bool rotary = setup_.role(joint) == JointRole::rotary;
        const double band = rotary ? block.settling.in_position_rad : block.settling.in_position_mm;
        worst = std::max(worst, std::abs(block.slope_out[joint]) * output_.lag() / band);
    }
    if (!(worst > 1)) return block.settling.fixed_s;
    return block.settling.fixed_s + std::log(worst) / setup_.controller.position_loop.gain_1_s;
}

LimitCause LookAhead::blend_limited_by(const Block& from, const Block& to, double speed) const {
    const Block& slower = from.max_speed <= to.max_speed ? from : to;
    if (speed >= slower.max_speed * (1 - kBlockSpeedTolerance)) return slower.speed_limit;
    return {to.is_window_limited && speed >= to.entry ? LimitKind::look_ahead : LimitKind::corner, -1};
}

void LookAhead::emit_dwell(rrs::TargetId id, const rrs::JointPos& end, double settle_s) {
    Segment& standstill = output_.begin(id);
    standstill.kind = SegmentKind::rest;
    standstill.start = standstill.end = end;
    plan_standstill(standstill, settle_s);
    output_.finish();
}

LimitCause LookAhead::limited_by(const Block& block, const TimeLaw& law, double exit_speed) const {
    if (law.peak_speed() >= block.max_speed * (1 - kBlockSpeedTolerance)) return block.speed_limit;
    const Block* next = window_.size() > 1 ? &window_[1] : nullptr;
    if (next != nullptr && next->is_window_limited && exit_speed >= next->entry)
        return {LimitKind::look_ahead, -1};
    const bool slow_corner = speed_ > 0 && exit_speed > 0;
    if (slow_corner && next != nullptr && next->entry_limit == LimitKind::corner)
        return {LimitKind::corner, -1};
    return reached_limit(law, block.limits(), block.speed_limit, block.acceleration_limit, block.jerk_limit);
}

void LookAhead::plan_to_standstill() {
    if (!window_.empty()) plan_backward(0);
    is_ending_ = true;
    while (!window_.empty()) emit_front_block();
    is_ending_ = false;
    speed_ = 0;
}

rrs::JointPos LookAhead::end_position_of(const rrs::JointPos& position) const {
    return has_rounded_end_ ? rounded_end_ : position;
}

void LookAhead::clear() {
    window_.clear();
    overrides_ = {};
    overrides_s_ = 0;
    planned_count_ = 0;
    inner_count_ = 0;
    output_.clear();
    stepped_ramps_ = SteppedRamps(setup_.controller.ramps.step_s);
    speed_ = 0;
    has_rounded_end_ = false;
}

}  // namespace gsim::motion
