#include "collision/monitor/collision_checker.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "collision/monitor/clearance_monitor.h"
#include "tests/collision/segments.h"

namespace gsim::cell::clear_way_test {
namespace {

constexpr const char* kBall = "[[shape]]\nname = \"ball\"\non = \"tool\"\nshape = { sphere_mm = 10 }\n";
constexpr const char* kBlock =
    "[[object]]\nname = \"block\"\nshape = { box_mm = [100, 100, 100] }\n"
    "frame = { x_mm = 550, y_mm = 500 }\n";  // from x = 500 on
constexpr double kEnd_mm = 1e-3;

Cell cell_of(const std::string& tables) {
    auto cell = read_cell("[cell]\nname = \"test\"\n" + tables, "cell.toml", af5());
    EXPECT_TRUE(cell) << (cell ? "" : cell.error().message);
    return *std::move(cell);
}

motion::Segment path(const rrs::JointPos& from, const rrs::JointPos& to) {
    return line(0, from, to, {100});
}

TEST(CollisionChecker, RejectsOnlyPathsBelowClearance) {
    const Cell cell = cell_of(std::string(kBall) + kBlock);
    const machine::Machine machine = af5();
    const auto bodies = CollisionChecker::make(cell, machine).value();
    for (const double clearance_mm : {0.1, 3.0, 40.0}) {
        const auto passes = [&](double deviation_mm) {
            const double x = 500 - 5 - deviation_mm;  // next to the block, along its wall
            return !bodies.obstacle(path(joints(x, 0, 0), joints(x, 1000, 0)), clearance_mm);
        };
        EXPECT_TRUE(passes(clearance_mm + kEnd_mm)) << clearance_mm;
        EXPECT_FALSE(passes(clearance_mm - kEnd_mm)) << clearance_mm;
    }
}

TEST(CollisionChecker, ReportsObstacleAndContactPoint) {
    const Cell cell = cell_of(std::string(kBall) + kBlock);
    const machine::Machine machine = af5();
    const auto bodies = CollisionChecker::make(cell, machine).value();
    const auto found = bodies.obstacle(path(joints(300, 500, 0), joints(700, 500, 0)), 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(cell.items[found->items.first].name + cell.items[found->items.second].name, "ballblock");
    EXPECT_GE(found->point_mm.x(), 500 - 1e-6);
    EXPECT_LE(found->point_mm.x(), 600 + 1e-6);
    EXPECT_TRUE(bodies.obstacle_at(joints(550, 500, 0), 1));
    EXPECT_FALSE(bodies.obstacle_at(joints(400, 500, 0), 1));
}

TEST(CollisionChecker, FindsThinPlate) {
    const Cell cell = cell_of(
        "[[shape]]\nname = \"ball\"\non = \"tool\"\nshape = { sphere_mm = 0.5 }\n"
        "[[object]]\nname = \"plate\"\nshape = { box_mm = [0.01, 900, 900] }\nframe = { x_mm = 511, y_mm = "
        "500 "
        "}\n");
    const machine::Machine machine = af5();
    const auto bodies = CollisionChecker::make(cell, machine).value();
    EXPECT_TRUE(bodies.obstacle(path(joints(0, 500, 0), joints(1800, 500, 0)), 1e-3));
    EXPECT_FALSE(bodies.obstacle(path(joints(0, 500, 0), joints(510, 500, 0)), 1e-3));
}

// The turn sweeps bodies off the axis: a ball 100 mm above the TCP moves 100 sin(angle) to the side.
TEST(CollisionChecker, ChecksSweepOfBodyOffRotationAxis) {
    const Cell cell = cell_of(
        "[[shape]]\nname = \"ball\"\non = \"tool\"\nshape = { sphere_mm = 10 }\nframe = { z_mm = 100 }\n"
        "[[object]]\nname = \"wall\"\nshape = { box_mm = [10, 400, 400] }\nframe = { x_mm = 560, y_mm = 500 "
        "}\n");
    const machine::Machine machine = af5();
    const auto bodies = CollisionChecker::make(cell, machine).value();
    const auto turns = [&](double angle) {
        return !bodies.obstacle(path(joints(500, 500, 0), joints(500, 500, 0, 0, angle)), 2);
    };
    const double max = std::asin((55 - 5 - 2) / 100.0);
    EXPECT_TRUE(turns(max - 1e-4));
    EXPECT_FALSE(turns(max + 1e-4));
}

// The monitor of runs finds the min distance; this one only if it is less.
TEST(CollisionChecker, AgreesWithClearanceMonitor) {
    const Cell cell = cell_of(
        "clearance_mm = 20\n"
        "[[shape]]\nname = \"head\"\non = \"C\"\nshape = { box_mm = [60, 80, 120] }\nframe = { z_mm = 90 "
        "}\n" +
        std::string(kBlock) +
        "[[object]]\nname = \"post\"\nshape = { cylinder_mm = [30, 400] }\nframe = { x_mm = 380, y_mm = 420 "
        "}\n");
    const machine::Machine machine = af5();
    const auto bodies = CollisionChecker::make(cell, machine).value();
    std::mt19937 random(3);
    const auto number = [&random](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    int near = 0;
    for (int i = 0; i < 300; ++i) {
        const auto place = [&] {
            return joints(number(250, 700), number(300, 700), number(-80, 200), number(-3, 3), number(-1, 1));
        };
        const motion::Segment segment = path(place(), place());
        ClearanceMonitor monitor(cell, machine);
        monitor.on_segment(segment, false);
        const double min_mm = monitor.nearest() ? monitor.nearest()->distance_mm : 20;
        if (min_mm > kEnd_mm) {
            EXPECT_FALSE(bodies.obstacle(segment, min_mm - kEnd_mm)) << i;
        }
        if (monitor.nearest()) {
            ++near;
            EXPECT_TRUE(bodies.obstacle(segment, min_mm + 2 * kEnd_mm)) << i;
        }
    }
    EXPECT_GT(near, 60);
}

TEST(CollisionChecker, RejectsCellWithMovableFrames) {
    Cell cell = cell_of(std::string(kBlock));
    cell.make_movable(cell.items.back().frame, false);
    const auto rejected = CollisionChecker::make(cell, af5());
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().message.find("frames that move independently"), std::string::npos);
}

}  // namespace
}  // namespace gsim::cell::clear_way_test
