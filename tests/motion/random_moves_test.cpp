// Random moves of a machine with every kind of joint and random limits: whatever is planned keeps the rules.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/path/axis_space.h"
#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::random_moves_test {
namespace {

using Eigen::Vector3d;
using rrs::Status;

constexpr int kMoves = 4000;

// Values programmed in a random case.
struct Programme {
    double speed, orientation_speed, acceleration, orientation_acceleration;
    bool rapid;
};

class RandomMoves : public testing::Test {
  protected:
    double number(double scale) { return std::uniform_real_distribution<double>(-scale, scale)(random); }
    double positive(double middle) { return middle * std::exp(number(2)); }
    bool coin() { return number(1) > 0; }

    rrs::JointPos random_target(const PlannerSetup& setup, double part) {
        rrs::JointPos q(setup.joint_count());
        const double scale = std::exp(number(4));
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const double reach = setup.role(joint) == JointRole::rotary ? 1 : 20;
            q[joint] = std::abs(number(1)) < part ? number(reach * scale) : 0;
        }
        return q;
    }

    Programme programme(DefaultPlanner& planner, bool may_rapid) {
        const Programme p{positive(100), coin() ? positive(0.5) : kUnlimited,
                          coin() ? positive(200) : kUnlimited, coin() ? positive(1) : kUnlimited,
                          may_rapid && coin()};
        planner.SetCartesianPositionSpeed(p.speed);
        planner.SetCartesianOrientationSpeed(p.orientation_speed);
        planner.SetCartesianPositionAcceleration(p.acceleration);
        planner.SetCartesianOrientationAcceleration(p.orientation_acceleration);
        planner.SetRapid(p.rapid);
        return p;
    }

    std::mt19937 random{31};
};

// Returns the time of linear motion by its rules, written down a second time. All joints are in proportion: a
// trapezoid that keeps the limits of each in its share of the path.
double proportional_time_s(const PlannerSetup& setup, const Programme& p, const rrs::JointPos& displacement) {
    double norm[3] = {0, 0, 0};
    for (int j = 0; j < displacement.size(); ++j)
        norm[static_cast<int>(setup.role(j))] += displacement[j] * displacement[j];
    for (double& n : norm) n = std::sqrt(n);
    const int master = norm[0] > 0 ? 0 : norm[1] > 0 ? 1 : 2;
    if (norm[master] == 0) return 0;
    double speed = kUnlimited, acceleration = kUnlimited;
    if (master != 2) {
        speed = p.rapid ? setup.path.max_rapid_mm_s : std::min(p.speed, setup.path.max_feed_mm_s);
        if (!p.rapid) acceleration = std::min(p.acceleration, setup.path.max_acceleration_mm_s2);
    }
    if (norm[2] > 0 && !p.rapid) {
        speed = std::min(speed, p.orientation_speed * norm[master] / norm[2]);
        acceleration = std::min(acceleration, p.orientation_acceleration * norm[master] / norm[2]);
    }
    for (int j = 0; j < displacement.size(); ++j) {
        if (displacement[j] == 0) continue;
        const double share = std::abs(displacement[j]) / norm[master];
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(j)];
        speed = std::min(speed, limits.max_speed / share);
        acceleration = std::min(acceleration, limits.max_acceleration / share);
    }
    return trapezoid_s(norm[master], speed, acceleration);
}

void expect_in_proportion(const Segment& segment) {
    const rrs::JointPos displacement = segment.end - segment.start;
    const double max_length = displacement.array().abs().maxCoeff();
    Eigen::Index leading = 0;
    displacement.array().abs().maxCoeff(&leading);
    for (int i = 0; i <= 60; ++i) {
        const rrs::JointPos gone = segment.position_at(segment.duration_s * i / 60) - segment.start;
        ASSERT_LT((gone - displacement * (gone[leading] / displacement[leading])).norm(),
                  1e-9 * (1 + max_length));
    }
}

