#include "runtime/simulator/moves/move_feeds.h"

#include <fmt/format.h>

#include "base/units.h"
#include "motion/planner/range_check.h"

namespace gsim::simulation {

namespace {

double rotary_speed_rad_s(const Feed& feed) {
    return feed.rotary_deg_min / kSecondsPerMinute * kRadPerDeg;
}

}  // namespace

bool MoveFeeds::check(const Feed& feed, bool rotary, const SourceLocation& location) {
    const motion::PlanResult checked =
        feed.motion_s ? motion::check_motion_time(*feed.motion_s)
        : rotary      ? motion::check_positive(rotary_speed_rad_s(feed), "orientation speed")
                      : motion::check_positive(feed.linear_mm_min / kSecondsPerMinute, "speed");
    return checked || outcome_.fail(checked.error(), location);
}

void MoveFeeds::apply(const Feed& feed, bool rotary, motion::Move& move) {
    motion::MoveParameters& parameters = move.move_parameters;
    parameters.position_speed_mm_s = parameters.orientation_speed_rad_s = motion::kUnlimited;
    if (feed.motion_s) {
        parameters.motion_time_s = *feed.motion_s;
        return;
    }
    if (rotary) {
        parameters.orientation_speed_rad_s = rotary_speed_rad_s(feed);
        return;
    }
    const double speed_mm_s = feed.linear_mm_min / kSecondsPerMinute;
    parameters.position_speed_mm_s = speed_mm_s;
    if (speed_mm_s <= machine_.path.max_feed_mm_s || speed_mm_s == warned_feed_mm_s_) return;
    warned_feed_mm_s_ = speed_mm_s;
    warnings_.add(fmt::format(
        "F of {:.10g} mm/min is above the machine's contour speed limit of {:.10g} mm/min, which applies",
        speed_mm_s * kSecondsPerMinute, machine_.path.max_feed_mm_s * kSecondsPerMinute));
}

double MoveFeeds::per_min(const LineMove& move, bool rotary) const {
    if (!move.feed.motion_s) return rotary ? move.feed.rotary_deg_min : move.feed.linear_mm_min;
    const AxisVector& from = position_.axes();
    const double length = rotary ? (move.target - from).norm()
                                 : (position_.space_point(move.target) - position_.space_point(from)).norm();
    return length / *move.feed.motion_s * kSecondsPerMinute;
}

double MoveFeeds::per_min(const ArcMove& move) const {
    if (!move.feed.motion_s) return move.feed.linear_mm_min;
    const double length =
        move.length_mm(position_.space_point(position_.axes()), position_.space_point(move.target));
    return length / *move.feed.motion_s * kSecondsPerMinute;
}

}  // namespace gsim::simulation
