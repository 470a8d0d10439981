#include "motion/linuxcnc/junction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "motion/linuxcnc/corner.h"
#include "motion/linuxcnc/parabola.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

// A tangent discontinuity that takes less than this share of an axis' acceleration in a period is passed at
// full speed.
constexpr double kTangentDiscontinuityShare = 0.1;
constexpr double kReversal_rad = 2 * kRadPerDeg;

void end_with_term(SubSegment& before, SubSegment& after, EndCondition end_condition) {
    before.junctions.end_condition = end_condition;
    after.junctions.after_parabola = end_condition == EndCondition::parabola;
}

void set_corner_speed(SubSegment& before, SubSegment& after, double speed, double share) {
    before.junctions.corner_speed = speed;
    before.junctions.end_corner_share = std::max(before.junctions.end_corner_share, share);
    after.junctions.start_corner_share = std::max(after.junctions.start_corner_share, share);
}

void clear_corner_speed(SubSegment& before, SubSegment& after) {
    before.junctions.corner_speed = -1;
    before.junctions.end_corner_share = 0;
    after.junctions.start_corner_share = 0;
}

bool is_reversal(const Corner& corner) {
    return (corner.in + corner.out).squaredNorm() < kReversal_rad * kReversal_rad;
}

double common_speed(const SubSegment& before, const SubSegment& after, double max_share) {
    const auto capped_speed = [max_share](const SubSegment& sub_segment) {
        return sub_segment.enabled_overrides.feed ? sub_segment.limits.requested_speed * max_share
                                                  : sub_segment.limits.requested_speed;
    };
    return std::min(
        {capped_speed(before), before.limits.max_speed, capped_speed(after), after.limits.max_speed});
}

// Returns the largest share of an axis' acceleration that the tangent discontinuity takes if it is passed at
// `speed` within a period.
double acceleration_share_at(const SubSegment& before, const SubSegment& after, const Corner& corner,
                             double speed, const Axes& axes, double period_s) {
    const double change = speed / period_s + after.limits.full_acceleration;
    const Vector3d shares =
        (corner.out - corner.in).cwiseAbs().cwiseQuotient(axes.max_acceleration_mm_s2()) * change;
    const double max = shares.maxCoeff();
    return before.curved || after.curved ? max / kTangentialShare : max;
}

// Continuous mode uses the fastest of three methods to pass the corner.
std::optional<Blend> join_by_fastest(SubSegment& before, SubSegment& after, const Corner& corner,
                                     const Axes& axes, const JoinRules& rules) {
    const double parabola = parabola_between(before, after).net_speed / 2;
    const double corner_speed = before.junctions.corner_speed;
    std::optional<Blend> blend = blend_between(before, after, corner, axes, rules.planning);
    const double arc = blend ? blend->sub_segment.limits.max_speed : 0;
    if (parabola >= std::max(corner_speed, arc)) {
        clear_corner_speed(before, after);
        end_with_term(before, after, EndCondition::parabola);
        return std::nullopt;
    }
    end_with_term(before, after, EndCondition::tangent);
    after.junctions.after_tangent = true;
    if (corner_speed >= arc) return std::nullopt;
    clear_corner_speed(before, after);
    trim_for_blend(*blend, axes, before, after);
    return blend;
}

}  // namespace

std::optional<Blend> join(SubSegment& before, SubSegment& after, const Axes& axes, const JoinRules& rules) {
    if (rules.stop_between_rapid_and_feed && before.rapid != after.rapid) {
        end_with_term(before, after, EndCondition::stop);
        return std::nullopt;
    }
    if (before.turns || after.turns || before.junctions.end_condition == EndCondition::stop)
        return std::nullopt;
    const Corner corner = corner_between(before, after, axes);
    if (is_reversal(corner)) {
        end_with_term(before, after, EndCondition::stop);
        return std::nullopt;
    }
    const double speed = common_speed(before, after, rules.max_share);
    const double share = acceleration_share_at(before, after, corner, speed, axes, rules.planning.period_s);
    if (share < kTangentDiscontinuityShare) {
        set_corner_speed(before, after, speed, share);
        end_with_term(before, after, EndCondition::tangent);
        after.junctions.after_tangent = true;
        return std::nullopt;
    }
    set_corner_speed(before, after, speed * kTangentDiscontinuityShare / share, kTangentDiscontinuityShare);
    if (before.junctions.end_condition == EndCondition::exact) return std::nullopt;
    return join_by_fastest(before, after, corner, axes, rules);
}

}  // namespace gsim::motion::linuxcnc
