#include "motion/klipper/klipper_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/klipper/junction.h"
#include "motion/klipper/speeds.h"
#include "motion/path/chords.h"
#include "motion/segment/followers.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

using klipper::QueuedMove;

namespace {

constexpr std::size_t kLeastToPlan = 64;
constexpr double kReachedSpeed = 1e-9;  // relative

LimitedBy limited_by(const QueuedMove& move, const TimeLaw& law) {
    if (law.peak_speed() >= move.max_speed * (1 - kReachedSpeed)) return move.speed_limit;
    if (law.start_speed() > kNoSpeed && law.end_speed() > kNoSpeed) return {LimitKind::corner, -1};
    return move.acceleration_limit;
}

}  // namespace

KlipperModel::KlipperModel(const PlannerSetup& setup, SegmentOutput& output)
    : setup_(setup), output_(output), plan_at_(kLeastToPlan) {}

Planned KlipperModel::add(const PathMove& move) {
    if (move.kind != SegmentKind::circular) return add_line(move);
    if (!(setup_.controller.arc_resolution_mm > 0)) {
        return refused(rrs::Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
                       "This controller knows no arcs: its arc_resolution_mm is 0.");
    }
    Planned planned;
    for_each_chord(move, setup_, [&](const PathMove& line) {
        if (planned) planned = add_line(line);
    });
    return planned;
}

/// A plan checks all pending moves. So it waits until as many have come as the last plan left.
Planned KlipperModel::add_line(const PathMove& line) {
    auto move = klipper::queued_move(setup_, line);
    if (!move) return tl::unexpected(std::move(move.error()));
    if (!(move->length > 0)) {
        reach_with_last(line);
        return {};
    }
    if (!queue_.empty()) klipper::join(setup_, queue_.back(), *move);
    queue_.push_back(*std::move(move));
    if (queue_.size() < plan_at_) return {};
    put_out(klipper::plan_speeds(queue_, top_before_));
    plan_at_ = std::max(2 * queue_.size(), kLeastToPlan);
    return {};
}

/// The last chord of an arc may have no length.
void KlipperModel::reach_with_last(const PathMove& line) {
    if (queue_.empty() || queue_.back().target_id != line.target_id) return;
    queue_.back().reaches_target = line.reaches_target;
}

void KlipperModel::come_to_rest() {
    klipper::plan_speeds(queue_, top_before_);
    put_out(queue_.size());
    top_before_ = speed_ = 0;
    plan_at_ = kLeastToPlan;
}

void KlipperModel::clear() {
    queue_.clear();
    top_before_ = speed_ = 0;
    plan_at_ = kLeastToPlan;
}

void KlipperModel::put_out(std::size_t count) {
    for (; count > 0; --count) {
        const QueuedMove& move = queue_.front();
        const double exit = queue_.size() > 1 ? std::min(queue_[1].full.entry, move.top) : 0;
        put_out(move, std::sqrt(exit));
        top_before_ = move.top;
        queue_.pop_front();
    }
}

void KlipperModel::put_out(const QueuedMove& move, double exit_speed) {
    Segment& segment = output_.begin(move.target_id);
    segment.kind = SegmentKind::linear;
    segment.start = move.start;
    segment.end = move.end;
    segment.length_mm = move.length_mm;
    segment.reaches_target = move.reaches_target;
    segment.lead_limits = {std::sqrt(move.top), move.acceleration, move.acceleration, kUnlimited};
    segment.lead = TimeLaw::between(move.length, speed_, exit_speed, segment.lead_limits);
    segment.lead_limits.max_speed = std::max(move.max_speed, segment.lead.peak_speed());
    segment.duration_s = segment.lead.duration_s();
    segment.limited_by = limited_by(move, segment.lead);
    output_.finish();
    speed_ = exit_speed;
}

}  // namespace gsim::motion
