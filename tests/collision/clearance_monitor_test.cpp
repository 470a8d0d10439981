#include "collision/monitor/clearance_monitor.h"

#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "tests/collision/meshes.h"
#include "tests/collision/segments.h"

namespace gsim::cell::clearance_watch_test {
namespace {

using Eigen::Vector3d;

Cell cell_of(const std::string& tables, double clearance_mm = 5) {
    const std::string text =
        fmt::format("[cell]\nname = \"test\"\nclearance_mm = {:.6f}\n{}", clearance_mm, tables);
    auto cell = read_cell(text, "cell.toml", af5());
    EXPECT_TRUE(cell) << (cell ? "" : cell.error().message);
    return *std::move(cell);
}

std::string ball_at_tip(double diameter_mm) {
    return fmt::format("[[shape]]\nname = \"tip\"\non = \"tool\"\nshape = {{ sphere_mm = {} }}\n",
                       diameter_mm);
}

std::string box_at(const std::string& name, const Vector3d& size, const Vector3d& at,
                   const std::string& more = "") {
    return fmt::format(
        "[[object]]\nname = \"{}\"\nshape = {{ box_mm = [{}, {}, {}] }}\nframe = {{ x_mm = {}, y_mm = {}, "
        "z_mm = {} "
        "}}\n{}\n",
        name, size.x(), size.y(), size.z(), at.x(), at.y(), at.z(), more);
}

/// Monitor of a cell and a clock.
class MonitoredPair {
  public:
    explicit MonitoredPair(Cell of) : cell(std::move(of)), monitor(cell, af5()) {}

    void line_to(const rrs::JointPos& from, const rrs::JointPos& to, const Pace& motion_limits,
                 bool jet = false) {
        on_segment(line(time_s, from, to, motion_limits), jet);
    }
    void on_segment(const motion::Segment& segment, bool jet = false) {
        monitor.begin_block();
        monitor.on_segment(segment, jet);
        time_s += segment.duration_s;
    }

