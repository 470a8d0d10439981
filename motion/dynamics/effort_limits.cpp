#include "motion/dynamics/effort_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/segment/segment.h"

namespace gsim::dynamics {

using motion::JointSetup;
using motion::kNoShare;
using motion::kUnlimited;
using motion::WayPoint;
using motion::WayToLimit;
using rrs::JointPos;

namespace {

constexpr double kWithinTop =
    1 - 1e-9;  // at its top speed, but for rounding, a motor still brings up what it has
constexpr double kAsGood = 1 - 1e-3;           // of an acceleration for which no lower speed is tried
constexpr double kLeastPart = 1.0 / 4096;      // of the top speed, for the remainder at standstill
constexpr double kStep = 0.70710678118654752;  // half an octave
constexpr double kMostLoss =
    0.5;  // of an acceleration because of speed, on a path that is passed at any speed

/// Returns the time from standstill to standstill with these ramps, and up to this speed.
double time_s(double length, double speed, double up, double down) {
    const double ramps = 1 / up + 1 / down;
    if (speed * speed * ramps / 2 <= length) return length / speed + speed * ramps / 2;
    return std::sqrt(2 * length * ramps);
}

}  // namespace

/// Components of efforts at a position: for speeds as parts u of the top one at_rest + u linear + u^2 square,
/// and for each unit of an acceleration `moved`.
struct EffortLimits::Terms {
    JointPos at_rest;
    JointPos linear;
    JointPos square;
    std::vector<JointPos> moved;  ///< Along the path, or by the joints that move.

    Motor::Effort effort(Eigen::Index joint, double sense) const {
        return {sense * at_rest[joint], sense * linear[joint], sense * square[joint]};
    }
    double most(Eigen::Index joint, double part) const {
        return at_rest[joint] + part * (linear[joint] + part * square[joint]);
    }

    /// Raises `off` at least to the distance of the middle term from the line through its neighbours.
    static void raise(JointPos& off, const JointPos& a, const JointPos& b, const JointPos& c) {
        off = off.cwiseMax((a - 2 * b + c).cwiseAbs());
    }
    void raise_by(const Terms& a, const Terms& b, const Terms& c) {
        raise(at_rest, a.at_rest, b.at_rest, c.at_rest);
        raise(linear, a.linear, b.linear, c.linear);
        raise(square, a.square, b.square, c.square);
        for (std::size_t i = 0; i < moved.size(); ++i) raise(moved[i], a.moved[i], b.moved[i], c.moved[i]);
    }
};

/// The terms all along a path.
struct EffortLimits::Field {
    bool straight = false;
    double max_speed = 0;
    JointPos shares;          ///< Max change of each joint by path length, without its sense.
    std::vector<int> moving;  ///< Joints that change.
    JointPos friction;        ///< Coulomb's, of those, if its sense is not known; else 0.
    std::vector<Terms> terms;
    Terms off;  ///< Max distance of terms between two points from the line through them.

    double by_speed(Eigen::Index joint) const { return max_speed * shares[joint]; }
};

/// Permitted accelerations of the joints up to a part of the top speed.
struct EffortLimits::Allowed {
    JointPos up, down;    ///< By joint; only those of joints that move count.
    double along_up = 0;  ///< The same along the path, for comparison; 0: the motors have too little.
    double along_down = 0;

