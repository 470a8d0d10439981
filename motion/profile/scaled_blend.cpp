#include "motion/profile/scaled_blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "motion/path/arc_part.h"
#include "motion/profile/law_cut.h"

namespace gsim::motion {

namespace {

constexpr double kTimeTolerance_s = 1e-12;
constexpr double kLengthTolerance = 1e-12;  // mm or rad; rounding would set its direction
constexpr double kStandstillSpeed = 1e-9;   // mm/s or rad/s
constexpr double kPathTolerance = 1e-6;     // mm or rad, between the ends of parts
constexpr double kSectionsPerRate = 16;     // the minimum in which the rate rises from 0 to 1
constexpr double kInset = 1e-6;             // share of a stretch: accelerations jump at its ends
constexpr int kSamples = 8;                 // of a stretch of the plan between bends of its laws
constexpr double kReachedShare = 1 - 1e-9;  // of a rate that is as good as reached
constexpr double kSpeedUpShare = 0.5;       // of the joints' accelerations

/// Stretch of the plan, and the rates at its ends; the rate is linear in the clock's time.
struct ScaledInterval {
    double from_s;
    double to_s;
    double rate;
    double end_rate;

    double duration_s() const { return 2 * (to_s - from_s) / (rate + end_rate); }
    /// Returns the time in the plan, at a share of the duration.
    double at_s(double share) const {
        return from_s + share * duration_s() * (rate + share * (end_rate - rate) / 2);
    }
    double rate_at(double share) const { return rate + share * (end_rate - rate); }
};

TimeLaw standstill_law(double duration_s) {
    const LawSection section{duration_s, 0, 0, 0, 0};
    return TimeLaw::from_sections({&section, 1});
}

/// Returns one of the two motions between two instants of the plan, by its own law.
Segment motion_part(const Segment& motion, double from_s, double to_s, const TimeLaw& law) {
    Segment part = motion;
    part.superimposed.reset();
    const Segment standalone = part;
    const double from = motion.master.at(from_s).s;
    const double to = motion.master.at(to_s).s;
    part.start = standalone.position_at(from_s);
    part.end = standalone.position_at(to_s);
    if (motion.kind == SegmentKind::circular) {
        const std::optional<Arc> arc = arc_part(motion.arc, from, to);
        part.kind = arc ? SegmentKind::circular : SegmentKind::linear;
        if (arc) part.arc = *arc;
    }
    part.master = to - from > kLengthTolerance ? law : standstill_law(law.duration_s());
    part.duration_s = law.duration_s();
    return part;
}

void translate_segment(const rrs::JointPos& travel, Segment& segment) {
    segment.start += travel;
    segment.end += travel;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = segment.position_joints[axis];
        if (joint >= 0) segment.arc.center[static_cast<Eigen::Index>(axis)] += travel[joint];
    }
}

Segment superimposed_part(const Segment& blend, double from_s, double to_s, const TimeLaw& master,
                          const TimeLaw& superimposed) {
    Segment part = motion_part(blend, from_s, to_s, master);
    translate_segment(blend.superimposed->position_at(from_s) - blend.superimposed->start, part);
    part.superimposed =
        std::make_shared<Segment>(motion_part(*blend.superimposed, from_s, to_s, superimposed));
    part.length_mm = part.blended_length_mm();
    part.reaches_target = blend.reaches_target && to_s >= blend.duration_s;
    return part;
}

/// Returns the part of constant jerk that leads from one state to another one in a time.
LawSection section_between(const LawState& from, const LawState& to, double duration_s) {
    const double speed_gain = to.v - from.v;
    const double travel = to.s - from.s - from.v * duration_s;
    const double jerk = 12 * (duration_s * speed_gain / 2 - travel) / (duration_s * duration_s * duration_s);
    return {duration_s, from.s, from.v, speed_gain / duration_s - jerk * duration_s / 2, jerk};
}

/// Returns the parts `first` to `last` of `count` equal times of the stretch.
TimeLaw scaled_law(const TimeLaw& law, const ScaledInterval& interval, int first, int last, int count) {
    const auto scaled_state = [&](int index) {
        const double share = static_cast<double>(index) / count;
        LawState state = law.at(index == count ? interval.to_s : interval.at_s(share));
        state.v *= interval.rate_at(share);
        return state;
    };
    std::array<LawSection, TimeLaw::kMaxSections> sections;
    const double start = scaled_state(first).s;
    for (int i = first; i < last; ++i) {
        LawSection part =
            section_between(scaled_state(i), scaled_state(i + 1), interval.duration_s() / count);
        part.s0 -= start;
        sections[static_cast<std::size_t>(i - first)] = part;
    }
    return TimeLaw::from_sections({sections.data(), static_cast<std::size_t>(last - first)});
}

double jerk_at(const TimeLaw& law, double t_s) {
    for (const LawSection& section : law.sections()) {
        if (t_s < section.duration_s) return std::abs(section.jerk);
        t_s -= section.duration_s;
    }
    return 0;
}

/// A law s(t) of acceleration a and jerk j, run at a rate r that changes by q in the clock's time, has the
/// fourth derivative 3 a q^2 + 6 j r^2 q. The part over h that meets both ends is off by at most h^4/384 of
/// that. The value a h^2 is at most twice the distance if speeds are not below 0, or six times if a grows
/// from 0.
int section_count(const Segment& blend, const ScaledInterval& section) {
    const auto travel = [&](const TimeLaw& law) { return law.at(section.to_s).s - law.at(section.from_s).s; };
    const double change = std::abs(section.end_rate - section.rate);
    const double ratio = change / (section.end_rate + section.rate);
    const double max_length = std::max(travel(blend.master), travel(blend.superimposed->master));
    const double middle_s = (section.from_s + section.to_s) / 2;
    const double jerk =
        std::max(jerk_at(blend.master, middle_s), jerk_at(blend.superimposed->master, middle_s));
    const double rate = std::max(section.rate, section.end_rate);
    const double acceleration_term = (jerk > 0 ? 6 : 2) * max_length * ratio * ratio / 32;
    const double jerk_term = jerk * rate * rate * change * std::pow(section.duration_s(), 3) / 64;
    const double exact = std::sqrt(std::sqrt((acceleration_term + jerk_term) / kPathTolerance));
    return 1 + static_cast<int>(std::max(exact, kSectionsPerRate * change));
}

void append(const Segment& blend, const ScaledInterval& section, ScaledBlend& scaled_blend) {
    scaled_blend.until_s = section.to_s;
    scaled_blend.rate = section.end_rate;
    if (section.to_s - section.from_s <= kTimeTolerance_s) return;
    constexpr int kMaxSectionsPerLaw = static_cast<int>(TimeLaw::kMaxSections);
    const int count = section_count(blend, section);
    for (int first = 0; first < count; first += kMaxSectionsPerLaw) {
        const int last = std::min(first + kMaxSectionsPerLaw, count);
        const double to_s = last == count ? section.to_s : section.at_s(static_cast<double>(last) / count);
        scaled_blend.parts.push_back(
            superimposed_part(blend, section.at_s(static_cast<double>(first) / count), to_s,
                              scaled_law(blend.master, section, first, last, count),
                              scaled_law(blend.superimposed->master, section, first, last, count)));
    }
}

/// Returns the instants of the plan after `from_s` at which the acceleration of a motion jumps, and the end.
std::vector<double> breakpoints_s(const Segment& blend, double from_s) {
    std::vector<double> instants;
    for (const TimeLaw* law : {&blend.master, &blend.superimposed->master}) {
        double end_s = 0;
        for (const LawSection& section : law->sections()) {
            end_s += section.duration_s;
            if (end_s > from_s && end_s < blend.duration_s - kTimeTolerance_s) instants.push_back(end_s);
        }
    }
    std::sort(instants.begin(), instants.end());
    instants.push_back(blend.duration_s);
    return instants;
}

/// Requirements of the plan on the joints in a stretch.
struct JointPeaks {
    Eigen::ArrayXd speed;         ///< Greatest.
    Eigen::ArrayXd acceleration;  ///< Greatest, up or down.
    Eigen::ArrayXd speeding_up;   ///< Greatest that makes the joint faster, not below 0.
    Eigen::ArrayXd braking;       ///< Greatest that makes the joint slower, not below 0.
};

JointPeaks joint_peaks(const Segment& blend, double from_s, double to_s) {
    JointPeaks demand;
    demand.speed = Eigen::ArrayXd::Zero(blend.start.size());
    demand.acceleration = demand.speeding_up = demand.braking = demand.speed;
    for (const double end_s : {from_s, to_s})
        demand.speed = demand.speed.max(blend.at(end_s).velocity.array().abs());
    for (int i = 0; i < kSamples; ++i) {
        const double share = kInset + (1 - 2 * kInset) * i / (kSamples - 1);
        const JointState state = blend.at(from_s + (to_s - from_s) * share);
        const Eigen::ArrayXd along = state.acceleration.array() * state.velocity.array().sign();
        demand.speed = demand.speed.max(state.velocity.array().abs());
        demand.acceleration = demand.acceleration.max(along.abs());
        demand.speeding_up = demand.speeding_up.max(along);
        demand.braking = demand.braking.max(-along);
    }
    return demand;
}

/// Returns how fast the rate may change (1/s) if the plan takes `used` of the joints' accelerations.
double max_rate_change(const JointPeaks& demand, const Eigen::ArrayXd& used,
                       const rrs::JointPos& acceleration) {
    double change = std::numeric_limits<double>::infinity();
    for (Eigen::Index joint = 0; joint < used.size(); ++joint) {
        if (demand.speed[joint] <= kStandstillSpeed) continue;
        const double limit = std::max(acceleration[joint], demand.acceleration[joint]);
        change = std::min(change, std::max(limit - used[joint], 0.0) / demand.speed[joint]);
    }
    return change;
}

/// Returns the highest rate at which the plan leaves acceleration for speeding up.
double reachable_rate(const JointPeaks& demand, const rrs::JointPos& acceleration) {
    double square = 1;
    for (Eigen::Index joint = 0; joint < demand.acceleration.size(); ++joint) {
        const double planned = demand.acceleration[joint];
        const double limit = std::max(acceleration[joint], planned);
        if (planned > 0) square = std::min(square, (1 - kSpeedUpShare) * limit / planned);
    }
    return std::sqrt(square);
}

}  // namespace

