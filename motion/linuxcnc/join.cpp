#include "motion/linuxcnc/join.h"

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
constexpr double kKinkShare = 0.1;
constexpr double kReversal_rad = 2 * kRadPerDeg;

void end_by(Piece& before, Piece& after, Term term) {
    before.term = term;
    after.after_parabola = term == Term::parabola;
}

void set_kink(Piece& before, Piece& after, double speed, double share) {
    before.kink_speed = speed;
    before.kink_at_end = std::max(before.kink_at_end, share);
    after.kink_at_start = std::max(after.kink_at_start, share);
}

void clear_kink(Piece& before, Piece& after) {
    before.kink_speed = -1;
    before.kink_at_end = 0;
    after.kink_at_start = 0;
}

bool reverses(const Corner& corner) {
    return (corner.in + corner.out).squaredNorm() < kReversal_rad * kReversal_rad;
}

double shared_speed(const Piece& before, const Piece& after, double most_share) {
    const auto most = [most_share](const Piece& piece) {
        return piece.obeyed.feed ? piece.requested_speed * most_share : piece.requested_speed;
    };
    return std::min({most(before), before.max_speed, most(after), after.max_speed});
}

// Returns the largest share of an axis' acceleration that the tangent discontinuity takes if it is passed at
// `speed` within a period.
double kink_share(const Piece& before, const Piece& after, const Corner& corner, double speed,
                  const Axes& axes, double period_s) {
    const double change = speed / period_s + after.full_acceleration;
    const Vector3d shares =
        (corner.out - corner.in).cwiseAbs().cwiseQuotient(axes.max_acceleration_mm_s2()) * change;
    const double greatest = shares.maxCoeff();
    return before.curved || after.curved ? greatest / kTangentialShare : greatest;
}

// Continuous mode uses the fastest of three methods to pass the corner.
std::optional<Blend> join_fastest(Piece& before, Piece& after, const Corner& corner, const Axes& axes,
                                  const JoinRules& rules) {
    const double parabola = parabola_between(before, after).net_speed / 2;
    const double kink = before.kink_speed;
    std::optional<Blend> blend = blend_between(before, after, corner, axes, rules.planning);
    const double arc = blend ? blend->piece.max_speed : 0;
    if (parabola >= std::max(kink, arc)) {
        clear_kink(before, after);
        end_by(before, after, Term::parabola);
        return std::nullopt;
    }
    end_by(before, after, Term::tangent);
    after.after_tangent = true;
    if (kink >= arc) return std::nullopt;
    clear_kink(before, after);
    make_room(*blend, axes, before, after);
    return blend;
}

}  // namespace

std::optional<Blend> join(Piece& before, Piece& after, const Axes& axes, const JoinRules& rules) {
    if (rules.stop_between_rapid_and_feed && before.rapid != after.rapid) {
        end_by(before, after, Term::stop);
        return std::nullopt;
    }
    if (before.turns || after.turns || before.term == Term::stop) return std::nullopt;
    const Corner corner = corner_between(before, after, axes);
    if (reverses(corner)) {
        end_by(before, after, Term::stop);
        return std::nullopt;
    }
    const double speed = shared_speed(before, after, rules.most_share);
    const double share = kink_share(before, after, corner, speed, axes, rules.planning.period_s);
    if (share < kKinkShare) {
        set_kink(before, after, speed, share);
        end_by(before, after, Term::tangent);
        after.after_tangent = true;
        return std::nullopt;
    }
    set_kink(before, after, speed * kKinkShare / share, kKinkShare);
    if (before.term == Term::exact) return std::nullopt;
    return join_fastest(before, after, corner, axes, rules);
}

}  // namespace gsim::motion::linuxcnc
