// Efforts against closed forms.
#include "motion/dynamics/dynamics.h"

#include <gtest/gtest.h>

#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

using Eigen::Vector3d;

constexpr double kG = 9.80665;
constexpr double kRelative = 1e-9;

void expect_near(double value, double expected_value, double scale) {
    EXPECT_NEAR(value, expected_value, kRelative * std::max(std::abs(expected_value), 1e-3 * scale));
}

Dynamics::Motion motion_of(const rrs::JointPos& position, const rrs::JointPos& velocity,
                           const rrs::JointPos& acceleration) {
    return {position, velocity, acceleration, motion_directions(velocity)};
}

/// Returns X carrying Y, and Y carrying Z; each has its own mass.
Chain gantry() {
    return Chain({.base = rrs::CartPos::Identity(),
                  .links = {joint(0, rrs::JointKind::prismatic, Vector3d::UnitX()),
                            joint(1, rrs::JointKind::prismatic, Vector3d::UnitY()),
                            joint(2, rrs::JointKind::prismatic, Vector3d::UnitZ())},
                  .end = rrs::CartPos::Identity()});
}

TEST(Dynamics, GantryEffortIsInertiaPlusWeightPlusFriction) {
    DynamicsModel model = model_of({point_mass(120, {0.3, 0.7, -0.2}), point_mass(45), point_mass(18)});
    model.tool = point_mass(3.5, {0, 0, 0.1});
    model.drives[0] = {.coulomb_friction = 60, .viscous = 150, .rotor = 22, .counterweight = 0};
    model.drives[1] = {.coulomb_friction = 25, .viscous = 80, .rotor = 9, .counterweight = 0};
    model.drives[2] = {.coulomb_friction = 15, .viscous = 40, .rotor = 6, .counterweight = 150};
    const Dynamics dynamics(gantry(), model);
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const rrs::JointPos v = random.joints(3, 500);  // mm/s
        const rrs::JointPos a = random.joints(3, 9000);
        const Efforts efforts = dynamics.efforts(motion_of(random.joints(3, 2000), v, a));
        const auto sign = [&](int joint) { return v[joint] > 0 ? 1 : -1; };
        expect_near(efforts[0], (120 + 45 + 18 + 3.5 + 22) * a[0] / 1000 + 60 * sign(0) + 0.150 * v[0], 1000);
        expect_near(efforts[1], (45 + 18 + 3.5 + 9) * a[1] / 1000 + 25 * sign(1) + 0.080 * v[1], 1000);
        expect_near(efforts[2],
                    (18 + 3.5 + 6) * a[2] / 1000 + (18 + 3.5) * kG + 15 * sign(2) + 0.040 * v[2] - 150, 1000);
    }
}

