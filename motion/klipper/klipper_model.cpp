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

constexpr std::size_t kMinMovesToPlan = 64;
constexpr double kSpeedTolerance = 1e-9;  // relative

LimitCause limited_by(const QueuedMove& move, const TimeLaw& law) {
    if (law.peak_speed() >= move.max_speed * (1 - kSpeedTolerance)) return move.speed_limit;
    if (law.start_speed() > kStandstillTolerance && law.end_speed() > kStandstillTolerance)
        return {LimitKind::corner, -1};
    return move.acceleration_limit;
}

}  // namespace

KlipperModel::KlipperModel(const PlannerSetup& setup, SegmentOutput& output)
    : setup_(setup), output_(output), next_plan_size_(kMinMovesToPlan) {}

PlanResult KlipperModel::add(const PathMove& move) {
    if (move.kind != SegmentKind::circular) return add_line(move);
    if (!(setup_.controller.klipper.arc_resolution_mm > 0)) {
        return make_plan_error(rrs::Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
                               "This controller does not support arcs: its arc_resolution_mm is 0.");
    }
    PlanResult planned;
    for_each_chord(move, setup_, [&](const PathMove& line) {
        if (planned) planned = add_line(line);
    });
    return planned;
}

/// A plan checks all pending moves. So it waits until as many have come as the last plan left.
PlanResult KlipperModel::add_line(const PathMove& line) {
    auto move = klipper::queued_move(setup_, line);
    if (!move) return tl::unexpected(std::move(move.error()));
    if (!(move->length > 0)) {
        mark_target_reached(line);
        return {};
    }
    if (!queue_.empty()) klipper::join(setup_, queue_.back(), *move);
    queue_.push_back(*std::move(move));
    if (queue_.size() < next_plan_size_) return {};
    emit(klipper::plan_speeds(queue_, last_cruise_squared_));
    next_plan_size_ = std::max(2 * queue_.size(), kMinMovesToPlan);
    return {};
}

/// The last chord of an arc may have no length.
void KlipperModel::mark_target_reached(const PathMove& line) {
    if (queue_.empty() || queue_.back().target_id != line.target_id) return;
    queue_.back().reaches_target = line.reaches_target;
}

void KlipperModel::plan_to_standstill() {
    klipper::plan_speeds(queue_, last_cruise_squared_);
    emit(queue_.size());
    last_cruise_squared_ = speed_ = 0;
    next_plan_size_ = kMinMovesToPlan;
}

void KlipperModel::clear() {
    queue_.clear();
    last_cruise_squared_ = speed_ = 0;
    next_plan_size_ = kMinMovesToPlan;
}

void KlipperModel::emit(std::size_t count) {
    for (; count > 0; --count) {
        const QueuedMove& move = queue_.front();
        const double exit =
            queue_.size() > 1 ? std::min(queue_[1].full.entry_squared, move.cruise_speed_squared) : 0;
        emit(move, std::sqrt(exit));
        last_cruise_squared_ = move.cruise_speed_squared;
        queue_.pop_front();
    }
}

void KlipperModel::emit(const QueuedMove& move, double exit_speed) {
    Segment& segment = output_.begin(move.target_id);
    segment.kind = SegmentKind::linear;
    segment.start = move.start;
    segment.end = move.end;
    segment.length_mm = move.length_mm;
    segment.reaches_target = move.reaches_target;
    segment.master_limits = {std::sqrt(move.cruise_speed_squared), move.acceleration, move.acceleration,
                             kUnlimited};
    segment.master = TimeLaw::between(move.length, speed_, exit_speed, segment.master_limits);
    segment.master_limits.max_speed = std::max(move.max_speed, segment.master.peak_speed());
    segment.duration_s = segment.master.duration_s();
    segment.limited_by = limited_by(move, segment.master);
    output_.finish();
    speed_ = exit_speed;
}

}  // namespace gsim::motion
