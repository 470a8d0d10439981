#include "motion/path/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/units.h"

namespace gsim::motion {

namespace {

constexpr double kMinArcHeight_mm = 1e-10;

/// Returns the coordinate of the segment's arc that the joint carries.
std::optional<Eigen::Index> arc_axis(const Segment& segment, int joint) {
    if (segment.kind != SegmentKind::circular) return std::nullopt;
    const auto& joints = segment.position_joints;
    const auto found = std::find(joints.begin(), joints.end(), joint);
    if (found == joints.end()) return std::nullopt;
    return found - joints.begin();
}

Range intersection(const Range& a, const Range& b) {
    return {std::max(a.min, b.min), std::min(a.max, b.max)};
}

/// Returns the range of a segment without its superimposed motion.
Range single_motion_bounds(const Segment& segment, int joint) {
    const auto [min, max_acceleration] = std::minmax(segment.start[joint], segment.end[joint]);
    const std::optional<Eigen::Index> axis = arc_axis(segment, joint);
    if (!axis) return {min, max_acceleration};
    const Arc& arc = segment.arc;
    if (arc.u[*axis] == 0 && arc.v[*axis] == 0) return {min, max_acceleration};
    Range range = arc.bounds(static_cast<int>(*axis));
    if (arc.lift[*axis] == 0) {
        const double bulge = arc.bulge_mm();
        range = intersection(range, {min - bulge, max_acceleration + bulge});
    }
    return {std::min(range.min - kArcRounding_mm, min),
            std::max(range.max + kArcRounding_mm, max_acceleration)};
}

/// A value and its rate of change.
struct ValueAndRate {
    double value;
    double rate;
};

/// Returns the root of at(t) = wanted between two instants, with a rate of one sign. Uses Newton's method,
/// kept between bounds that close in.
template <typename At>
double root(const At& at, double requested, bool is_rising, double from, double to) {
    constexpr int kNewtonSteps = 20;
    constexpr int kMaxIterations = 100;
    constexpr double kEqualTolerance = 1e-15;
    double low = from;
    double high = to;
    double t = low + (high - low) / 2;
    for (int i = 0; i < kMaxIterations; ++i) {
        const ValueAndRate reading = at(t);
        const double deviation = reading.value - requested;
        if (deviation == 0) return t;
        ((deviation > 0) == is_rising ? high : low) = t;
        double next = t - deviation / reading.rate;
        if (i >= kNewtonSteps || !(next > low && next < high)) next = low + (high - low) / 2;
        if (std::abs(next - t) <= kEqualTolerance * std::max(1.0, t)) return next;
        t = next;
    }
    return t;
}

/// Returns the time at which a law reaches `s`.
double time_at(const TimeLaw& law, double s) {
    const auto at = [&law](double t) {
        const LawState state = law.at(t);
        return ValueAndRate{state.s, state.v};
    };
    return root(at, std::clamp(s, 0.0, law.length()), true, 0, law.duration_s());
}

/// The slope of a coordinate along an arc, times the arc's length, is lift - swing sin(phi - base), see
/// Arc::range().
void add_arc_reversals(const Segment& segment, Eigen::Index axis, std::vector<double>& times_s) {
    const Arc& arc = segment.arc;
    const double length = arc.length_mm();
    const double flat = std::sqrt(std::max(0.0, length * length - arc.lift.squaredNorm()));
    const double amplitude = std::hypot(arc.u[axis], arc.v[axis]) * flat;
    if (std::abs(arc.lift[axis]) >= amplitude) return;
    const double growth = std::log1p((arc.end_radius_mm - arc.radius_mm) / arc.radius_mm);
    const double base = std::atan2(arc.v[axis], arc.u[axis]) + std::atan2(growth, arc.sweep_rad);
    const double level = std::asin(arc.lift[axis] / amplitude);
    for (const double phase : {base + level, base + std::numbers::pi - level}) {
        const double first = phase - kTurn_rad * std::floor(phase / kTurn_rad);
        const double turns = std::ceil((arc.sweep_rad - first) / kTurn_rad);
        for (double turn = 0; turn < turns; ++turn)
            times_s.push_back(time_at(segment.master, arc.length_to(first + turn * kTurn_rad)));
    }
}

void add_section_ends(const TimeLaw& law, std::vector<double>& times_s) {
    double end_s = 0;
    for (const LawSection& section : law.sections()) times_s.push_back(end_s += section.duration_s);
}

/// Joint with two simultaneous motions. Times are within one part of both laws.
class SuperimposedMotions {
  public:
    SuperimposedMotions(const Segment& segment, int joint, std::vector<double>& times_s)
        : segment_(segment), joint_(joint), times_s_(times_s) {}