TEST(Dynamics, TwoLinkArmMatchesTextbook) {
    // Spong, Hutchinson, Vidyasagar: Robot Modeling and Control, 2006, section 7.4: the planar elbow arm in a
    // vertical plane, with distances lc1 and lc2 of the centres and moments about them.
    constexpr double kL1 = 0.6, kC1 = 0.25, kC2 = 0.2, kM1 = 11, kM2 = 7, kI1 = 0.4, kI2 = 0.15;
    const Chain arm({.base = rrs::CartPos::Identity(),
                     .links = {joint(0, rrs::JointKind::revolute, Vector3d::UnitZ()),
                               joint(1, rrs::JointKind::revolute, Vector3d::UnitZ(), {1000 * kL1, 0, 0})},
                     .end = rrs::CartPos::Identity()});
    const auto bar = [](double mass_kg, double centre_m, double moment) {
        return RigidBody{.mass_kg = mass_kg,
                         .centre_m = {centre_m, 0, 0},
                         .inertia_kg_m2 = Vector3d(0, moment, moment).asDiagonal()};
    };
    DynamicsModel model = model_of({bar(kM1, kC1, kI1), bar(kM2, kC2, kI2)});
    model.gravity_m_s2 = {0, -kG, 0};
    const Dynamics dynamics(arm, model);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const rrs::JointPos q = random.joints(2, 3);
        const rrs::JointPos v = random.joints(2, 5);
        const rrs::JointPos a = random.joints(2, 40);
        const double c2 = std::cos(q[1]);
        const double d11 = kM1 * kC1 * kC1 + kM2 * (kL1 * kL1 + kC2 * kC2 + 2 * kL1 * kC2 * c2) + kI1 + kI2;
        const double d12 = kM2 * (kC2 * kC2 + kL1 * kC2 * c2) + kI2;
        const double d22 = kM2 * kC2 * kC2 + kI2;
        const double h = -kM2 * kL1 * kC2 * std::sin(q[1]);
        const double g2 = kM2 * kC2 * kG * std::cos(q[0] + q[1]);
        const double g1 = (kM1 * kC1 + kM2 * kL1) * kG * std::cos(q[0]) + g2;
        const Efforts efforts = dynamics.efforts(motion_of(q, v, a));
        expect_near(efforts[0], d11 * a[0] + d12 * a[1] + 2 * h * v[0] * v[1] + h * v[1] * v[1] + g1, 500);
        expect_near(efforts[1], d12 * a[0] + d22 * a[1] - h * v[0] * v[0] + g2, 100);
    }
}

TEST(Dynamics, TiltingTableHoldsOffAxisMass) {
    // The table turns about X, with a mass 30 mm off and 80 mm above: J a, and the weight's lever.
    const Chain table({}, {.base = rrs::CartPos::Identity(),
                           .links = {joint(0, rrs::JointKind::revolute, Vector3d::UnitX())},
                           .end = rrs::CartPos::Identity()});
    DynamicsModel model = model_of({{}});
    model.work = {
        .mass_kg = 25, .centre_m = {0.5, 0.03, 0.08}, .inertia_kg_m2 = 0.2 * Eigen::Matrix3d::Identity()};
    model.drives[0] = {.coulomb_friction = 4, .viscous = 2, .rotor = 0.7, .counterweight = 1.5};
    const Dynamics dynamics(table, model);
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const double q = random.from(-3, 3);
        const double v = random.from(0.01, 4);
        const double a = random.from(-20, 20);
        const double moment = 0.2 + 25 * (0.03 * 0.03 + 0.08 * 0.08) + 0.7;
        const double lever_m = 0.03 * std::cos(q) - 0.08 * std::sin(q);
        const Efforts efforts = dynamics.efforts(motion_of(joint_pos({q}), joint_pos({v}), joint_pos({a})));
        expect_near(efforts[0], moment * a + 25 * kG * lever_m + 4 + 2 * v - 1.5, 50);
    }
}

TEST(Dynamics, HosePullsIfStretchedAndDragsIfMoved) {
    DynamicsModel model = model_of({point_mass(1), point_mass(1), point_mass(1)});
    model.gravity_m_s2.setZero();
    model.hoses.push_back({.end = HoseEnd::tool,
                           .joint = 0,
                           .point_m = {0, 0, 0.2},
                           .anchor_m = {0, 0, 3.2},
                           .free_length_m = 2,
                           .stiffness_n_per_m = 50,
                           .drag_n_s_per_m = 8});
    const Dynamics dynamics(gantry(), model);
    const rrs::JointPos zero = joint_pos({0, 0, 0});
    // 3 m above the point: 1 m beyond its length.
    EXPECT_NEAR(dynamics.efforts(motion_of(zero, zero, zero))[2], -50, 1e-12);
    // 5 m, 3 along X and 4 along Z: 3 m beyond.
    const Efforts slanted = dynamics.efforts(motion_of(joint_pos({3000, 0, -1000}), zero, zero));
    EXPECT_NEAR(slanted[0], 150 * 0.6, 1e-10);
    EXPECT_NEAR(slanted[2], -150 * 0.8, 1e-10);
    // Slack, and dragged at 0.5 m/s.
    const Efforts slack = dynamics.efforts(motion_of(joint_pos({0, 0, 1500}), joint_pos({0, 500, 0}), zero));
    EXPECT_NEAR(slack[1], 4, 1e-12);
    EXPECT_NEAR(slack[2], 0, 1e-12);
}

