#include "motion/path/joint_way.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/units.h"

namespace gsim::motion {

namespace {

constexpr double kFlat_mm = 1e-10;

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
Range wide_range_alone(const Segment& segment, int joint) {
    const auto [least, most] = std::minmax(segment.start[joint], segment.end[joint]);
    const std::optional<Eigen::Index> axis = arc_axis(segment, joint);
    if (!axis) return {least, most};
    const Arc& arc = segment.arc;
    if (arc.u[*axis] == 0 && arc.v[*axis] == 0) return {least, most};
    Range range = arc.bounds(static_cast<int>(*axis));
    if (arc.lift[*axis] == 0) {
        const double bulge = arc.bulge_mm();
        range = intersection(range, {least - bulge, most + bulge});
    }
    return {std::min(range.min - kArcRounding_mm, least), std::max(range.max + kArcRounding_mm, most)};
}

/// A value and its rate of change.
struct Reading {
    double value;
    double rate;
};

/// Returns the root of at(t) = wanted between two instants, with a rate of one sign. Uses Newton's method,
/// kept between bounds that close in.
template <typename At>
double root(const At& at, double wanted, bool rises, double from, double to) {
    constexpr int kNewton = 20;
    constexpr int kMost = 100;
    constexpr double kSame = 1e-15;
    double low = from;
    double high = to;
    double t = low + (high - low) / 2;
    for (int i = 0; i < kMost; ++i) {
        const Reading reading = at(t);
        const double off = reading.value - wanted;
        if (off == 0) return t;
        ((off > 0) == rises ? high : low) = t;
        double next = t - off / reading.rate;
        if (i >= kNewton || !(next > low && next < high)) next = low + (high - low) / 2;
        if (std::abs(next - t) <= kSame * std::max(1.0, t)) return next;
        t = next;
    }
    return t;
}

/// Returns the time at which a law reaches `s`.
double time_at(const TimeLaw& law, double s) {
    const auto at = [&law](double t) {
        const LawState state = law.at(t);
        return Reading{state.s, state.v};
    };
    return root(at, std::clamp(s, 0.0, law.length()), true, 0, law.duration_s());
}

/// The slope of a coordinate along an arc, times the arc's length, is lift - swing sin(phi - base), see
/// Arc::range().
void add_turns_of_arc(const Segment& segment, Eigen::Index axis, std::vector<double>& times_s) {
    const Arc& arc = segment.arc;
    const double length = arc.length_mm();
    const double flat = std::sqrt(std::max(0.0, length * length - arc.lift.squaredNorm()));
    const double swing = std::hypot(arc.u[axis], arc.v[axis]) * flat;
    if (std::abs(arc.lift[axis]) >= swing) return;
    const double growth = std::log1p((arc.end_radius_mm - arc.radius_mm) / arc.radius_mm);
    const double base = std::atan2(arc.v[axis], arc.u[axis]) + std::atan2(growth, arc.sweep_rad);
    const double level = std::asin(arc.lift[axis] / swing);
    for (const double phase : {base + level, base + std::numbers::pi - level}) {
        const double first = phase - kTurn_rad * std::floor(phase / kTurn_rad);
        const double turns = std::ceil((arc.sweep_rad - first) / kTurn_rad);
        for (double turn = 0; turn < turns; ++turn)
            times_s.push_back(time_at(segment.lead, arc.length_to(first + turn * kTurn_rad)));
    }
}

void add_piece_ends(const TimeLaw& law, std::vector<double>& times_s) {
    double end_s = 0;
    for (const LawPiece& piece : law.pieces()) times_s.push_back(end_s += piece.duration_s);
}

/// Joint with two simultaneous motions. Times are within one part of both laws.
class TwoMotions {
  public:
    TwoMotions(const Segment& segment, int joint, std::vector<double>& times_s)
        : segment_(segment), joint_(joint), times_s_(times_s) {}