    /// Halves the time until the joint's speed cannot change its sign, or the motion is negligible.
    void split(double from_s, double to_s) {
        const double half_s = (to_s - from_s) / 2;
        const double max_acceleration = max_joint_acceleration(from_s, to_s);
        const double middle_s = from_s + half_s;
        times_s_.push_back(to_s);
        if (max_acceleration * half_s * half_s / 2 <= kMinArcHeight_mm) return;
        if (std::abs(segment_.at(middle_s).velocity[joint_]) >= max_acceleration * half_s) return;
        split(from_s, middle_s);
        split(middle_s, to_s);
    }

  private:
    /// Accelerations at the ends of a time; they are linear in between along a straight path.
    struct EndAccelerations {
        double first;
        double last;

        double max_acceleration() const { return std::max(std::abs(first), std::abs(last)); }
    };

    /// Returns the accelerations along the path from two instants inside, because accelerations jump at the
    /// ends of law parts.
    static EndAccelerations acceleration(const TimeLaw& law, double from_s, double to_s) {
        const double quarter_s = (to_s - from_s) / 4;
        const double a = law.at(from_s + quarter_s).a;
        const double b = law.at(to_s - quarter_s).a;
        return {a - (b - a) / 2, b + (b - a) / 2};
    }

    double max_joint_acceleration(double from_s, double to_s) const {
        const EndAccelerations path_ends = acceleration(segment_.master, from_s, to_s);
        const EndAccelerations other = acceleration(segment_.superimposed->master, from_s, to_s);
        if (!arc_axis(segment_, joint_) && !arc_axis(*segment_.superimposed, joint_)) {
            const double share = joint_share(segment_);
            const double superimposed_share = joint_share(*segment_.superimposed);
            return EndAccelerations{share * path_ends.first + superimposed_share * other.first,
                                    share * path_ends.last + superimposed_share * other.last}
                .max_acceleration();
        }
        return max_single_acceleration(segment_, path_ends, from_s, to_s) +
               max_single_acceleration(*segment_.superimposed, other, from_s, to_s);
    }

    double joint_share(const Segment& one) const {
        const double length = one.master.length();
        return length > 0 ? (one.end[joint_] - one.start[joint_]) / length : 0;
    }

    double max_single_acceleration(const Segment& one, const EndAccelerations& along, double from_s,
                                   double to_s) const {
        if (!arc_axis(one, joint_)) return std::abs(joint_share(one)) * along.max_acceleration();
        const double half_s = (to_s - from_s) / 2;
        const double speed = one.master.at(from_s + half_s).v + along.max_acceleration() * half_s;
        return along.max_acceleration() + speed * speed * one.arc.max_curvature();
    }

    const Segment& segment_;
    int joint_;
    std::vector<double>& times_s_;
};

void add_superimposed_reversals(const Segment& segment, int joint, std::vector<double>& times_s) {
    std::vector<double> ends{segment.duration_s};
    add_section_ends(segment.master, ends);
    add_section_ends(segment.superimposed->master, ends);
    std::sort(ends.begin(), ends.end());
    SuperimposedMotions motions(segment, joint, times_s);
    double from_s = 0;
    for (const double end_s : ends) {
        const double to_s = std::min(end_s, segment.duration_s);
        if (to_s > from_s) motions.split(from_s, to_s);
        from_s = std::max(from_s, to_s);
    }
}

}  // namespace

Range range_bounds(const Segment& segment, int joint) {
    Range range = single_motion_bounds(segment, joint);
    if (!segment.superimposed) return range;
    const Range other = single_motion_bounds(*segment.superimposed, joint);
    const double start = segment.superimposed->start[joint];
    return {range.min + other.min - start, range.max + other.max - start};
}

void add_reversal_times(const Segment& segment, int joint, std::vector<double>& times_s) {
    if (segment.superimposed) return add_superimposed_reversals(segment, joint, times_s);
    if (const std::optional<Eigen::Index> axis = arc_axis(segment, joint))
        add_arc_reversals(segment, *axis, times_s);
}

double crossing_time_s(const Segment& segment, int joint, double value, double from_s, double to_s) {
    const auto at = [&segment, joint](double t_s) {
        const JointState state = segment.at(t_s);
        return ValueAndRate{state.position[joint], state.velocity[joint]};
    };
    return root(at, value, segment.position_at(to_s)[joint] > value, from_s, to_s);
}

}  // namespace gsim::motion
