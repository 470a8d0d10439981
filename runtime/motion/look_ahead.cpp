#include "runtime/motion/look_ahead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/motion/chords.h"
#include "runtime/motion/corner.h"
#include "runtime/motion/followers.h"
#include "runtime/motion/line_move.h"
#include "runtime/motion/ramp.h"

namespace gsim::motion {

namespace {

constexpr double kSameSpeed = 1e-9;  // relative

rrs::JointPos on_grid(const PlannerSetup& setup, rrs::JointPos position) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double step = setup.joints[static_cast<std::size_t>(joint)].step;
        if (step > 0) position[joint] = std::round(position[joint] / step) * step;
    }
    return position;
}

}  // namespace

Planned LookAhead::add(const Move& move) {
    const bool chords = move.kind == SegmentKind::circular && setup_.controller.arc_chord_tolerance_mm > 0;
    if (!chords) return add_line(move);
    Planned planned;
    for_each_chord(move, setup_, [&](const Move& line) {
        if (planned) planned = add_line(line);
    });
    return planned;
}

/// Controllers that know lines alone count steps: they plan from step to step, so that short blocks have ends
/// off their line.
Planned LookAhead::add_line(const Move& move) {
    if (setup_.controller.arc_chord_tolerance_mm <= 0) return add_block(move);
    Move line = move;
    line.start = has_rounded_ ? rounded_ : on_grid(setup_, move.start);
    line.end = on_grid(setup_, move.end);
    Planned planned = add_block(line);
    if (planned) {
        rounded_ = line.end;
        has_rounded_ = true;
    }
    return planned;
}

Planned LookAhead::add_block(const Move& move) {
    auto block = block_of(move, setup_);
    if (!block) return tl::unexpected(std::move(block.error()));
    if (!*block) return {};
    if (!window_.empty()) {
        const CornerSpeed corner = corner_speed(setup_, window_.back(), **block);
        (*block)->entry_cap = corner.speed;
        (*block)->entry_limit = corner.limit;
    }
    window_.push_back(*std::move(*block));
    plan_back();
    if (window_.size() >= std::max<std::size_t>(setup_.controller.look_ahead_blocks, 1)) put_out_front();
    return {};
}

/// From the newest block, which ends at rest, back to the first one that gains nothing.
void LookAhead::plan_back() {
    double exit_speed = 0;
    bool by_window = true;
    for (std::size_t i = window_.size() - 1; i > 0; --i) {
        Block& block = window_[i];
        const double reachable =
            reachable_speed(block.lead.length, exit_speed, block.deceleration, block.jerk);
        const bool corner = block.entry_cap <= reachable;
        const double entry = corner ? block.entry_cap : reachable;
        by_window = by_window && !corner;
        if (entry <= block.entry && by_window == block.by_window && i + 1 < window_.size()) return;
        block.entry = entry;
        block.by_window = by_window;
        exit_speed = entry;
    }
}

/// The oldest block ends at the speed at which the next one begins, as far as it can reach it.
void LookAhead::put_out_front() {
    const Block& block = window_.front();
    const double length = block.lead.length;
    const double planned = window_.size() > 1 ? window_[1].entry : 0;
    const double exit = std::min(planned, reachable_speed(length, speed_, block.acceleration, block.jerk));
    const double settle_s = exit == 0 && block.move.mode == rrs::PathMode::exact_stop ? block.settle_s : 0;
    Segment& segment = output_.begin(block.move.target_id);
    segment.kind = block.move.kind;
    segment.start = block.move.start;
    segment.end = block.move.end;
    segment.arc = block.move.arc;
    segment.orientation = block.move.orientation;
    segment.length_mm = block.move.length_mm;
    segment.reaches_target = block.move.reaches_target && settle_s <= 0;
    segment.lead = TimeLaw::between(length, speed_, exit, block.limits());
    segment.lead_limits = block.limits();
    segment.duration_s = segment.lead.duration_s();
    segment.limited_by = limited_by(block, segment.lead, exit);
    const rrs::TargetId id = block.move.target_id;
    const rrs::JointPos end = block.move.end;
    output_.finish();
    window_.pop_front();
    speed_ = exit;
    if (settle_s > 0) put_out_rest(id, end, settle_s);
}

void LookAhead::put_out_rest(rrs::TargetId id, const rrs::JointPos& end, double settle_s) {
    Segment& rest = output_.begin(id);
    rest.kind = SegmentKind::rest;
    rest.start = rest.end = end;
    plan_stay(rest, settle_s);
    output_.finish();
}

LimitedBy LookAhead::limited_by(const Block& block, const TimeLaw& law, double exit_speed) const {
    if (law.peak_speed() >= block.max_speed * (1 - kSameSpeed)) return block.speed_limit;
    const Block* next = window_.size() > 1 ? &window_[1] : nullptr;
    if (next != nullptr && next->by_window) return {LimitKind::look_ahead, -1};
    const bool slow_corner = speed_ > 0 && exit_speed > 0;
    if (slow_corner && next != nullptr && next->entry_limit == LimitKind::corner)
        return {LimitKind::corner, -1};
    return limit_reached(law, block.limits(), block.speed_limit, block.acceleration_limit, block.jerk_limit);
}

void LookAhead::come_to_rest() {
    while (!window_.empty()) put_out_front();
    speed_ = 0;
}

void LookAhead::clear() {
    window_.clear();
    speed_ = 0;
    has_rounded_ = false;
}

}  // namespace gsim::motion
