// Sums over segments against closed forms and against fine integration.
#include "motion/dynamics/segment_efforts.h"

#include <gtest/gtest.h>

#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

Dynamics three_slide_machine(double coulomb_friction, double viscous) {
    const Chain chain({.base = rrs::CartPos::Identity(),
                       .links = {joint(0, rrs::JointKind::prismatic, Eigen::Vector3d::UnitX()),
                                 joint(1, rrs::JointKind::prismatic, Eigen::Vector3d::UnitY()),
                                 joint(2, rrs::JointKind::prismatic, Eigen::Vector3d::UnitZ())},
                       .end = rrs::CartPos::Identity()});
    DynamicsModel model = model_of({point_mass(80), point_mass(30), point_mass(12)});
    for (JointDrive& drive : model.drives) drive = {.coulomb_friction = coulomb_friction, .viscous = viscous};
    return Dynamics(chain, model);
}

motion::Segment line(const rrs::JointPos& from, const rrs::JointPos& to, double speed, double acceleration) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::linear;
    segment.start = from;
    segment.end = to;
    segment.length_mm = (to - from).norm();
    segment.master = motion::TimeLaw::fastest(segment.length_mm, speed, acceleration);
    segment.duration_s = segment.master.duration_s();
    segment.position_joints = {0, 1, 2};
    return segment;
}

TEST(SegmentEfforts, TrapezoidMatchesHandCalculation) {
    const Dynamics dynamics = three_slide_machine(40, 0);
    SegmentEfforts efforts(dynamics);
    double peak = 0;
    const EffortSums sums =
        efforts.sums(line(joint_pos({0, 0, 0}), joint_pos({500, 0, 0}), 500, 2000),
                     [&](const EffortSample& sample) { peak = std::max(peak, sample.efforts[0]); });
    // 0.25 s with 122 kg 2 m/s2 and 40 N, 0.75 s with 40 N, 0.25 s with 40 N less than 244 N to brake.
    EXPECT_NEAR(peak, 284, 1e-9);
    EXPECT_NEAR(sums.squares[0], 0.25 * 284 * 284 + 0.75 * 1600 + 0.25 * 204 * 204, 1e-6);
    EXPECT_NEAR(sums.drive_j[0], 284 * 0.0625 + 40 * 0.375, 1e-9);
    EXPECT_NEAR(sums.regenerated_j[0], 204 * 0.0625, 1e-9);
    EXPECT_NEAR(sums.friction_j[0], 40 * 0.5, 1e-9);
    EXPECT_NEAR(sums.squares[1], 0, 1e-20);
    EXPECT_NEAR(sums.squares[2], 1.25 * std::pow(12 * 9.80665, 2), 1e-6);
    EXPECT_EQ(sums.drive_j[2], 0);
}

TEST(SegmentEfforts, StandstillHoldsWeight) {
    const Dynamics dynamics = three_slide_machine(40, 3);
    motion::Segment standstill;
    standstill.start = standstill.end = joint_pos({0, 0, 0});
    standstill.duration_s = 4;
    const EffortSums sums = SegmentEfforts(dynamics).sums(standstill, [](const EffortSample&) {});
    EXPECT_NEAR(sums.squares[2], 4 * std::pow(12 * 9.80665, 2), 1e-6);
    EXPECT_NEAR(sums.squares[0] + sums.drive_j.sum() + sums.regenerated_j.sum() + sums.friction_j.sum(), 0,
                1e-20);
}

// Along a full circle at constant speed each slide reverses twice, and Coulomb's friction with it.
TEST(SegmentEfforts, CircleAtConstantSpeedMatchesClosedForm) {
    const Dynamics dynamics = three_slide_machine(40, 100);
    constexpr double kRadius_m = 0.05;
    constexpr double kSpeed_m_s = 0.2;
    motion::Segment segment;
    segment.kind = motion::SegmentKind::circular;
    segment.start = segment.end = joint_pos({50, 0, 0});
    segment.position_joints = {0, 1, 2};
    segment.arc.radius_mm = segment.arc.end_radius_mm = 1000 * kRadius_m;  // from X towards Y
    segment.arc.sweep_rad = 2 * std::numbers::pi;
    segment.length_mm = 1000 * 2 * std::numbers::pi * kRadius_m;
    segment.master = motion::TimeLaw::fastest(segment.length_mm, 1000 * kSpeed_m_s,
                                              std::numeric_limits<double>::infinity());
    segment.duration_s = segment.master.duration_s();
    const EffortSums sums = SegmentEfforts(dynamics).sums(segment, [](const EffortSample&) {});
    const double time_s = 2 * std::numbers::pi * kRadius_m / kSpeed_m_s;
    EXPECT_NEAR(sums.friction_j[0], 40 * 4 * kRadius_m + 100 * kSpeed_m_s * kSpeed_m_s / 2 * time_s, 1e-7);
    EXPECT_NEAR(sums.drive_j[1] - sums.regenerated_j[1], sums.friction_j[1], 1e-7);
    // m a and friction are a quarter of a turn out of phase: their product is 0 in total.
    const double inertia = 122 * kSpeed_m_s * kSpeed_m_s / kRadius_m;
    const double viscous = 100 * kSpeed_m_s;
    const double both = 2 * 40 * viscous * 2 / std::numbers::pi;
    EXPECT_NEAR(sums.squares[0], time_s * (inertia * inertia / 2 + viscous * viscous / 2 + 1600 + both),
                1e-4);
}

}  // namespace
}  // namespace gsim::dynamics
