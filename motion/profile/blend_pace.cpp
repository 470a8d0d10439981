#include "motion/profile/blend_pace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "motion/path/arc_part.h"
#include "motion/profile/law_cut.h"

namespace gsim::motion {

namespace {

constexpr double kNoTime_s = 1e-12;
constexpr double kNoWay = 1e-12;            // mm or rad; rounding would set its direction
constexpr double kStandstillSpeed = 1e-9;   // mm/s or rad/s
constexpr double kOffWay = 1e-6;            // mm or rad, between the ends of parts
constexpr double kPiecesPerRate = 16;       // the minimum in which the rate rises from 0 to 1
constexpr double kInside = 1e-6;            // share of a stretch: accelerations jump at its ends
constexpr int kSamples = 8;                 // of a stretch of the plan between bends of its laws
constexpr double kNoMore = 1 - 1e-9;        // of a rate that is as good as reached
constexpr double kShareOfSpeedingUp = 0.5;  // of the joints' accelerations

/// Stretch of the plan, and the rates at its ends; the rate is linear in the clock's time.
struct PacedStretch {
    double from_s;
    double to_s;
    double rate;
    double end_rate;

    double duration_s() const { return 2 * (to_s - from_s) / (rate + end_rate); }
    /// Returns the time in the plan, after a share of the duration.
    double at_s(double share) const {
        return from_s + share * duration_s() * (rate + share * (end_rate - rate) / 2);
    }
    double rate_at(double share) const { return rate + share * (end_rate - rate); }
};

TimeLaw rest_for(double duration_s) {
    const LawPiece piece{duration_s, 0, 0, 0, 0};
    return TimeLaw::of_pieces({&piece, 1});
}

/// Returns one of the two motions between two instants of the plan, by its own law.
Segment motion_part(const Segment& motion, double from_s, double to_s, const TimeLaw& law) {
    Segment part = motion;
    part.beside.reset();
    const Segment alone = part;
    const double from = motion.lead.at(from_s).s;
    const double to = motion.lead.at(to_s).s;
    part.start = alone.position_at(from_s);
    part.end = alone.position_at(to_s);
    if (motion.kind == SegmentKind::circular) {
        const std::optional<Arc> arc = arc_part(motion.arc, from, to);
        part.kind = arc ? SegmentKind::circular : SegmentKind::linear;
        if (arc) part.arc = *arc;
    }
    part.lead = to - from > kNoWay ? law : rest_for(law.duration_s());
    part.duration_s = law.duration_s();
    return part;
}

void move_by(const rrs::JointPos& way, Segment& segment) {
    segment.start += way;
    segment.end += way;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = segment.position_joints[axis];
        if (joint >= 0) segment.arc.center[static_cast<Eigen::Index>(axis)] += way[joint];
    }
}

Segment both_parts(const Segment& blend, double from_s, double to_s, const TimeLaw& lead,
                   const TimeLaw& beside) {
    Segment part = motion_part(blend, from_s, to_s, lead);
    move_by(blend.beside->position_at(from_s) - blend.beside->start, part);
    part.beside = std::make_shared<Segment>(motion_part(*blend.beside, from_s, to_s, beside));
    part.length_mm = part.blended_length_mm();
    part.reaches_target = blend.reaches_target && to_s >= blend.duration_s;
    return part;
}

/// Returns the part of constant jerk that leads from one state to another one in a time.
LawPiece piece_between(const LawState& from, const LawState& to, double duration_s) {
    const double speed_gain = to.v - from.v;
    const double way = to.s - from.s - from.v * duration_s;
    const double jerk = 12 * (duration_s * speed_gain / 2 - way) / (duration_s * duration_s * duration_s);
    return {duration_s, from.s, from.v, speed_gain / duration_s - jerk * duration_s / 2, jerk};
}

/// Returns the parts `first` to `last` of `count` equal times of the stretch.
TimeLaw paced_law(const TimeLaw& law, const PacedStretch& stretch, int first, int last, int count) {
    const auto paced = [&](int index) {
        const double share = static_cast<double>(index) / count;
        LawState state = law.at(index == count ? stretch.to_s : stretch.at_s(share));
        state.v *= stretch.rate_at(share);
        return state;
    };
    std::array<LawPiece, TimeLaw::kMaxPieces> pieces;
    const double start = paced(first).s;
    for (int i = first; i < last; ++i) {
        LawPiece piece = piece_between(paced(i), paced(i + 1), stretch.duration_s() / count);
        piece.s0 -= start;
        pieces[static_cast<std::size_t>(i - first)] = piece;
    }
    return TimeLaw::of_pieces({pieces.data(), static_cast<std::size_t>(last - first)});
}

double jerk_at(const TimeLaw& law, double t_s) {
    for (const LawPiece& piece : law.pieces()) {
        if (t_s < piece.duration_s) return std::abs(piece.jerk);
        t_s -= piece.duration_s;
    }
    return 0;
}

/// A law s(t) of acceleration a and jerk j, run at a rate r that changes by q in the clock's time, has the
/// fourth derivative 3 a q^2 + 6 j r^2 q. The part over h that meets both ends is off by at most h^4/384 of
/// that. The value a h^2 is at most twice the distance if speeds are not below 0, or six times if a grows
/// from 0.
int piece_count(const Segment& blend, const PacedStretch& stretch) {
    const auto way = [&](const TimeLaw& law) { return law.at(stretch.to_s).s - law.at(stretch.from_s).s; };
    const double change = std::abs(stretch.end_rate - stretch.rate);
    const double ratio = change / (stretch.end_rate + stretch.rate);
    const double longest = std::max(way(blend.lead), way(blend.beside->lead));
    const double middle_s = (stretch.from_s + stretch.to_s) / 2;
    const double jerk = std::max(jerk_at(blend.lead, middle_s), jerk_at(blend.beside->lead, middle_s));
    const double rate = std::max(stretch.rate, stretch.end_rate);
    const double bending = (jerk > 0 ? 6 : 2) * longest * ratio * ratio / 32;
    const double turning = jerk * rate * rate * change * std::pow(stretch.duration_s(), 3) / 64;
    const double exact = std::sqrt(std::sqrt((bending + turning) / kOffWay));
    return 1 + static_cast<int>(std::max(exact, kPiecesPerRate * change));
}

void put(const Segment& blend, const PacedStretch& stretch, BlendPace& pace) {
    pace.until_s = stretch.to_s;
    pace.rate = stretch.end_rate;
    if (stretch.to_s - stretch.from_s <= kNoTime_s) return;
    constexpr int kMost = static_cast<int>(TimeLaw::kMaxPieces);
    const int count = piece_count(blend, stretch);
    for (int first = 0; first < count; first += kMost) {
        const int last = std::min(first + kMost, count);
        const double to_s = last == count ? stretch.to_s : stretch.at_s(static_cast<double>(last) / count);
        pace.parts.push_back(both_parts(blend, stretch.at_s(static_cast<double>(first) / count), to_s,
                                        paced_law(blend.lead, stretch, first, last, count),
                                        paced_law(blend.beside->lead, stretch, first, last, count)));
    }
}

/// Returns the instants of the plan after `from_s` at which the acceleration of a motion jumps, and the end.
std::vector<double> bends(const Segment& blend, double from_s) {
    std::vector<double> instants;
    for (const TimeLaw* law : {&blend.lead, &blend.beside->lead}) {
        double end_s = 0;
        for (const LawPiece& piece : law->pieces()) {
            end_s += piece.duration_s;
            if (end_s > from_s && end_s < blend.duration_s - kNoTime_s) instants.push_back(end_s);
        }
    }
    std::sort(instants.begin(), instants.end());
    instants.push_back(blend.duration_s);
    return instants;
}

/// Requirements of the plan on the joints in a stretch.
struct Demand {
    Eigen::ArrayXd speed;         ///< Greatest.
    Eigen::ArrayXd acceleration;  ///< Greatest, up or down.
    Eigen::ArrayXd gaining;       ///< Greatest that makes the joint faster, not below 0.
    Eigen::ArrayXd braking;       ///< Greatest that makes the joint slower, not below 0.
};

Demand demand_of(const Segment& blend, double from_s, double to_s) {
    Demand demand;
    demand.speed = Eigen::ArrayXd::Zero(blend.start.size());
    demand.acceleration = demand.gaining = demand.braking = demand.speed;
    for (const double end_s : {from_s, to_s})
        demand.speed = demand.speed.max(blend.at(end_s).velocity.array().abs());
    for (int i = 0; i < kSamples; ++i) {
        const double share = kInside + (1 - 2 * kInside) * i / (kSamples - 1);
        const JointState state = blend.at(from_s + (to_s - from_s) * share);
        const Eigen::ArrayXd along = state.acceleration.array() * state.velocity.array().sign();
        demand.speed = demand.speed.max(state.velocity.array().abs());
        demand.acceleration = demand.acceleration.max(along.abs());
        demand.gaining = demand.gaining.max(along);
        demand.braking = demand.braking.max(-along);
    }
    return demand;
}

/// Returns how fast the rate may change (1/s) if the plan takes `taken` of the joints' accelerations.
double rate_change(const Demand& demand, const Eigen::ArrayXd& taken, const rrs::JointPos& acceleration) {
    double change = std::numeric_limits<double>::infinity();
    for (Eigen::Index joint = 0; joint < taken.size(); ++joint) {
        if (demand.speed[joint] <= kStandstillSpeed) continue;
        const double limit = std::max(acceleration[joint], demand.acceleration[joint]);
        change = std::min(change, std::max(limit - taken[joint], 0.0) / demand.speed[joint]);
    }
    return change;
}

/// Returns the highest rate at which the plan leaves acceleration for speeding up.
double rate_to_reach(const Demand& demand, const rrs::JointPos& acceleration) {
    double square = 1;
    for (Eigen::Index joint = 0; joint < demand.acceleration.size(); ++joint) {
        const double planned = demand.acceleration[joint];
        const double limit = std::max(acceleration[joint], planned);
        if (planned > 0) square = std::min(square, (1 - kShareOfSpeedingUp) * limit / planned);
    }
    return std::sqrt(square);
}

}  // namespace

