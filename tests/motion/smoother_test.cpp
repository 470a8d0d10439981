// Passing through corners takes no more time than stopping at them.

#include <numbers>
#include <random>

#include "tests/motion/look_ahead_path.h"

namespace gsim::motion::smoother_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// As samples/controllers/blend.toml has it.
PlannerSetup blending_setup(rrs::CornerRule corner, bool limit_jerk) {
    PlannerSetup setup = router_setup();
    setup.controller.corners.continuous = corner;
    setup.controller.corners.exact_path = rrs::CornerRule::velocity_step;
    setup.controller.blocks.look_ahead = 200;
    setup.controller.corners.speed_step_s = 0.002;
    setup.controller.ramps.centripetal_share = 0.866;
    setup.controller.ramps.limit_jerk = limit_jerk;
    for (JointSetup& joint : setup.joints) joint.max_jerk = 10 * joint.max_acceleration;
    return setup;
}

/// Returns the targets of a random program: lines of one size with corners of one kind, as CAM writes them.
std::vector<rrs::JointPos> random_way(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double length_mm = std::pow(10.0, 1.5 * uniform(random));
    const double bend_rad = 0.5 * kPi * std::pow(10.0, uniform(random) - 1);
    std::vector<rrs::JointPos> waypoints;
    rrs::JointPos at = rrs::JointPos::Zero(3);
    double heading = 0;
    for (int line = 0; line < 120; ++line) {
        const bool corner = uniform(random) > 0.9;
        heading += (corner ? kPi : bend_rad) * uniform(random);
        const double length = length_mm * (1.1 + uniform(random));
        at[0] += length * std::cos(heading);
        at[1] += length * std::sin(heading);
        at[2] += 0.1 * length * uniform(random);
        waypoints.push_back(at);
    }
    return waypoints;
}

double duration_s(const PlannerSetup& setup, const std::vector<rrs::JointPos>& waypoints, rrs::PathMode mode,
                  double speed_mm_s) {
    Path path(setup);
    path.mode = mode;
    for (const rrs::JointPos& end : waypoints) path.line(end, speed_mm_s);
    path.standstill();
    return path.out().segments.back().end_s();
}

class Smoother : public testing::TestWithParam<std::tuple<rrs::CornerRule, bool>> {};

TEST_P(Smoother, IsNotSlowerThanStopping) {
    const auto [corner, limit_jerk] = GetParam();
    const PlannerSetup setup = blending_setup(corner, limit_jerk);
    std::mt19937 random(23);
    for (int i = 0; i < 150; ++i) {
        const std::vector<rrs::JointPos> waypoints = random_way(random);
        const double speed_mm_s = i % 2 == 0 ? 20 : 200;
        const double blended_time_s = duration_s(setup, waypoints, rrs::PathMode::continuous, speed_mm_s);
        const double exact_s = duration_s(setup, waypoints, rrs::PathMode::exact_path, speed_mm_s);
        const double stopped_s = duration_s(setup, waypoints, rrs::PathMode::exact_stop, speed_mm_s);
        // An exact path costs jumps of speed, which a blend avoids.
        EXPECT_LE(blended_time_s, exact_s * 1.1) << i;
        EXPECT_LE(blended_time_s, stopped_s * (1 + 1e-9)) << i;
        EXPECT_LE(exact_s, stopped_s * (1 + 1e-9)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Corners, Smoother,
                         testing::Combine(testing::Values(rrs::CornerRule::smooth_blend,
                                                          rrs::CornerRule::parabolic_blend),
                                          testing::Bool()));

}  // namespace
}  // namespace gsim::motion::smoother_test
