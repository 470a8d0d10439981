// Corners in G64: blend arcs within the tolerance, parabolic blends if rotary joints move.

#include <random>

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::linuxcnc_blend_test {
namespace {

constexpr double kA = 490.3;

double distance_to(const LinuxcncRun& run, double x, double y) {
    double nearest = 1e9;
    for (double t_s = 0; t_s <= run.end_s; t_s += 2e-4) {
        const rrs::JointPos at = run.position_at(t_s);
        nearest = std::min(nearest, std::hypot(at[0] - x, at[1] - y));
    }
    return nearest;
}

TEST(LinuxcncBlend, DeviatesFromCornerByTolerance) {
    for (const double tolerance_mm : {0.05, 0.5, 5.0}) {
        LinuxcncRun run(fast_machine());
        run.next.mode = rrs::PathMode::continuous;
        run.next.tolerance_mm = tolerance_mm;
        ASSERT_TRUE(run.line(100, 0));
        ASSERT_TRUE(run.line(100, 100));
        run.end();
        expect_chain(run);
        EXPECT_NEAR(distance_to(run, 100, 0), tolerance_mm, 1e-3);
        ASSERT_EQ(run.segments.size(), 3u);
        const Segment& blend = run.segments[1];
        EXPECT_EQ(blend.kind, SegmentKind::circular);
        EXPECT_EQ(blend.target_id, 2);
        EXPECT_NEAR(blend.deviation_mm, tolerance_mm, 1e-9);
        EXPECT_EQ(run.segments[0].deviation_mm + run.segments[2].deviation_mm, 0);
        // From corner to centre is R sqrt 2. The arc of a right angle therefore misses the corner by R (sqrt
        // 2 - 1). The speed on it takes 0.866 of the acceleration.
        const double radius_mm = tolerance_mm / (std::sqrt(2.0) - 1);
        EXPECT_NEAR(blend.arc.radius_mm, radius_mm, 1e-9 * radius_mm);
        EXPECT_NEAR(blend.master.peak_speed(), std::min(100.0, std::sqrt(std::sqrt(0.75) * kA * radius_mm)),
                    1e-6);
    }
}

TEST(LinuxcncBlend, UsesHalfOfLineWithoutTolerance) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    run.next.rules.programmed_speed_mm_s = 254;
    ASSERT_TRUE(run.line(100, 0));
    ASSERT_TRUE(run.line(100, 100));
    run.end();
    // A quarter of the line as tolerance would do for a larger radius than half of the line, which is 50 mm.
    EXPECT_NEAR(distance_to(run, 100, 0), 50 * (std::sqrt(2.0) - 1), 1e-3);
}

TEST(LinuxcncBlend, JoinsLinesAndArcsTangentially) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> number(-1, 1);
    int blends = 0;
    for (int i = 0; i < 400; ++i) {
        LinuxcncRun run(fast_machine());
        run.next.mode = rrs::PathMode::continuous;
        run.next.tolerance_mm = 0.2;
        const auto turn = [&] {
            const double x = run.next.start[0], y = run.next.start[1];
            ASSERT_TRUE(run.arc(x + 20 * number(random), y + 20 * number(random), 2 * number(random)));
        };
        const auto resume = [&] {
            ASSERT_TRUE(
                run.line(run.next.start[0] + 20 * number(random), run.next.start[1] + 20 * number(random)));
        };
        // Line and arc, arc and line, arc and arc.
        ASSERT_NO_FATAL_FAILURE(i % 3 == 0 ? resume() : turn());
        ASSERT_NO_FATAL_FAILURE(i % 3 == 1 ? resume() : turn());
        run.end();
        expect_chain(run);
        for (std::size_t k = 0; k + 1 < run.segments.size(); ++k) {
            const JointState before = run.segments[k].at(run.segments[k].duration_s);
            const JointState after = run.segments[k + 1].at(0);
            // The limit is the change by an axis' acceleration within a period, shared by two ends of a
            // blend.
            ASSERT_LT((after.velocity - before.velocity).cwiseAbs().maxCoeff(), kA * 1e-3) << "case " << i;
        }
        blends += run.segments.size() > 2 ? 1 : 0;
    }
    EXPECT_GT(blends, 100);
}