    Cell cell;
    ClearanceMonitor monitor;
    double time_s = 0;
};

TEST(ClearanceMonitor, FindsThinPlateAtFullSpeed) {
    MonitoredPair run(cell_of(ball_at_tip(1) + box_at("plate", {0.1, 1000, 1000}, {500, 500, 0})));
    run.line_to(joints(0, 500, 0), joints(1000, 500, 0), {508});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    const Contact& contact = run.monitor.contacts()[0];
    EXPECT_NEAR(contact.t_s, (500 - 0.05 - 0.5) / 508, 2e-8);  // 1e-6 mm and 1e-9 s
    EXPECT_TRUE(contact.point_mm.isApprox(Vector3d(499.95, 500, 0), 1e-6)) << contact.point_mm.transpose();
    EXPECT_TRUE(contact.penetrating);
    EXPECT_EQ(run.cell.items[contact.pair.first].name, "tip");
    EXPECT_EQ(run.monitor.nearest()->distance_mm, 0);
}

// Far from everything steps are not looked at one by one.
TEST(ClearanceMonitor, SmallStepsFindSameContactAsOneMove) {
    MonitoredPair run(cell_of(ball_at_tip(1) + box_at("plate", {0.1, 1000, 1000}, {500, 500, 0})));
    for (int step = 0; step < 4000; ++step)
        run.line_to(joints(0.25 * step, 500, 0), joints(0.25 * (step + 1), 500, 0), {508});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    EXPECT_NEAR(run.monitor.contacts()[0].t_s, (500 - 0.05 - 0.5) / 508, 2e-8);
}

TEST(ClearanceMonitor, SmallTurnsFindSameContactAsOneTurn) {
    // The tool's end, 200 mm above the TCP, moves down on a circle to a plate at its height at 60 degrees.
    const std::string end =
        "[[shape]]\nname = \"end\"\non = \"tool\"\nshape = { sphere_mm = 2 }\nframe = { z_mm = 200 }\n";
    MonitoredPair run(cell_of(end + box_at("plate", {1000, 1000, 10}, {500, 500, 94})));
    const int steps = 3000;
    const double most_rad = 80 * M_PI / 180;
    for (int step = 0; step < steps; ++step)
        run.line_to(joints(500, 500, 0, 0, most_rad * step / steps),
                    joints(500, 500, 0, 0, most_rad * (step + 1) / steps), {1});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    EXPECT_NEAR(run.monitor.contacts()[0].t_s, M_PI / 3, 2e-8);  // 200 cos 60 = 94 + 5 + 1
}

TEST(ClearanceMonitor, FindsContactOfJetSwitchedOnFarFromBodies) {
    const std::string jet = "[[shape]]\nname = \"jet\"\non = \"jet\"\nshape = { cylinder_mm = [1, 300] }\n";
    MonitoredPair run(cell_of(ball_at_tip(1) + jet + box_at("post", {10, 10, 10}, {500, 500, -100})));
    for (int step = 0; step < 1000; ++step)
        run.line_to(joints(step, 500, 0), joints(step + 1, 500, 0), {100}, step == 498 || step > 900);
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    EXPECT_NEAR(run.monitor.contacts()[0].t_s, 4.98, 1e-9);
}

TEST(ClearanceMonitor, ReportsClearanceOfPassAtOneMillimetre) {
    MonitoredPair run(cell_of(ball_at_tip(10) + box_at("box", {100, 100, 100}, {500, 500, 50})));
    run.line_to(joints(300, 444, 50), joints(700, 444, 50), {508, 490});
    ASSERT_TRUE(run.monitor.nearest());
    EXPECT_NEAR(run.monitor.nearest()->distance_mm, 1, 1e-4);
    EXPECT_NEAR(run.monitor.nearest()->point_mm.y(), 450, 1e-6);
    EXPECT_TRUE(run.monitor.contacts().empty());
    run.line_to(joints(700, 444, 50), joints(700, 430, 50), {508, 490});
    EXPECT_FALSE(run.monitor.nearest());  // sqrt(150^2 + ...) away
}

TEST(ClearanceMonitor, RecordsTimeOfMinClearanceIfRequested) {
    const std::string post =
        "[[object]]\nname = \"post\"\nshape = { cylinder_mm = [20, 100] }\nframe = { x_mm = 500, y_mm = 500 "
        "}\n";
    for (const bool expected_value : {false, true}) {
        MonitoredPair run(cell_of(ball_at_tip(10) + post));
        if (expected_value) run.monitor.record_times();
        run.line_to(joints(200, 100, 0), joints(200, 484, 0), {508, 490});
        const double before_s = run.time_s;
        run.line_to(joints(200, 484, 0), joints(800, 484, 0), {508, 490});
        ASSERT_TRUE(run.monitor.nearest());
        EXPECT_NEAR(run.monitor.nearest()->distance_mm, 1, 1e-4);
        ASSERT_EQ(run.monitor.nearest()->t_s.has_value(), expected_value);
        // The time is that of a distance within 1e-3 mm of the minimum: 0.2 mm before the middle of the path.
        if (!expected_value) continue;
        EXPECT_NEAR(*run.monitor.nearest()->t_s, (before_s + run.time_s) / 2, 0.25 / 508);
    }
}

TEST(ClearanceMonitor, ReportsClearanceOfArcAroundPost) {
    const std::string post =
        "[[object]]\nname = \"post\"\nshape = { cylinder_mm = [20, 100] }\nframe = { x_mm = 500, y_mm = 500 "
        "}\n";
    MonitoredPair run(cell_of(ball_at_tip(10) + post));
    run.on_segment(turn(0, joints(500, 500, 0), 15 + 1, {100, 490}));
    ASSERT_TRUE(run.monitor.nearest());
    EXPECT_NEAR(run.monitor.nearest()->distance_mm, 1, 1e-4);
    EXPECT_TRUE(run.monitor.contacts().empty());
}

// A ball 100 mm above the TCP meets a wall as the tool tilts: 100 sin(angle) + 5 = 55.
TEST(ClearanceMonitor, FindsContactAtTiltAngle) {
    const std::string ball =
        "[[shape]]\nname = \"head\"\non = \"tool\"\nshape = { sphere_mm = 10 }\nframe = { z_mm = 100 }\n";
    MonitoredPair run(cell_of(ball + box_at("wall", {10, 400, 400}, {560, 500, 0})));
    const double speed = 0.5;
    run.line_to(joints(500, 500, 0), joints(500, 500, 0, 0, 1), {speed});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    EXPECT_NEAR(run.monitor.contacts()[0].t_s, std::asin(0.5) / speed, 3e-8);
    EXPECT_NEAR(run.monitor.contacts()[0].point_mm.z(), 100 * std::cos(std::asin(0.5)), 1e-4);
}

TEST(ClearanceMonitor, FindsContactBetweenMachineParts) {
    const std::string parts =
        "[[shape]]\nname = \"post\"\non = \"base\"\nshape = { box_mm = [10, 10, 10] }\n"
        "[[shape]]\nname = \"arm\"\non = \"Y\"\nshape = { box_mm = [10, 10, 10] }\nframe = { x_mm = 8 }\n"
        "[[shape]]\nname = \"head\"\non = \"Z\"\nshape = { box_mm = [10, 10, 10] }\n";
    MonitoredPair run(cell_of(parts));
    run.line_to(joints(100, 0, 0), joints(5, 0, 0), {100});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);  // not arm and head, which are neighbours
    EXPECT_NEAR(run.monitor.contacts()[0].t_s, 0.9, 1e-6);
}

TEST(ClearanceMonitor, TouchingIsNotPenetrating) {
    const std::string plate = box_at("plate", {100, 100, 10}, {500, 500, -5});
    MonitoredPair down(cell_of(ball_at_tip(10) + plate));
    down.line_to(joints(500, 500, 50), joints(500, 500, 5), {100, 490});
    ASSERT_EQ(down.monitor.contacts().size(), 1U);
    EXPECT_FALSE(down.monitor.contacts()[0].penetrating);
    down.line_to(joints(500, 500, 5), joints(510, 500, 5), {100, 490});
    ASSERT_EQ(down.monitor.contacts().size(), 1U);  // continues
    EXPECT_FALSE(down.monitor.contacts()[0].penetrating);
    down.line_to(joints(510, 500, 5), joints(510, 500, 4), {100, 490});
    ASSERT_EQ(down.monitor.contacts().size(), 1U);
    EXPECT_TRUE(down.monitor.contacts()[0].penetrating);
}

// Down to 0.2 mm below the plate's top, and up again.
TEST(ClearanceMonitor, ProbeTouchIsNoContactUntilItGoesDeeper) {
    const std::string plate = box_at("plate", {100, 100, 10}, {500, 500, -5});
    const auto probed = [&] {
        MonitoredPair run(cell_of(ball_at_tip(10) + plate));
        const motion::Segment down = line(0, joints(500, 500, 50), joints(500, 500, 4.8), {100, 490});
        run.monitor.on_segment(down, false, true);
        run.time_s = down.duration_s;
        EXPECT_TRUE(run.monitor.contacts().empty());
        EXPECT_FALSE(run.monitor.nearest());
        return run.time_s;
    };
    const double touched_s = probed();
    for (const auto& [to_mm, contacts] : {std::pair{50.0, 0U}, {4.8, 0U}, {4.7, 1U}}) {
        MonitoredPair run(cell_of(ball_at_tip(10) + plate));
        run.monitor.on_segment(line(0, joints(500, 500, 50), joints(500, 500, 4.8), {100, 490}), false, true);
        run.time_s = touched_s;
        run.line_to(joints(500, 500, 4.8), joints(510, 500, to_mm), {100, 490});
        ASSERT_EQ(run.monitor.contacts().size(), contacts) << to_mm;
        if (contacts == 0) continue;
        EXPECT_EQ(run.monitor.contacts()[0].t_s, touched_s);
        EXPECT_TRUE(run.monitor.contacts()[0].penetrating);
    }
}

TEST(ClearanceMonitor, ReportsContactAfterProbeRetracts) {
    MonitoredPair run(cell_of(ball_at_tip(10) + box_at("plate", {100, 100, 10}, {500, 500, -5})));
    const motion::Segment down = line(0, joints(500, 500, 50), joints(500, 500, 4.8), {100, 490});
    run.monitor.on_segment(down, false, true);
    run.time_s = down.duration_s;
    run.line_to(joints(500, 500, 4.8), joints(500, 500, 30), {100, 490});
    EXPECT_FALSE(run.monitor.nearest());
    run.line_to(joints(500, 500, 30), joints(500, 500, 6), {100, 490});
    ASSERT_TRUE(run.monitor.nearest());
    EXPECT_NEAR(run.monitor.nearest()->distance_mm, 1, 1e-4);
    run.line_to(joints(500, 500, 6), joints(500, 500, 4.9), {100, 490});
    EXPECT_EQ(run.monitor.contacts().size(), 1U);
}

// Only a tool can probe.
TEST(ClearanceMonitor, ReportsContactOfNonToolPartDuringProbing) {
    const std::string wrist = "[[shape]]\nname = \"wrist\"\non = \"Z\"\nshape = { box_mm = [50, 50, 20] }\n";
    MonitoredPair run(cell_of(wrist + box_at("clamp", {10, 10, 50}, {520, 500, -25})));
    run.monitor.on_segment(line(0, joints(500, 500, 50), joints(500, 500, 0), {100, 490}), false, true);
    EXPECT_EQ(run.monitor.contacts().size(), 1U);
}

TEST(ClearanceMonitor, ReportsContactOnceAndAgainAfterSeparation) {
    MonitoredPair run(cell_of(ball_at_tip(10) + box_at("box", {100, 100, 100}, {500, 500, 0})));
    run.line_to(joints(400, 500, 0), joints(450, 500, 0), {100, 490});
    run.line_to(joints(450, 500, 0), joints(500, 500, 0), {100, 490});
    run.on_segment(standstill(run.time_s, joints(500, 500, 0), 1));
    EXPECT_EQ(run.monitor.contacts().size(), 1U);
    run.line_to(joints(500, 500, 0), joints(500, 600, 0), {100, 490});
    EXPECT_EQ(run.monitor.nearest()->distance_mm, 0);
    run.line_to(joints(500, 600, 0), joints(500, 610, 0), {100, 490});
    EXPECT_FALSE(run.monitor.nearest());
    run.line_to(joints(500, 610, 0), joints(500, 500, 0), {100, 490});
    EXPECT_EQ(run.monitor.contacts().size(), 2U);
}

TEST(ClearanceMonitor, ReportsOverlapAtStartImmediately) {
    MonitoredPair run(cell_of(ball_at_tip(10) + box_at("box", {100, 100, 100}, {500, 500, 0})));
    run.line_to(joints(500, 500, 0), joints(520, 500, 0), {100, 490});
    ASSERT_EQ(run.monitor.contacts().size(), 1U);
    EXPECT_EQ(run.monitor.contacts()[0].t_s, 0);
    EXPECT_TRUE(run.monitor.contacts()[0].penetrating);
}

TEST(ClearanceMonitor, ReportsActiveJetOnFixtureButNotOnWorkpiece) {
    const std::string jet =
        "[[shape]]\nname = \"jet\"\non = \"jet\"\nshape = { cylinder_mm = [1, 10] }\nframe = { z_mm = -5 }\n";
    const std::string objects = box_at("sheet", {400, 100, 2}, {500, 500, -5}, "role = \"workpiece\"") +
                                box_at("clamp", {10, 100, 2}, {600, 500, -5}, "role = \"fixture\"");
    MonitoredPair off(cell_of(jet + objects));
    off.line_to(joints(500, 500, 0), joints(700, 500, 0), {100});
    EXPECT_TRUE(off.monitor.contacts().empty());
    MonitoredPair on(cell_of(jet + objects));
    on.line_to(joints(500, 500, 0), joints(700, 500, 0), {100}, true);
    ASSERT_EQ(on.monitor.contacts().size(), 1U);
    EXPECT_NEAR(on.monitor.contacts()[0].t_s, 0.945, 1e-6);
    EXPECT_EQ(on.cell.items[on.monitor.contacts()[0].pair.second].name, "clamp");
    // Switched on above the clamp it meets the clamp at once.
    off.line_to(joints(700, 500, 0), joints(600, 500, 0), {100});
    off.line_to(joints(600, 500, 0), joints(500, 500, 0), {100}, true);
    ASSERT_EQ(off.monitor.contacts().size(), 1U);
    EXPECT_EQ(off.monitor.contacts()[0].t_s, 3);
}

TEST(ClearanceMonitor, IgnoresContactOfIgnoredPair) {
    const std::string tables = ball_at_tip(10) + box_at("box", {100, 100, 100}, {500, 500, 0});
    MonitoredPair run(cell_of(tables));
    run.cell.ignored.emplace_back(0, 1);
    ClearanceMonitor monitor(run.cell, af5());
    monitor.on_segment(line(0, joints(400, 500, 0), joints(600, 500, 0), {100, 490}), false);
    EXPECT_TRUE(monitor.contacts().empty());
    EXPECT_FALSE(monitor.nearest());
}

TEST(ClearanceMonitor, UsesMovedFramesImmediately) {
    MonitoredPair run(cell_of(ball_at_tip(10) + box_at("box", {100, 100, 100}, {500, 500, 0})));
    run.line_to(joints(0, 500, 0), joints(100, 500, 0), {100, 490});
    EXPECT_TRUE(run.monitor.contacts().empty());
    run.cell.frames.move(*run.cell.frames.find("box"), shift(200, 500, 0));
    run.monitor.on_frames_changed();
    run.line_to(joints(100, 500, 0), joints(200, 500, 0), {100, 490});
    EXPECT_EQ(run.monitor.contacts().size(), 1U);
}

// Distances and contacts of random motions of five axes against those of many samples.
TEST(ClearanceMonitor, RandomMotionsMatchSamples) {
    std::mt19937 random(12);
    Cell cell = cell_of(
        "[[shape]]\nname = \"head\"\non = \"C\"\nshape = { cylinder_mm = [40, 100] }\nframe = { y_mm = 60 "
        "}\n",
        200);
    const std::size_t ring = cell.frames.add("ring", 0, shift(500, 500, 0));
    cell.items.push_back({"ring", Role::fixture, Shape::mesh(torus(100, 20, 12).mesh()), ring});
    const machine::Machine machine = af5();
    const auto kinematics = machine::make_kinematics(machine);
    int touching = 0;
    for (int i = 0; i < 30; ++i) {
        const auto place = [&] {
            return joints(between(random, 350, 650), between(random, 350, 650), between(random, 0, 150),
                          between(random, -2, 2), between(random, -1, 1));
        };
        motion::Segment segment = line(0, place(), place(), {100, 490});
        if (i % 3 == 0) {
            const double travel = segment.end[3] - segment.start[3];
            segment.add_follower(3, travel < 0 ? -1 : 1,
                                 motion::TimeLaw::with_duration(std::abs(travel), segment.duration_s, 100));
        }
        ClearanceMonitor monitor(cell, machine);
        monitor.record_times();
        monitor.on_segment(segment, false);
        const SegmentMotion motion(*kinematics, segment);
        const BodyPair pair{{&cell.items[0].shape, cell.frames.link(cell.items[0].frame),
                             cell.frames.pose_in_link(cell.items[0].frame)},
                            {&cell.items[1].shape, 0, cell.frames.pose_in_link(ring)},
                            joints_between(*kinematics, 5, 0)};
        double min = 200;
        double first_s = -1;
        constexpr int kSamples = 600;
        for (int sample = 0; sample <= kSamples; ++sample) {
            const double t_s = segment.duration_s * sample / kSamples;
            const double distance = pair.distance_at(motion.links_at(t_s), 1000).upper_mm;
            min = std::min(min, distance);
            if (distance == 0 && first_s < 0) first_s = t_s;
        }
        const double found = monitor.nearest() ? monitor.nearest()->distance_mm : 200;
        EXPECT_LE(found, min + 1e-4);
        EXPECT_GE(found, min - 0.6);
        if (monitor.nearest()) {
            const double at = pair.distance_at(motion.links_at(*monitor.nearest()->t_s), 1000).upper_mm;
            EXPECT_NEAR(at, found, 2e-3);
        }
        if (first_s < 0) continue;
        ++touching;
        ASSERT_EQ(monitor.contacts().size(), 1U);
        EXPECT_LE(monitor.contacts()[0].t_s, first_s + 1e-9);
        EXPECT_GE(monitor.contacts()[0].t_s, first_s - 2 * segment.duration_s / kSamples);
        const double at = pair.distance_at(motion.links_at(monitor.contacts()[0].t_s), 1).upper_mm;
        EXPECT_LE(at, 1e-5) << "kContact_mm, and what rounding leaves in flat sets of corners";
    }
    EXPECT_GT(touching, 5);
}

}  // namespace
}  // namespace gsim::cell::clearance_watch_test