// Returns the time with ramps of their own: lead trapezoid and one trapezoid for each follower.
double line_time_s(const PlannerSetup& setup, const Programme& p, const rrs::JointPos& displacement) {
    double norm[3] = {0, 0, 0};
    for (int j = 0; j < displacement.size(); ++j)
        norm[static_cast<int>(setup.role(j))] += displacement[j] * displacement[j];
    for (double& n : norm) n = std::sqrt(n);
    const int master = norm[0] > 0 ? 0 : norm[1] > 0 ? 1 : 2;
    const double turn_speed = p.rapid ? kUnlimited : p.orientation_speed;
    const double turn_acceleration = p.rapid ? kUnlimited : p.orientation_acceleration;
    double speed = master == 2
                       ? turn_speed
                       : (p.rapid ? setup.path.max_rapid_mm_s : std::min(p.speed, setup.path.max_feed_mm_s));
    double acceleration =
        master == 2 ? turn_acceleration
                    : (p.rapid ? kUnlimited : std::min(p.acceleration, setup.path.max_acceleration_mm_s2));
    double turn_limit = turn_acceleration;
    double slowest_follower = 0;
    for (int j = 0; j < displacement.size(); ++j) {
        if (displacement[j] == 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(j)];
        const int role = static_cast<int>(setup.role(j));
        const double share = std::abs(displacement[j]) / norm[role];
        if (role == master) {
            speed = std::min(speed, limits.max_speed / share);
            acceleration = std::min(acceleration, limits.max_acceleration / share);
        } else {
            const double joint_setup = role == 2
                                           ? std::min(limits.max_acceleration, turn_acceleration * share)
                                           : limits.max_acceleration;
            slowest_follower = std::max(
                slowest_follower, trapezoid_s(std::abs(displacement[j]), limits.max_speed, joint_setup));
        }
        if (role == 2) turn_limit = std::min(turn_limit, limits.max_acceleration / share);
    }
    // The programmed orientation speed is a rule of its own: the norm of the turn, with the acceleration that
    // joints leave.
    const double turn_s =
        master == 2 || norm[2] == 0 || (std::isinf(turn_speed) && std::isinf(turn_acceleration))
            ? 0
            : trapezoid_s(norm[2], turn_speed, turn_limit);
    return std::max(
        {norm[master] > 0 ? trapezoid_s(norm[master], speed, acceleration) : 0, slowest_follower, turn_s});
}

// The speed of orientation never passes the programmed one.
void expect_orientation_speed(const Segment& segment, const PlannerSetup& setup, double speed) {
    for (int i = 0; i <= 60; ++i) {
        const rrs::JointPos velocity = segment.at(segment.duration_s * i / 60).velocity;
        double square = 0;
        for (int j = 0; j < setup.joint_count(); ++j) {
            if (setup.role(j) == JointRole::rotary) square += velocity[j] * velocity[j];
        }
        ASSERT_LE(std::sqrt(square), speed * (1 + kRelative));
    }
}

void expect_straight(const Segment& segment, const PlannerSetup& setup) {
    const Vector3d start = read_position(setup, segment.start), end = read_position(setup, segment.end);
    if ((end - start).norm() == 0) return;
    const Vector3d direction = (end - start).normalized();
    for (int i = 0; i <= 60; ++i) {
        const Vector3d offset =
            read_position(setup, segment.position_at(segment.duration_s * i / 60)) - start;
        ASSERT_LT((offset - offset.dot(direction) * direction).norm(), kPath_mm);
    }
}

TEST_F(RandomMoves, LinesKeepLimitsAndTakeTimeOfSlowestRule) {
    for (int i = 0; i < kMoves; ++i) {
        SCOPED_TRACE(testing::Message() << "move " << i);
        PlannerSetup setup = odd_setup(random);
        setup.controller.coordination.independent_ramps = coin();
        const rrs::JointPos start = random_target(setup, 1), displacement = random_target(setup, 0.6);
        ReadyPlanner at(setup, start);
        at.planner.SelectMotionType(rrs::MotionType::linear);
        const Programme p = programme(at.planner, true);
        ASSERT_EQ(at.to(start + displacement), Status::RRS_SUCCESS) << at.message();
        const Segment& segment = at.last();
        const auto rule = setup.controller.coordination.independent_ramps ? line_time_s : proportional_time_s;
        const double expected_s = rule(setup, p, segment.end - segment.start);
        ASSERT_NEAR(segment.duration_s, expected_s, 1e-9 * expected_s);
        if (expected_s == 0) continue;
        if (!setup.controller.coordination.independent_ramps) expect_in_proportion(segment);
        expect_joint_limits(segment, setup);
        expect_straight(segment, setup);
        expect_smooth(segment);
        if (!p.rapid) expect_orientation_speed(segment, setup, p.orientation_speed);
        if (segment.length_mm > 0)
            expect_path_limits(
                segment, p.rapid ? setup.path.max_rapid_mm_s : std::min(p.speed, setup.path.max_feed_mm_s),
                p.rapid ? kUnlimited : std::min(p.acceleration, setup.path.max_acceleration_mm_s2));
        if (HasFatalFailure()) return;
    }
}

