#include "motion/dynamics/effort_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/segment/segment.h"

namespace gsim::dynamics {

using motion::JointSetup;
using motion::kMinShare;
using motion::kUnlimited;
using motion::LimitedPath;
using motion::PathPoint;
using rrs::JointPos;

namespace {

constexpr double kTopSpeedShare =
    1 - 1e-9;  // at its top speed, but for rounding, a motor still brings up what it has
constexpr double kSufficientShare = 1 - 1e-3;  // of an acceleration for which no lower speed is tried
constexpr double kMinPart = 1.0 / 4096;        // of the top speed, for the remainder at standstill
constexpr double kStep = 0.70710678118654752;  // half an octave
constexpr double kMaxLossShare =
    0.5;  // of an acceleration because of speed, on a path that is passed at any speed

/// Returns the time from standstill to standstill with these ramps, and up to this speed.
double time_s(double length, double speed, double up, double down) {
    const double ramps = 1 / up + 1 / down;
    if (speed * speed * ramps / 2 <= length) return length / speed + speed * ramps / 2;
    return std::sqrt(2 * length * ramps);
}

}  // namespace

/// Components of efforts at a position: for speeds as parts u of the top one at_standstill + u linear + u^2
/// quadratic, and for each unit of an acceleration `moved`.
struct EffortLimits::EffortTerms {
    JointPos at_standstill;
    JointPos linear;
    JointPos quadratic;
    std::vector<JointPos> moved;  ///< Along the path, or by the joints that move.

    Motor::Effort effort(Eigen::Index joint, double sense) const {
        return {sense * at_standstill[joint], sense * linear[joint], sense * quadratic[joint]};
    }
    double max(Eigen::Index joint, double part) const {
        return at_standstill[joint] + part * (linear[joint] + part * quadratic[joint]);
    }

    /// Raises `off` at least to the distance of the middle term from the line through its neighbours.
    static void raise(JointPos& off, const JointPos& a, const JointPos& b, const JointPos& c) {
        off = off.cwiseMax((a - 2 * b + c).cwiseAbs());
    }
    void raise_to_deviation(const EffortTerms& a, const EffortTerms& b, const EffortTerms& c) {
        raise(at_standstill, a.at_standstill, b.at_standstill, c.at_standstill);
        raise(linear, a.linear, b.linear, c.linear);
        raise(quadratic, a.quadratic, b.quadratic, c.quadratic);
        for (std::size_t i = 0; i < moved.size(); ++i) raise(moved[i], a.moved[i], b.moved[i], c.moved[i]);
    }
};

/// The terms all along a path.
struct EffortLimits::EffortField {
    bool straight = false;
    double max_speed = 0;
    JointPos shares;          ///< Max change of each joint by path length, without its sense.
    std::vector<int> moving;  ///< Joints that change.
    JointPos friction;        ///< Coulomb's, of those, if its sense is not known; else 0.
    std::vector<EffortTerms> terms;
    EffortTerms off;  ///< Max distance of terms between two points from the line through them.

    double speed_scale(Eigen::Index joint) const { return max_speed * shares[joint]; }
};

/// Permitted accelerations of the joints up to a part of the top speed.
struct EffortLimits::AccelerationBounds {
    JointPos up, down;  ///< By joint; only those of joints that move count.
    double path_acceleration =
        0;  ///< The same along the path, for comparison; 0: the motors have too little.
    double path_deceleration = 0;

