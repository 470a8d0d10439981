// Effect of many corners close together on the joints: a polygon is driven as the curve that it represents.

#include "motion/lookahead/corner_window.h"

#include <numbers>
#include <random>

#include "tests/motion/look_ahead_path.h"
#include "tests/motion/motion_checks.h"

namespace gsim::motion::corner_window_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAcceleration = 500;  // mm/s2, of each joint
constexpr double kStep = 5;            // mm/s

/// Corners by the steps of the joints' speeds, as the 9/Series' model has it.
PlannerSetup stepping_setup() {
    PlannerSetup setup = router_setup();
    setup.controller.corners.continuous = setup.controller.corners.exact_path =
        rrs::CornerRule::velocity_step;
    setup.controller.blocks.look_ahead = 400;
    setup.controller.ramps.centripetal_share = 0.866;
    for (JointSetup& joint : setup.joints) {
        joint.max_acceleration = kAcceleration;
        joint.max_deceleration = {};
        joint.max_speed_step = kStep;
    }
    return setup;
}

double duration_s(const Path& path) {
    return path.out().segments.empty() ? 0 : path.out().segments.back().end_s();
}

void polygon(Path& path, int sides, double radius_mm) {
    const double x0 = path.position()[0] - radius_mm;
    const double y0 = path.position()[1];
    for (int i = 1; i <= sides; ++i) {
        const double angle = 2 * kPi * i / sides;
        path.line(x0 + radius_mm * std::cos(angle), y0 + radius_mm * std::sin(angle));
    }
}

/// Velocities of the joints each 0.1 ms.
std::vector<rrs::JointPos> velocities(const Path& path) {
    constexpr double kPeriod_s = 1e-4;
    std::vector<rrs::JointPos> velocities;
    double t_s = 0;
    for (const Segment& segment : path.out().segments) {
        for (; t_s < segment.end_s(); t_s += kPeriod_s)
            velocities.push_back(segment.at(t_s - segment.start_s).velocity);
    }
    return velocities;
}

/// The greatest change of a joint's speed in a window of time, beyond its step, as a share of what its
/// acceleration makes in that time.
double excess(const std::vector<rrs::JointPos>& velocities, std::size_t window) {
    double max = 0;
    for (std::size_t i = window; i < velocities.size(); ++i)
        max = std::max(max, (velocities[i] - velocities[i - window]).cwiseAbs().maxCoeff());
    return (max - kStep) / (kAcceleration * static_cast<double>(window) * 1e-4);
}

/// Expects that jumps by the corners, beyond a step, stay within their share of the acceleration; ramps may
/// be added.
void expect_bounded(const Path& path) {
    const double bound = 1 + path.setup().controller.ramps.centripetal_share;
    const auto all = velocities(path);
    for (const std::size_t window : {10U, 20U, 50U, 100U, 200U})
        EXPECT_LE(excess(all, window), bound) << window;
}

TEST(CornerWindow, PolygonTakesAboutTimeOfArc) {
    for (const double radius_mm : {2.0, 5.0, 10.0, 20.0}) {
        Path arc(stepping_setup());
        arc.arc(radius_mm, 0, 2 * kPi, 100);
        arc.standstill();
        for (const int sides : {144, 180, 360, 720}) {
            Path path(stepping_setup());
            polygon(path, sides, radius_mm);
            path.standstill();
            const double ratio = duration_s(path) / duration_s(arc);
            // On slanting lines each joint has less to do than on an arc, which has the same limit all round.
            EXPECT_GT(ratio, 0.88) << radius_mm << " mm, " << sides;
            EXPECT_LT(ratio, 1.05) << radius_mm << " mm, " << sides;
        }
    }
}

TEST(CornerWindow, SeventyTwoChordsKeepAccelerationLimit) {
    Path path(stepping_setup());
    polygon(path, 72, 5);
    path.standstill();
    const auto all = velocities(path);
    // Over 10 ms the joints took 2.65 times their acceleration, one step and this is what they may.
    EXPECT_LE(excess(all, 100), 1.0);
    expect_bounded(path);
}

TEST(CornerWindow, RandomPathsKeepSpeedStepAndAcceleration) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        Path path(stepping_setup());
        const double length_mm = std::pow(10.0, 1.2 * uniform(random));
        const double bend_rad = 0.3 * (1 + uniform(random));
        double heading = kPi * uniform(random);
        for (int line = 0; line < 150; ++line) {
            const bool corner = uniform(random) > 0.95;
            const double turn = uniform(random);
            heading += corner ? kPi * turn : bend_rad * (turn + 0.5);
            const double length = length_mm * (1.1 + uniform(random));
            rrs::JointPos end = path.position();
            end[0] += length * std::cos(heading);
            end[1] += length * std::sin(heading);
            end[2] += 0.2 * length * uniform(random);
            path.line(end);
        }
        path.standstill();
        expect_bounded(path);
        const auto& segments = path.out().segments;
        expect_joined({segments.begin(), segments.end()});
    }
}

TEST(CornerWindow, DistantCornersEachUseFullSpeedStep) {
    Path path(stepping_setup());
    path.line(50, 0);
    path.line(50, 50);
    path.line(100, 50);
    path.standstill();
    EXPECT_NEAR(path.exit_speed(0), kStep, 1e-9);
    EXPECT_NEAR(path.exit_speed(1), kStep, 1e-9);
}

TEST(CornerWindow, CloseCornersShareOneSpeedStep) {
    Path path(stepping_setup());
    path.line(50, 0);
    const double turn = kPi / 6;
    rrs::JointPos next = path.position();
    next[0] += 0.001 * std::cos(turn);
    next[1] += 0.001 * std::sin(turn);
    path.line(next);
    next[0] += 50 * std::cos(2 * turn);
    next[1] += 50 * std::sin(2 * turn);
    path.line(next);
    path.standstill();
    const double both = std::sin(2 * turn);  // of Y; X turns by less
    EXPECT_NEAR(path.exit_speed(1), kStep / both, 0.1);
}

}  // namespace
}  // namespace gsim::motion::corner_window_test
