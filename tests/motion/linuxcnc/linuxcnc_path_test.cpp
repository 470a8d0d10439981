// Parts of arcs, and lines that are merged into one.

#include <random>

#include <gtest/gtest.h>

#include "motion/linuxcnc/sub_segment_path.h"
#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_way_test {
namespace {

TEST(LinuxcncPath, PartOfArcLiesOnArc) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> number(0, 1);
    for (int i = 0; i < 500; ++i) {
        Arc arc{.center = {1, 2, 3}, .radius_mm = 5 + 20 * number(random), .sweep_rad = 8 * number(random)};
        arc.end_radius_mm = arc.radius_mm + (i % 2) * number(random);
        if (i % 3 == 0) arc.lift = {0, 0, 10 * number(random)};
        const double length = arc.length_mm();
        const double from = number(random) * length, to = from + number(random) * (length - from);
        const Arc part = arc.part(from, to);
        ASSERT_NEAR(part.length_mm(), to - from, 1e-9);
        for (const double share : {0.0, 0.3, 1.0}) {
            const double distance = share * (to - from);
            const Eigen::Vector3d expected = arc.at(arc.phi_at(from + distance));
            ASSERT_LT((part.at(part.phi_at(distance)) - expected).norm(), 1e-9) << "arc " << i;
        }
        ASSERT_NEAR(arc.length_to(arc.phi_at(from)), from, 1e-9);
    }
}

/// Parts so short that no angle is between their ends are points, on a line of no length.
TEST(LinuxcncPath, PartOfArcMayBePoint) {
    const PlannerSetup machine = fast_machine();
    const linuxcnc::Axes axes(machine);
    linuxcnc::SubSegment sub_segment;
    sub_segment.curved = true;
    sub_segment.arc = {.radius_mm = 1e6, .end_radius_mm = 1e6, .sweep_rad = 1e-3};
    sub_segment.length = sub_segment.arc.length_mm();
    sub_segment.start = sub_segment.end = rrs::JointPos::Zero(5);
    sub_segment.start.head<3>() = sub_segment.arc.at(0);
    sub_segment.end.head<3>() = sub_segment.arc.at(sub_segment.arc.sweep_rad);
    for (const double from : {0.3, 1.7, 500.0, 770.0, 999.0}) {
        for (const double to : {from, std::nextafter(from, 1e3), from + 1e-9}) {
            const linuxcnc::PathPart part = linuxcnc::path_part(sub_segment, axes, from, to);
            ASSERT_TRUE(part.start.allFinite());
            if (!part.curved) continue;
            ASSERT_TRUE(part.arc.at(part.arc.phi_at((to - from) / 2)).allFinite()) << from;
        }
    }
}

TEST(LinuxcncPath, MergesLinesWithinTolerance) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    run.next.tolerance_mm = run.next.merge_tolerance_mm = 0.1;
    for (int i = 1; i <= 20; ++i) ASSERT_TRUE(run.line(i, i % 2 == 1 ? 0.05 : 0));
    run.end();
    ASSERT_EQ(run.segments.size(), 1u);
    EXPECT_EQ(run.segments[0].target_id, 20);
    EXPECT_NEAR(run.segments[0].length_mm, 20, 1e-9);
    expect_chain(run);
}

TEST(LinuxcncPath, MergedLinesPassPointsWithinTolerance) {
    std::mt19937 random(22);
    std::normal_distribution<double> noise(0, 0.02);
    LinuxcncRun run(fast_machine(), 0);
    run.next.mode = rrs::PathMode::continuous;
    run.next.tolerance_mm = 1e-6;
    run.next.merge_tolerance_mm = 0.05;
    std::vector<Eigen::Vector2d> points;
    for (int i = 1; i <= 300; ++i) {
        points.emplace_back(0.3 * i + noise(random), 10 * std::sin(0.05 * i) + noise(random));
        ASSERT_TRUE(run.line(points.back().x(), points.back().y()));
    }
    run.end();
    expect_chain(run);
    EXPECT_LT(run.segments.size(), 200u);
    for (const Eigen::Vector2d& point : points) {
        double nearest = 1;
        for (const Segment& segment : run.segments) {
            const Eigen::Vector2d start = segment.start.head<2>(), distance = segment.end.head<2>() - start;
            const double share = std::clamp((point - start).dot(distance) / distance.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (point - start - share * distance).norm());
        }
        ASSERT_LE(nearest, 0.05 + 1e-5);
    }
}

TEST(LinuxcncPath, KeepsDifferentMovesSeparate) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    run.next.tolerance_mm = run.next.merge_tolerance_mm = 0.1;
    ASSERT_TRUE(run.line(1, 0));
    run.next.rules.programmed_speed_mm_s = 50;
    ASSERT_TRUE(run.line(2, 0));
    rrs::JointPos turned = run.next.start;
    turned[0] = 3;
    turned[3] = 0.1;
    ASSERT_TRUE(run.go(turned));
    ASSERT_TRUE(run.line(4, 0));
    run.next.rapid = true;
    ASSERT_TRUE(run.line(5, 0));
    run.end();
    std::vector<rrs::TargetId> ids;
    for (const Segment& segment : run.segments) {
        if (ids.empty() || ids.back() != segment.target_id) ids.push_back(segment.target_id);
    }
    EXPECT_EQ(ids, (std::vector<rrs::TargetId>{1, 2, 3, 4, 5}));
}

TEST(LinuxcncPath, FlatArcsBecomeLines) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    run.next.tolerance_mm = run.next.merge_tolerance_mm = 0.1;
    ASSERT_TRUE(run.arc(0, 100, 0.05));  // 0.03 mm high
    run.end();
    ASSERT_EQ(run.segments.size(), 1u);
    EXPECT_EQ(run.segments[0].kind, SegmentKind::linear);
    ASSERT_TRUE(run.arc(0, 100, 0.5));  // 3 mm high
    run.end();
    EXPECT_EQ(run.segments[1].kind, SegmentKind::circular);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_way_test