    double min() const { return std::min(path_acceleration, path_deceleration); }
};

EffortLimits::EffortLimits(std::shared_ptr<const Dynamics> dynamics, std::vector<Motor> motors)
    : dynamics_(std::move(dynamics)), motors_(std::move(motors)) {}

EffortLimits::EffortTerms EffortLimits::effort_terms_at(const PathPoint& point,
                                                        const EffortField& field) const {
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
    const Efforts at_standstill = at(0);
    const Efforts half = at(0.5);
    const Efforts full = at(1);
    EffortTerms terms{.at_standstill = at_standstill,
                      .linear = 4 * half - full - 3 * at_standstill,
                      .quadratic = 2 * full + 2 * at_standstill - 4 * half,
                      .moved = {}};
    if (field.straight) {
        terms.moved.push_back(dynamics_->inertial_efforts(point.position, point.slope));
        return terms;
    }
    for (const int joint : field.moving) {
        JointPos unit = none;
        unit[joint] = 1;
        terms.moved.push_back(dynamics_->inertial_efforts(point.position, unit));
    }
    return terms;
}

EffortLimits::EffortField EffortLimits::make_effort_field(const LimitedPath& path) const {
    const Eigen::Index joints = path.points.front().position.size();
    EffortField field{.straight = path.straight,
                      .max_speed = path.max_speed,
                      .shares = {},
                      .moving = {},
                      .friction = JointPos::Zero(joints),
                      .terms = {},
                      .off = {}};
    field.shares = JointPos::Zero(joints);
    for (const PathPoint& point : path.points) field.shares = field.shares.cwiseMax(point.slope.cwiseAbs());
    for (int joint = 0; joint < joints; ++joint) {
        if (field.shares[joint] > kMinShare) field.moving.push_back(joint);
    }
    const JointPos zero = JointPos::Zero(joints);
    if (!path.straight) {
        JointPos moves = zero;
        for (const int joint : field.moving) moves[joint] = 1;
        field.friction = dynamics_->friction(zero, moves);
    }
    for (const PathPoint& point : path.points) field.terms.push_back(effort_terms_at(point, field));
    field.off = {zero, zero, zero, std::vector<JointPos>(field.terms.front().moved.size(), zero)};
    for (std::size_t i = 2; i < field.terms.size(); ++i)
        field.off.raise_to_deviation(field.terms[i - 2], field.terms[i - 1], field.terms[i]);
    return field;
}

void EffortLimits::limit_to_top_speeds(LimitedPath& path, const JointPos& shares) const {
    for (std::size_t i = 0; i < motors_.size(); ++i) {
        const double share = shares[static_cast<Eigen::Index>(i)];
        if (share > kMinShare)
            path.max_speed = std::min(path.max_speed, kTopSpeedShare * motors_[i].top_speed() / share);
    }
}

EffortLimits::AccelerationBounds EffortLimits::line_acceleration_bounds(const EffortField& field,
                                                                        const std::vector<JointSetup>& joints,
                                                                        double part) const {
    double up = kUnlimited;
    double down = kUnlimited;
    for (const int joint : field.moving) {
        const JointSetup& joint_setup = joints[static_cast<std::size_t>(joint)];
        const bool known = motors_[static_cast<std::size_t>(joint)].is_known();
        const double share = field.shares[joint];
        up = std::min(up,
                      (known ? joint_setup.programmed_acceleration : joint_setup.max_acceleration) / share);
        down = std::min(down,
                        (known ? joint_setup.programmed_deceleration : joint_setup.deceleration()) / share);
    }
    for (Eigen::Index joint = 0; joint < field.shares.size(); ++joint) {
        const Motor& motor = motors_[static_cast<std::size_t>(joint)];
        if (!motor.is_known()) continue;
        const double off = field.off.moved[0][joint];
        for (const EffortTerms& terms : field.terms) {
            const double moved = terms.moved[0][joint];
            for (const double sense : {1.0, -1.0}) {
                const double available =
                    motor.min_reserve(terms.effort(joint, sense), field.speed_scale(joint), part) -
                    field.off.max(joint, part);
                if (available < 0) return {};
                const double max = available / (std::abs(moved) + off);
                if (sense * moved > -off) up = std::min(up, max);
                if (sense * moved < off) down = std::min(down, max);
            }
        }
    }
    return {up * field.shares, down * field.shares, up, down};
}

/// Returns what all efforts without acceleration leave of each motor; below 0: nothing.
JointPos EffortLimits::available_efforts(const EffortField& field, double part) const {
    JointPos available = JointPos::Constant(field.shares.size(), kUnlimited);
    for (Eigen::Index joint = 0; joint < available.size(); ++joint) {
        const Motor& motor = motors_[static_cast<std::size_t>(joint)];
        if (!motor.is_known()) continue;
        for (const EffortTerms& terms : field.terms) {
            for (const double sense : {1.0, -1.0})
                available[joint] =
                    std::min(available[joint],
                             motor.min_reserve(terms.effort(joint, sense), field.speed_scale(joint), part));
        }
        available[joint] -= field.off.max(joint, part) + field.friction[joint];
    }
    return available;
}

/// Returns shares of the joints that move, in proportion to the acceleration that each could have alone.
EffortLimits::AccelerationBounds EffortLimits::any_direction_bounds(const EffortField& field,
                                                                    const std::vector<JointSetup>& joints,
                                                                    double part) const {
    const JointPos available = available_efforts(field, part);
    if ((available.array() < 0).any()) return {};
    const Eigen::Index count = available.size();
    JointPos standalone = JointPos::Zero(count);
    JointPos used = JointPos::Zero(count);
    for (std::size_t i = 0; i < field.moving.size(); ++i) {
        const int joint = field.moving[i];
        JointPos unit_efforts = JointPos::Zero(count);
        for (const EffortTerms& terms : field.terms)
            unit_efforts = unit_efforts.cwiseMax(terms.moved[i].cwiseAbs());
        unit_efforts += field.off.moved[i];
        const JointSetup& joint_setup = joints[static_cast<std::size_t>(joint)];
        const bool known = motors_[static_cast<std::size_t>(joint)].is_known();
        standalone[joint] =
            known ? std::min({available[joint] / unit_efforts[joint], joint_setup.programmed_acceleration,
                              joint_setup.programmed_deceleration})
                  : joint_setup.min_acceleration();
        used += standalone[joint] * unit_efforts;
    }
    double share = 1;
    for (Eigen::Index joint = 0; joint < count; ++joint) {
        if (used[joint] > available[joint]) share = std::min(share, available[joint] / used[joint]);
    }
    standalone *= share;
    double along = kUnlimited;
    for (const int joint : field.moving) along = std::min(along, standalone[joint] / field.shares[joint]);
    return {standalone, standalone, along, along};
}

EffortLimits::AccelerationBounds EffortLimits::acceleration_bounds(const EffortField& field,
                                                                   const std::vector<JointSetup>& joints,
                                                                   double part) const {
    return field.straight ? line_acceleration_bounds(field, joints, part)
                          : any_direction_bounds(field, joints, part);
}

EffortLimits::AccelerationBounds EffortLimits::best(const EffortField& field,
                                                    const std::vector<JointSetup>& joints,
                                                    LimitedPath& path) const {
    AccelerationBounds full = acceleration_bounds(field, joints, 1);
    const double at_standstill = acceleration_bounds(field, joints, kMinPart).min();
    if (path.length <= 0 || full.min() >= kSufficientShare * at_standstill) return full;
    const double needed = path.is_rest_to_rest ? 0 : kMaxLossShare * at_standstill;
    AccelerationBounds best;
    double min_s = kUnlimited;
    double best_speed_share = 1;
    for (double part = 1; part > kMinPart; part *= kStep) {
        const AccelerationBounds one = acceleration_bounds(field, joints, part);
        if (!(one.min() > 0) || one.min() < needed) continue;
        const double speed = std::min(part * path.max_speed, std::sqrt(one.min() / path.curvature));
        const double trial_time_s = time_s(path.length, speed, one.path_acceleration, one.path_deceleration);
        if (trial_time_s >= min_s) continue;
        min_s = trial_time_s;
        best = one;
        best_speed_share = part;
    }
    path.max_speed *= best_speed_share;
    return best;
}

int EffortLimits::weakest_joint(const EffortField& field) const {
    const JointPos available = available_efforts(field, kMinPart);
    Eigen::Index joint = 0;
    available.minCoeff(&joint);
    return static_cast<int>(joint);
}

motion::PlanResult EffortLimits::limit(LimitedPath& path, std::vector<JointSetup>& joints) const {
    JointPos shares = JointPos::Zero(path.points.front().slope.size());
    for (const PathPoint& point : path.points) shares = shares.cwiseMax(point.slope.cwiseAbs());
    limit_to_top_speeds(path, shares);
    const EffortField field = make_effort_field(path);
    const AccelerationBounds acceleration_bounds = best(field, joints, path);
    if (!(acceleration_bounds.min() > 0)) {
        return tl::unexpected(
            motion::PlanError{.status = rrs::Status::RRS_INVALID_PARAMETER,
                              .message = "The motor is too weak for this move: weight, friction and hoses "
                                         "alone use its full peak along the path.",
                              .joint = weakest_joint(field)});
    }
    for (const int joint : field.moving) {
        JointSetup& joint_setup = joints[static_cast<std::size_t>(joint)];
        joint_setup.max_acceleration = acceleration_bounds.up[joint];
        joint_setup.max_deceleration = acceleration_bounds.down[joint];
    }
    return {};
}

}  // namespace gsim::dynamics