ScaledBlend slow_down(const Segment& blend, double from_s, double rate, const rrs::JointPos& acceleration) {
    ScaledBlend scaled_blend{{}, from_s, rate};
    for (const double to_s : breakpoints_s(blend, from_s)) {
        const double at_s = scaled_blend.until_s;
        const JointPeaks demand = joint_peaks(blend, at_s, to_s);
        const double change =
            max_rate_change(demand, demand.braking * scaled_blend.rate * scaled_blend.rate, acceleration);
        const double stop_s = at_s + scaled_blend.rate * scaled_blend.rate / (2 * change);
        if (stop_s <= to_s) {
            append(blend, {at_s, to_s - stop_s > kTimeTolerance_s ? stop_s : to_s, scaled_blend.rate, 0},
                   scaled_blend);
            return scaled_blend;
        }
        const double rate_squared = scaled_blend.rate * scaled_blend.rate - 2 * change * (to_s - at_s);
        append(blend, {at_s, to_s, scaled_blend.rate, std::sqrt(std::max(rate_squared, 0.0))}, scaled_blend);
    }
    return scaled_blend;
}

ScaledBlend speed_up(const Segment& blend, double rate, const rrs::JointPos& acceleration) {
    ScaledBlend scaled_blend{{}, 0, rate};
    const std::vector<double> instants = breakpoints_s(blend, 0);
    double highest = 1;
    for (double from_s = 0; const double to_s : instants) {
        highest = std::min(highest, reachable_rate(joint_peaks(blend, from_s, to_s), acceleration));
        from_s = to_s;
    }
    for (const double to_s : instants) {
        if (scaled_blend.rate < highest * kReachedShare) {
            const double at_s = scaled_blend.until_s;
            const JointPeaks demand = joint_peaks(blend, at_s, to_s);
            const double change =
                max_rate_change(demand, demand.speeding_up * highest * highest, acceleration);
            const double square = scaled_blend.rate * scaled_blend.rate;
            const double reached_s = at_s + (highest * highest - square) / (2 * change);
            const double end_rate = std::sqrt(square + 2 * change * (to_s - at_s));
            append(
                blend,
                {at_s, std::min(reached_s, to_s), scaled_blend.rate, reached_s <= to_s ? highest : end_rate},
                scaled_blend);
        }
        append(blend, {scaled_blend.until_s, to_s, scaled_blend.rate, scaled_blend.rate}, scaled_blend);
    }
    return scaled_blend;
}

Segment blend_part(const Segment& blend, double from_s, double to_s) {
    const auto part = [&](const TimeLaw& law) { return law_from(law_until(law, to_s), from_s); };
    return superimposed_part(blend, from_s, to_s, part(blend.master), part(blend.superimposed->master));
}

bool is_stationary(const Segment& blend, double at_s) {
    return (blend.at(at_s).velocity.array().abs() <= kStandstillSpeed).all();
}

}  // namespace gsim::motion
