// The jerks and accelerations that joints get round arcs and helices, however these lie in space.
#include "motion/path/arc_limits.h"

#include <Eigen/Geometry>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"

namespace gsim::motion::arc_limits_test {
namespace {

using Eigen::Vector3d;

enum class Lie { along_axes, askew };

class ArcLimits : public testing::Test {
  protected:
    double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }

    PlannerSetup machine(rrs::PlannerKind planner, bool jerk) {
        PlannerSetup setup = gantry_setup();
        for (JointSetup& joint : setup.joints) {
            joint.min = -kUnlimited;
            joint.max = kUnlimited;
            joint.max_acceleration *= std::exp(number());
            joint.max_deceleration = joint.max_acceleration * std::exp(number());
            joint.max_jerk = joint.max_acceleration * std::exp(3 * number() + 2);
        }
        setup.path = {};
        setup.controller.planner = planner;
        setup.controller.ramps.limit_jerk = jerk;
        setup.controller.ramps.centripetal_share = 0.5 + 0.45 * number();
        return setup;
    }

    /// Returns an arc or helix from standstill to standstill in a plane of its own, now and then with radii
    /// that disagree.
    std::vector<Segment> arc_move(const PlannerSetup& setup, Lie lie) {
        ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
        ready.planner.SetCartesianPositionSpeed(20 + 300 * std::abs(number()));
        const double radius = std::exp(3 + 2 * number()), sweep = 0.2 + 5 * std::abs(number());
        Vector3d axis = Vector3d::UnitZ();
        if (lie == Lie::askew) axis = Vector3d(number(), number(), number()).normalized();
        const Vector3d out = axis.unitOrthogonal();
        const double end_radius = radius + (number() > 0 ? 0.04 * number() : 0);
        const double ascent = number() > 0 ? 2 * radius * number() : 0;
        rrs::JointPos end = rrs::JointPos::Zero(5);
        end.head<3>() = -radius * out + end_radius * (Eigen::AngleAxisd(sweep, axis) * out) + ascent * axis;
        if (number() > 0.3) end[3] = 0.3 * number();
        EXPECT_EQ(ready.arc_to(end, -radius * out, axis, sweep), rrs::Status::RRS_SUCCESS) << ready.message();
        ready.planner.flush();
        return ready.collector.segments;
    }

    std::mt19937 random{61};
};

/// Checks jerks by differences of the accelerations, within the parts of the law.
void expect_jerks(const Segment& segment, const PlannerSetup& setup) {
    double start_s = 0;
    for (const LawSection& section : segment.master.sections()) {
        for (const double share : {0.002, 0.1, 0.3, 0.5, 0.7, 0.9, 0.998}) {
            const double h = 1e-4 * section.duration_s;
            const double t_s = start_s + share * section.duration_s;
            const rrs::JointPos jerk =
                (segment.at(t_s + h).acceleration - segment.at(t_s - h).acceleration) / (2 * h);
            for (int joint = 0; joint < 3; ++joint) {
                const JointSetup& joint_setup = setup.joints[static_cast<std::size_t>(joint)];
                const double rounding = 1e-10 * joint_setup.max_acceleration / h;
                ASSERT_LE(std::abs(jerk[joint]), joint_setup.max_jerk * (1 + 1e-5) + rounding)
                    << "joint " << joint;
            }
        }
        start_s += section.duration_s;
    }
}

TEST_F(ArcLimits, KeepsJointJerkLimits) {
    for (int run = 0; run < 600; ++run) {
        const auto planner = run % 2 == 0 ? rrs::PlannerKind::rest_to_rest : rrs::PlannerKind::look_ahead;
        const PlannerSetup setup = machine(planner, true);
        for (const Segment& segment : arc_move(setup, run % 3 == 0 ? Lie::askew : Lie::along_axes))
            ASSERT_NO_FATAL_FAILURE(expect_jerks(segment, setup)) << "run " << run;
    }
}

TEST_F(ArcLimits, KeepsJointAccelerationLimits) {
    for (int run = 0; run < 400; ++run) {
        const PlannerSetup setup = machine(rrs::PlannerKind::look_ahead, run % 4 == 0);
        for (const Segment& segment : arc_move(setup, run % 3 == 0 ? Lie::along_axes : Lie::askew)) {
            for (int i = 0; i <= 60; ++i) {
                const rrs::JointPos acceleration = segment.at(segment.duration_s * i / 60).acceleration;
                for (int joint = 0; joint < 3; ++joint) {
                    const JointSetup& joint_setup = setup.joints[static_cast<std::size_t>(joint)];
                    const double limit = std::max(joint_setup.max_acceleration, joint_setup.deceleration());
                    ASSERT_LE(std::abs(acceleration[joint]), limit * (1 + 1e-9))
                        << "joint " << joint << " run " << run;
                }
            }
        }
    }
}

/// If all three parts are as large as permitted, on a circle: jerk / (1 + sqrt 2) for each.
TEST_F(ArcLimits, SplitsJerkOfCircleIntoEqualParts) {
    PlannerSetup setup = machine(rrs::PlannerKind::look_ahead, true);
    for (JointSetup& joint : setup.joints) joint.max_jerk = 1000;
    const Arc circle{.radius_mm = 20, .end_radius_mm = 20, .sweep_rad = 6};
    MasterPath master{.length = circle.length_mm()};
    limit_by_arc_jerk(setup, circle, master);
    const double part = 1000 / (1 + std::sqrt(2));
    EXPECT_NEAR(master.limits.jerk, part, 1e-9);
    EXPECT_NEAR(master.limits.max_speed, std::cbrt(part * 20 * 20), 1e-9);
    EXPECT_NEAR(3 * master.limits.max_speed * master.limits.acceleration / 20, part, 1e-9);
}

}  // namespace
}  // namespace gsim::motion::arc_limits_test