    double least() const { return std::min(along_up, along_down); }
};

EffortLimits::EffortLimits(std::shared_ptr<const Dynamics> dynamics, std::vector<Motor> motors)
    : dynamics_(std::move(dynamics)), motors_(std::move(motors)) {}

EffortLimits::Terms EffortLimits::terms_at(const WayPoint& point, const Field& field) const {
    const JointPos none = JointPos::Zero(point.position.size());
    JointPos sense = none;
    if (field.straight) {
        for (const int joint : field.moving) sense[joint] = point.slope[joint] > 0 ? 1 : -1;
    }
    const auto at = [&](double part) {
        return dynamics_->efforts({.position = point.position,
                                   .velocity = part * field.max_speed * point.slope,
                                   .acceleration = none,
                                   .sense = sense});
    };
    const Efforts at_rest = at(0);
    const Efforts half = at(0.5);
    const Efforts full = at(1);
    Terms terms{.at_rest = at_rest,
                .linear = 4 * half - full - 3 * at_rest,
                .square = 2 * full + 2 * at_rest - 4 * half,
                .moved = {}};
    if (field.straight) {
        terms.moved.push_back(dynamics_->inertial(point.position, point.slope));
        return terms;
    }
    for (const int joint : field.moving) {
        JointPos unit = none;
        unit[joint] = 1;
        terms.moved.push_back(dynamics_->inertial(point.position, unit));
    }
    return terms;
}

EffortLimits::Field EffortLimits::field_of(const WayToLimit& way) const {
    const Eigen::Index joints = way.points.front().position.size();
    Field field{.straight = way.straight,
                .max_speed = way.max_speed,
                .shares = {},
                .moving = {},
                .friction = JointPos::Zero(joints),
                .terms = {},
                .off = {}};
    field.shares = JointPos::Zero(joints);
    for (const WayPoint& point : way.points) field.shares = field.shares.cwiseMax(point.slope.cwiseAbs());
    for (int joint = 0; joint < joints; ++joint) {
        if (field.shares[joint] > kNoShare) field.moving.push_back(joint);
    }
    const JointPos zero = JointPos::Zero(joints);
    if (!way.straight) {
        JointPos moves = zero;
        for (const int joint : field.moving) moves[joint] = 1;
        field.friction = dynamics_->friction(zero, moves);
    }
    for (const WayPoint& point : way.points) field.terms.push_back(terms_at(point, field));
    field.off = {zero, zero, zero, std::vector<JointPos>(field.terms.front().moved.size(), zero)};
    for (std::size_t i = 2; i < field.terms.size(); ++i)
        field.off.raise_by(field.terms[i - 2], field.terms[i - 1], field.terms[i]);
    return field;
}

void EffortLimits::keep_top_speeds(WayToLimit& way, const JointPos& shares) const {
    for (std::size_t i = 0; i < motors_.size(); ++i) {
        const double share = shares[static_cast<Eigen::Index>(i)];
        if (share > kNoShare)
            way.max_speed = std::min(way.max_speed, kWithinTop * motors_[i].top_speed() / share);
    }
}

EffortLimits::Allowed EffortLimits::along_line(const Field& field, const std::vector<JointSetup>& joints,
                                               double part) const {
    double up = kUnlimited;
    double down = kUnlimited;
    for (const int joint : field.moving) {
        const JointSetup& own = joints[static_cast<std::size_t>(joint)];
        const bool known = motors_[static_cast<std::size_t>(joint)].is_known();
        const double share = field.shares[joint];
        up = std::min(up, (known ? own.programmed_acceleration : own.max_acceleration) / share);
        down = std::min(down, (known ? own.programmed_deceleration : own.deceleration()) / share);
    }
    for (Eigen::Index joint = 0; joint < field.shares.size(); ++joint) {
        const Motor& motor = motors_[static_cast<std::size_t>(joint)];
        if (!motor.is_known()) continue;
        const double off = field.off.moved[0][joint];
        for (const Terms& terms : field.terms) {
            const double moved = terms.moved[0][joint];
            for (const double sense : {1.0, -1.0}) {
                const double left =
                    motor.least_left(terms.effort(joint, sense), field.by_speed(joint), part) -
                    field.off.most(joint, part);
                if (left < 0) return {};
                const double most = left / (std::abs(moved) + off);
                if (sense * moved > -off) up = std::min(up, most);
                if (sense * moved < off) down = std::min(down, most);
            }
        }
    }
    return {up * field.shares, down * field.shares, up, down};
}

/// Returns the remainder of each motor after all efforts without acceleration; below 0: nothing.
JointPos EffortLimits::left_in_any_sense(const Field& field, double part) const {
    JointPos left = JointPos::Constant(field.shares.size(), kUnlimited);
    for (Eigen::Index joint = 0; joint < left.size(); ++joint) {
        const Motor& motor = motors_[static_cast<std::size_t>(joint)];
        if (!motor.is_known()) continue;
        for (const Terms& terms : field.terms) {
            for (const double sense : {1.0, -1.0})
                left[joint] = std::min(
                    left[joint], motor.least_left(terms.effort(joint, sense), field.by_speed(joint), part));
        }
        left[joint] -= field.off.most(joint, part) + field.friction[joint];
    }
    return left;
}

/// Returns shares of the joints that move, in proportion to the acceleration that each could have alone.
EffortLimits::Allowed EffortLimits::in_any_sense(const Field& field, const std::vector<JointSetup>& joints,
                                                 double part) const {
    const JointPos left = left_in_any_sense(field, part);
    if ((left.array() < 0).any()) return {};
    const Eigen::Index count = left.size();
    JointPos alone = JointPos::Zero(count);
    JointPos taken = JointPos::Zero(count);
    for (std::size_t i = 0; i < field.moving.size(); ++i) {
        const int joint = field.moving[i];
        JointPos needs = JointPos::Zero(count);
        for (const Terms& terms : field.terms) needs = needs.cwiseMax(terms.moved[i].cwiseAbs());
        needs += field.off.moved[i];
        const JointSetup& own = joints[static_cast<std::size_t>(joint)];
        const bool known = motors_[static_cast<std::size_t>(joint)].is_known();
        alone[joint] = known ? std::min({left[joint] / needs[joint], own.programmed_acceleration,
                                         own.programmed_deceleration})
                             : own.least_acceleration();
        taken += alone[joint] * needs;
    }
    double share = 1;
    for (Eigen::Index joint = 0; joint < count; ++joint) {
        if (taken[joint] > left[joint]) share = std::min(share, left[joint] / taken[joint]);
    }
    alone *= share;
    double along = kUnlimited;
    for (const int joint : field.moving) along = std::min(along, alone[joint] / field.shares[joint]);
    return {alone, alone, along, along};
}

EffortLimits::Allowed EffortLimits::allowed(const Field& field, const std::vector<JointSetup>& joints,
                                            double part) const {
    return field.straight ? along_line(field, joints, part) : in_any_sense(field, joints, part);
}

EffortLimits::Allowed EffortLimits::best(const Field& field, const std::vector<JointSetup>& joints,
                                         WayToLimit& way) const {
    Allowed full = allowed(field, joints, 1);
    const double at_rest = allowed(field, joints, kLeastPart).least();
    if (way.length <= 0 || full.least() >= kAsGood * at_rest) return full;
    const double needed = way.rests ? 0 : kMostLoss * at_rest;
    Allowed best;
    double least_s = kUnlimited;
    double best_part = 1;
    for (double part = 1; part > kLeastPart; part *= kStep) {
        const Allowed one = allowed(field, joints, part);
        if (!(one.least() > 0) || one.least() < needed) continue;
        const double speed = std::min(part * way.max_speed, std::sqrt(one.least() / way.curvature));
        const double one_s = time_s(way.length, speed, one.along_up, one.along_down);
        if (one_s >= least_s) continue;
        least_s = one_s;
        best = one;
        best_part = part;
    }
    way.max_speed *= best_part;
    return best;
}

int EffortLimits::weakest(const Field& field) const {
    const JointPos left = left_in_any_sense(field, kLeastPart);
    Eigen::Index joint = 0;
    left.minCoeff(&joint);
    return static_cast<int>(joint);
}

motion::Planned EffortLimits::limit(WayToLimit& way, std::vector<JointSetup>& joints) const {
    JointPos shares = JointPos::Zero(way.points.front().slope.size());
    for (const WayPoint& point : way.points) shares = shares.cwiseMax(point.slope.cwiseAbs());
    keep_top_speeds(way, shares);
    const Field field = field_of(way);
    const Allowed allowed = best(field, joints, way);
    if (!(allowed.least() > 0)) {
        return tl::unexpected(motion::PlanError{
            .status = rrs::Status::RRS_INVALID_PARAMETER,
            .message = "The motor has not enough for this move: weight, friction and hoses alone take all of "
                       "its peak on the way.",
            .joint = weakest(field)});
    }
    for (const int joint : field.moving) {
        JointSetup& own = joints[static_cast<std::size_t>(joint)];
        own.max_acceleration = allowed.up[joint];
        own.max_deceleration = allowed.down[joint];
    }
    return {};
}

}  // namespace gsim::dynamics