BlendPace slow_down(const Segment& blend, double from_s, double rate, const rrs::JointPos& acceleration) {
    BlendPace pace{{}, from_s, rate};
    for (const double to_s : bends(blend, from_s)) {
        const double at_s = pace.until_s;
        const Demand demand = demand_of(blend, at_s, to_s);
        const double change = rate_change(demand, demand.braking * pace.rate * pace.rate, acceleration);
        const double stop_s = at_s + pace.rate * pace.rate / (2 * change);
        if (stop_s <= to_s) {
            put(blend, {at_s, to_s - stop_s > kNoTime_s ? stop_s : to_s, pace.rate, 0}, pace);
            return pace;
        }
        const double left = pace.rate * pace.rate - 2 * change * (to_s - at_s);
        put(blend, {at_s, to_s, pace.rate, std::sqrt(std::max(left, 0.0))}, pace);
    }
    return pace;
}

BlendPace speed_up(const Segment& blend, double rate, const rrs::JointPos& acceleration) {
    BlendPace pace{{}, 0, rate};
    const std::vector<double> instants = bends(blend, 0);
    double highest = 1;
    for (double from_s = 0; const double to_s : instants) {
        highest = std::min(highest, rate_to_reach(demand_of(blend, from_s, to_s), acceleration));
        from_s = to_s;
    }
    for (const double to_s : instants) {
        if (pace.rate < highest * kNoMore) {
            const double at_s = pace.until_s;
            const Demand demand = demand_of(blend, at_s, to_s);
            const double change = rate_change(demand, demand.gaining * highest * highest, acceleration);
            const double square = pace.rate * pace.rate;
            const double reached_s = at_s + (highest * highest - square) / (2 * change);
            const double end_rate = std::sqrt(square + 2 * change * (to_s - at_s));
            put(blend, {at_s, std::min(reached_s, to_s), pace.rate, reached_s <= to_s ? highest : end_rate},
                pace);
        }
        put(blend, {pace.until_s, to_s, pace.rate, pace.rate}, pace);
    }
    return pace;
}

Segment blend_part(const Segment& blend, double from_s, double to_s) {
    const auto part = [&](const TimeLaw& law) { return law_from(law_until(law, to_s), from_s); };
    return both_parts(blend, from_s, to_s, part(blend.lead), part(blend.beside->lead));
}

bool stands(const Segment& blend, double at_s) {
    return (blend.at(at_s).velocity.array().abs() <= kStandstillSpeed).all();
}

}  // namespace gsim::motion