TEST(LinuxcncBlend, BlendsRotaryMovesInParabolas) {
    LinuxcncRun run(fast_machine(), 0);
    run.next.mode = rrs::PathMode::continuous;
    rrs::JointPos joints = run.next.start;
    joints[0] = 100;
    joints[3] = 0.2;
    ASSERT_TRUE(run.go(joints));
    joints[1] = 80;
    joints[3] = 0;
    ASSERT_TRUE(run.go(joints));
    run.end();
    expect_chain(run);
    ASSERT_EQ(run.segments.size(), 3u);
    const Segment& both = run.segments[1];
    ASSERT_TRUE(both.superimposed);
    EXPECT_EQ(both.target_id, 2);
    EXPECT_NEAR(both.superimposed->duration_s, both.duration_s, 1e-12);
    // Each of both moves runs from standstill to standstill, at half of the acceleration that B allows.
    const double initial_mm_s2 = std::min(kA, 100 / 0.2 * kPi / 9) / 2,
                 second_mm_s2 = std::min(kA, 80 / 0.2 * kPi / 9) / 2;
    const double first_s = run.segments[0].duration_s + both.duration_s;
    const double second_s = both.duration_s + run.segments[2].duration_s;
    EXPECT_NEAR(first_s, trapezoid_s(100, 100, initial_mm_s2), 1e-9);
    EXPECT_NEAR(second_s, trapezoid_s(80, 100, second_mm_s2), 1e-9);
    // Speeds go on from each segment to the next, and only they: the first brakes while the second starts.
    for (std::size_t k = 0; k < 2; ++k) {
        const JointState before = run.segments[k].at(run.segments[k].duration_s);
        EXPECT_LT((run.segments[k + 1].at(0).velocity - before.velocity).cwiseAbs().maxCoeff(), 1e-6);
    }
    EXPECT_LT(both.at(both.duration_s / 2).acceleration[0], 0);
    EXPECT_GT(both.at(both.duration_s / 2).acceleration[1], 0);
}

TEST(LinuxcncBlend, ToleranceLimitsParabolas) {
    // For two motions at right angles, the speed at the start of the second is at most 2 sqrt(a P / cos 45
    // deg).
    for (const double tolerance_mm : {0.01, 0.1, 1.0}) {
        LinuxcncRun run(fast_machine(), 0);
        run.next.mode = rrs::PathMode::continuous;
        run.next.tolerance_mm = tolerance_mm;
        rrs::JointPos joints = run.next.start;
        joints[0] = 100;
        joints[3] = 0.01;
        ASSERT_TRUE(run.go(joints));
        joints[1] = 100;
        joints[3] = 0;
        ASSERT_TRUE(run.go(joints));
        run.end();
        const double speed = run.segments[1].at(0).velocity[0];
        EXPECT_NEAR(speed, std::min(100.0, 2 * std::sqrt(kA / 2 * tolerance_mm * std::sqrt(2.0))), 1e-6);
        EXPECT_LT(distance_to(run, 100, 0), 2 * tolerance_mm);
        double length_mm = 0;
        for (const Segment& segment : run.segments) length_mm += segment.length_mm;
        EXPECT_NEAR(run.segments[1].deviation_mm, distance_to(run, 100, 0), 0.01 * tolerance_mm);
        EXPECT_EQ(run.segments[0].deviation_mm + run.segments[2].deviation_mm, 0);
        EXPECT_LT(length_mm, 200) << "the corner is cut";
        EXPECT_GT(length_mm, 200 - 2 * tolerance_mm) << "and the way round it counts whole";
    }
}

TEST(LinuxcncBlend, OverlapsTakeFullServoPeriods) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    rrs::JointPos joints = run.next.start;
    for (int i = 1; i <= 20; ++i) {
        joints[0] = 10 * i;
        joints[1] = 10 * (i % 3);
        joints[4] = 0.02 * i;
        ASSERT_TRUE(run.go(joints));
    }
    run.end();
    expect_chain(run);
    int overlaps = 0;
    for (const Segment& segment : run.segments) {
        overlaps += segment.superimposed ? 1 : 0;
        EXPECT_NEAR(segment.duration_s / 1e-3, std::round(segment.duration_s / 1e-3), 1e-6);
    }
    EXPECT_EQ(overlaps, 19);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_blend_test