    /// Halves the time until the joint's speed cannot change its sign, or the motion is negligible.
    void split(double from_s, double to_s) {
        const double half_s = (to_s - from_s) / 2;
        const double most = most_acceleration(from_s, to_s);
        const double middle_s = from_s + half_s;
        times_s_.push_back(to_s);
        if (most * half_s * half_s / 2 <= kFlat_mm) return;
        if (std::abs(segment_.at(middle_s).velocity[joint_]) >= most * half_s) return;
        split(from_s, middle_s);
        split(middle_s, to_s);
    }

  private:
    /// Accelerations at the ends of a time; they are linear in between along a straight path.
    struct Ends {
        double first;
        double last;

        double most() const { return std::max(std::abs(first), std::abs(last)); }
    };

    /// Returns the accelerations along the path from two instants inside, because accelerations jump at the
    /// ends of law parts.
    static Ends acceleration(const TimeLaw& law, double from_s, double to_s) {
        const double quarter_s = (to_s - from_s) / 4;
        const double a = law.at(from_s + quarter_s).a;
        const double b = law.at(to_s - quarter_s).a;
        return {a - (b - a) / 2, b + (b - a) / 2};
    }

    double most_acceleration(double from_s, double to_s) const {
        const Ends own = acceleration(segment_.lead, from_s, to_s);
        const Ends other = acceleration(segment_.beside->lead, from_s, to_s);
        if (!arc_axis(segment_, joint_) && !arc_axis(*segment_.beside, joint_)) {
            const double share = share_of(segment_);
            const double other_share = share_of(*segment_.beside);
            return Ends{share * own.first + other_share * other.first,
                        share * own.last + other_share * other.last}
                .most();
        }
        return most_alone(segment_, own, from_s, to_s) + most_alone(*segment_.beside, other, from_s, to_s);
    }

    double share_of(const Segment& one) const {
        const double length = one.lead.length();
        return length > 0 ? (one.end[joint_] - one.start[joint_]) / length : 0;
    }

    double most_alone(const Segment& one, const Ends& along, double from_s, double to_s) const {
        if (!arc_axis(one, joint_)) return std::abs(share_of(one)) * along.most();
        const double half_s = (to_s - from_s) / 2;
        const double speed = one.lead.at(from_s + half_s).v + along.most() * half_s;
        return along.most() + speed * speed * one.arc.max_curvature();
    }

    const Segment& segment_;
    int joint_;
    std::vector<double>& times_s_;
};

void add_turns_of_both(const Segment& segment, int joint, std::vector<double>& times_s) {
    std::vector<double> ends{segment.duration_s};
    add_piece_ends(segment.lead, ends);
    add_piece_ends(segment.beside->lead, ends);
    std::sort(ends.begin(), ends.end());
    TwoMotions motions(segment, joint, times_s);
    double from_s = 0;
    for (const double end_s : ends) {
        const double to_s = std::min(end_s, segment.duration_s);
        if (to_s > from_s) motions.split(from_s, to_s);
        from_s = std::max(from_s, to_s);
    }
}

}  // namespace

Range wide_range(const Segment& segment, int joint) {
    Range range = wide_range_alone(segment, joint);
    if (!segment.beside) return range;
    const Range other = wide_range_alone(*segment.beside, joint);
    const double start = segment.beside->start[joint];
    return {range.min + other.min - start, range.max + other.max - start};
}

void add_turns(const Segment& segment, int joint, std::vector<double>& times_s) {
    if (segment.beside) return add_turns_of_both(segment, joint, times_s);
    if (const std::optional<Eigen::Index> axis = arc_axis(segment, joint))
        add_turns_of_arc(segment, *axis, times_s);
}

double passing_s(const Segment& segment, int joint, double value, double from_s, double to_s) {
    const auto at = [&segment, joint](double t_s) {
        const JointState state = segment.at(t_s);
        return Reading{state.position[joint], state.velocity[joint]};
    };
    return root(at, value, segment.position_at(to_s)[joint] > value, from_s, to_s);
}

}  // namespace gsim::motion
