#include "motion/linuxcnc/look_ahead.h"

#include <algorithm>
#include <cmath>

#include "motion/linuxcnc/profile.h"
#include "motion/profile/ramp.h"

namespace gsim::motion::linuxcnc {

namespace {

double square(double value) {
    return value * value;
}

// Returns the squared speed that sub-segment `index` and the next one can have at their junction.
double junction_cap_squared(const SubSegmentQueue& queue, std::size_t index) {
    const SubSegment& sub_segment = queue[index].sub_segment;
    double speed = std::min(sub_segment.limits.max_speed, queue[index + 1].sub_segment.limits.max_speed);
    if (sub_segment.junctions.corner_speed >= 0) speed = std::min(speed, sub_segment.junctions.corner_speed);
    return square(speed);
}

// Returns the rise of the squared speed over the sub-segment at full acceleration.
double speed_squared_gain(const SubSegment& sub_segment) {
    return 2 * acceleration(sub_segment) * sub_segment.length;
}

// Returns the squared speed at the start of the last sub-segment in view.
double cautious_speed_squared(const SubSegment& last) {
    return std::min(square(target_speed(last)), speed_squared_gain(last) / 2);
}

class MinJunctionSpeed {
  public:
    explicit MinJunctionSpeed(double square) : square_(square) {}
    void lower(double other, LimitKind limit) {
        if (other >= square_) return;
        square_ = other;
        limit_ = limit;
    }
    double value() const { return square_; }
    JunctionSpeed speed() const { return {std::sqrt(square_), limit_}; }

  private:
    double square_;
    LimitKind limit_ = LimitKind::corner;
};

}  // namespace

// The speed of each junction, computed backward, is the lesser of its cap and what the next sub-segment can
// brake. This is, for the first junction, the minimum of all caps, each raised by the rises in between. So
// the search can stop if the rises alone exceed the minimum so far.
JunctionSpeed junction_speed(const SubSegmentQueue& queue, std::size_t index, const Horizon& horizon) {
    MinJunctionSpeed lowest(junction_cap_squared(queue, index));
    double total_gain = 0;
    for (std::size_t next = index + 1; total_gain < lowest.value(); ++next) {
        const SubSegment& sub_segment = queue[next].sub_segment;
        const bool ends = horizon.tangent_run_end == next;
        if (ends && !horizon.is_queue_end) {
            lowest.lower(total_gain + speed_squared_gain(sub_segment), LimitKind::stop);
            break;
        }
        if (ends || next == index + horizon.depth) {
            lowest.lower(total_gain + cautious_speed_squared(sub_segment),
                         ends ? LimitKind::stop : LimitKind::look_ahead);
            break;
        }
        total_gain += speed_squared_gain(sub_segment);
        lowest.lower(total_gain + junction_cap_squared(queue, next), LimitKind::corner);
    }
    return lowest.speed();
}

namespace {

double isolated_peak_speed(const SubSegment& sub_segment) {
    return std::isfinite(sub_segment.limits.jerk)
               ? peak_speed(sub_segment.length, acceleration(sub_segment), sub_segment.limits.jerk)
               : kUnlimited;
}

// Returns the speed at the start of a sub-segment from which it can slow down to its end.
double start_speed(const SubSegment& sub_segment, double end_speed) {
    const double trapezoid_speed = std::sqrt(square(end_speed) + speed_squared_gain(sub_segment));
    if (std::isinf(sub_segment.limits.jerk)) return trapezoid_speed;
    const double braking_start_speed =
        ramp_end_speed(sub_segment.length, end_speed, acceleration(sub_segment), sub_segment.limits.jerk);
    return std::min(trapezoid_speed,
                    std::max(end_speed, std::min(braking_start_speed, isolated_peak_speed(sub_segment))));
}

void lower(JunctionSpeed& junction, double speed, LimitKind limit) {
    if (speed < junction.speed) junction = {speed, limit};
}

// Returns the speed at the start of the last sub-segment in view.
JunctionSpeed end_junction_speed(const SubSegment& last, bool stops, bool is_last) {
    if (stops) return {start_speed(last, 0), LimitKind::stop};
    JunctionSpeed junction{std::min(target_speed(last), std::sqrt(speed_squared_gain(last) / 2)),
                           is_last ? LimitKind::stop : LimitKind::look_ahead};
    junction.speed = std::min(junction.speed, isolated_peak_speed(last));
    return junction;
}

}  // namespace

JunctionSpeed curved_junction_speed(const SubSegmentQueue& queue, std::size_t index, const Horizon& horizon) {
    const std::size_t last_index = index + horizon.depth;
    const std::size_t last = std::min(horizon.tangent_run_end.value_or(last_index), last_index);
    const bool ends = horizon.tangent_run_end == last;
    const bool stops = ends && !horizon.is_queue_end;
    JunctionSpeed junction = end_junction_speed(queue[last].sub_segment, stops, ends);
    for (std::size_t next = last; next > index; --next) {
        const SubSegment& before = queue[next - 1].sub_segment;
        if (next < last) junction.speed = start_speed(queue[next].sub_segment, junction.speed);
        lower(junction, std::sqrt(junction_cap_squared(queue, next - 1)), LimitKind::corner);
        if (next < last || stops) lower(junction, isolated_peak_speed(before), LimitKind::jerk);
    }
    return junction;
}

}  // namespace gsim::motion::linuxcnc