TEST(Dynamics, WorkpieceNeedsSameEffortsAsTool) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const Chain one = random.chain(4, 0);
        const Chain other(Branch{}, one.tool_side());
        DynamicsModel model = random.model(4);
        model.hoses.clear();
        DynamicsModel swapped = model;
        std::swap(swapped.tool, swapped.work);
        const Dynamics::Motion motion =
            motion_of(random.joints(4, 3), random.joints(4, 3), random.joints(4, 20));
        const Efforts by_tool = Dynamics(one, model).efforts(motion);
        const Efforts by_work = Dynamics(other, swapped).efforts(motion);
        EXPECT_LT((by_tool - by_work).norm(), 1e-12 * by_tool.norm());
    }
}

TEST(Dynamics, EffortAtStandstillIsWeightOnly) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const Chain chain = random.chain(3, 2);
        DynamicsModel model = random.model(5);
        model.hoses.clear();
        for (JointDrive& drive : model.drives) drive.counterweight = 0;
        const rrs::JointPos q = random.joints(5, 2);
        const rrs::JointPos zero = rrs::JointPos::Zero(5);
        const Efforts static_efforts = Dynamics(chain, model).efforts(motion_of(q, zero, zero));
        // In a lift in free fall no weight has to be held.
        model.gravity_m_s2 *= 2;
        EXPECT_LT((Dynamics(chain, model).efforts(motion_of(q, zero, zero)) - 2 * static_efforts).norm(),
                  1e-12 * static_efforts.norm());
        model.gravity_m_s2.setZero();
        EXPECT_EQ(Dynamics(chain, model).efforts(motion_of(q, zero, zero)).norm(), 0);
    }
}

TEST(Dynamics, InertialEffortsFollowSymmetricMassMatrix) {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const Chain chain = random.chain(3, 2);
        const Dynamics dynamics(chain, random.model(5));
        const rrs::JointPos q = random.joints(5, 2);
        const rrs::JointPos v = random.joints(5, 2);
        const rrs::JointPos a = random.joints(5, 20);
        const rrs::JointPos zero = rrs::JointPos::Zero(5);
        const Efforts full = dynamics.efforts(motion_of(q, v, a));
        const Efforts standstill = dynamics.efforts(motion_of(q, v, zero));
        EXPECT_LT((full - standstill - dynamics.inertial_efforts(q, a)).norm(), 1e-10 * full.norm());
        // The matrix is symmetric: the effort on one joint by another's acceleration equals that in reverse
        // (in m and rad).
        const auto si = [&](int joint, double value) {
            return chain.kind(joint) == rrs::JointKind::prismatic ? 1000 * value : value;
        };
        for (int m = 0; m < 5; ++m) {
            for (int n = 0; n < m; ++n) {
                rrs::JointPos first = zero;
                rrs::JointPos second = zero;
                first[m] = si(m, 1);
                second[n] = si(n, 1);
                EXPECT_NEAR(dynamics.inertial_efforts(q, first)[n], dynamics.inertial_efforts(q, second)[m],
                            1e-11);
            }
        }
    }
}

TEST(Dynamics, RejectsModelWithMissingLinks) {
    EXPECT_THROW(Dynamics(gantry(), model_of({{}, {}})), std::invalid_argument);
}

TEST(Dynamics, SpeedWithinRoundingHasNoDirection) {
    EXPECT_EQ(motion_directions(joint_pos({1e-12, -0.1, 3, 0})), joint_pos({0, -1, 1, 0}));
}

}  // namespace
}  // namespace gsim::dynamics