TEST_F(RandomMoves, JointMovesKeepLimitsWithOneJointAtLimit) {
    for (int i = 0; i < kMoves; ++i) {
        SCOPED_TRACE(testing::Message() << "move " << i);
        const PlannerSetup setup = odd_setup(random);
        const rrs::JointPos start = random_target(setup, 1), displacement = random_target(setup, 0.6);
        ReadyPlanner at(setup, start);
        ASSERT_EQ(at.to(start + displacement), Status::RRS_SUCCESS) << at.message();
        const Segment& segment = at.last();
        double speed = kUnlimited, acceleration = kUnlimited;
        const rrs::JointPos moved = segment.end - segment.start;
        for (int j = 0; j < setup.joint_count(); ++j) {
            if (moved[j] == 0) continue;
            speed = std::min(speed, setup.joints[static_cast<std::size_t>(j)].max_speed / std::abs(moved[j]));
            acceleration = std::min(acceleration, setup.joints[static_cast<std::size_t>(j)].max_acceleration /
                                                      std::abs(moved[j]));
        }
        if (std::isinf(speed)) continue;
        ASSERT_NEAR(segment.duration_s, trapezoid_s(1, speed, acceleration), 1e-9 * segment.duration_s);
        expect_joint_limits(segment, setup);
        expect_smooth(segment);
        if (HasFatalFailure()) return;
    }
}

TEST_F(RandomMoves, ArcsAndHelicesKeepLimitsAndCircle) {
    for (int i = 0; i < kMoves; ++i) {
        SCOPED_TRACE(testing::Message() << "move " << i);
        const PlannerSetup setup = odd_setup(random);
        const rrs::JointPos start = random_target(setup, 1);
        const Vector3d from = read_position(setup, start);
        const Vector3d center = from + Vector3d(number(50), number(50), number(50));
        const Vector3d axis =
            coin() ? Vector3d::Unit(i % 3) : Vector3d(number(1), number(1), number(1)).normalized();
        const double sweep = std::abs(number(15)) + 1e-3, rise = coin() ? number(30) : 0;
        rrs::JointPos end = start + random_target(setup, 0.5);
        const Vector3d to = center + Eigen::AngleAxisd(sweep, axis) * (from - center) + rise * axis;
        for (int a = 0; a < 3; ++a) end[setup.position_joints[static_cast<std::size_t>(a)]] = to[a];
        ReadyPlanner at(setup, start);
        const Programme p = programme(at.planner, false);
        ASSERT_EQ(at.arc_to(end, center, axis, sweep), Status::RRS_SUCCESS) << at.message();
        const Segment& segment = at.last();
        const double radius = (from - center - axis.dot(from - center) * axis).norm();
        ASSERT_NEAR(segment.length_mm, std::hypot(radius * sweep, rise), 1e-6);
        expect_joint_limits(segment, setup);
        expect_path_limits(segment, std::min(p.speed, setup.path.max_feed_mm_s),
                           std::min(p.acceleration, setup.path.max_acceleration_mm_s2));
        expect_orientation_speed(segment, setup, p.orientation_speed);
        expect_smooth(segment);
        for (int k = 0; k <= 60; ++k) {
            const double t = segment.duration_s * k / 60;
            const double part = segment.master.at(t).s / segment.master.length();
            const Vector3d expected =
                center + Eigen::AngleAxisd(part * sweep, axis) * (from - center) + part * rise * axis;
            ASSERT_LT((read_position(setup, segment.position_at(t)) - expected).norm(), kPath_mm);
            const Vector3d velocity = read_position(setup, segment.at(t).velocity);
            ASSERT_NEAR(velocity.norm(), segment.path_speed_mm_s(t), 1e-9 * (1 + velocity.norm()));
        }
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace gsim::motion::random_moves_test
