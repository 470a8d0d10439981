#include "runtime/outputs/plot_data.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::plot_data_test {
namespace {

using Eigen::Vector2d;

double distance_to_piece(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
    const double length_squared = (b - a).squaredNorm();
    const double share = length_squared > 0 ? std::clamp((p - a).dot(b - a) / length_squared, 0.0, 1.0) : 0.0;
    return (a + share * (b - a) - p).norm();
}

double distance_to_polyline(const Vector2d& p, const std::vector<PathPoint>& line) {
    double min = (line.at(0).at_mm - p).norm();
    for (std::size_t i = 1; i < line.size(); ++i) {
        min = std::min(min, distance_to_piece(p, line[i - 1].at_mm, line[i].at_mm));
    }
    return min;
}

TEST(PathThinner, KeepsOnlyCorners) {
    PathThinner thinner;
    for (int i = 0; i <= 100; ++i) thinner.add({0.1 * i, 0}, PathStyle::feed);
    for (int i = 1; i <= 100; ++i) thinner.add({10, 0.1 * i}, PathStyle::feed);
    for (int i = 99; i >= 50; --i) thinner.add({10, 0.1 * i}, PathStyle::feed);  // back along the same path
    const auto points = thinner.points();
    ASSERT_EQ(points.size(), 4u);
    EXPECT_EQ(points[1].at_mm, Vector2d(10, 0));
    EXPECT_EQ(points[2].at_mm, Vector2d(10, 10));
    EXPECT_EQ(points[3].at_mm, Vector2d(10, 5));
}

TEST(PathThinner, KeepsPointOfStyleChange) {
    PathThinner thinner;
    thinner.add({0, 0}, PathStyle::rapid);
    thinner.add({10, 0}, PathStyle::rapid);
    thinner.add({20, 0}, PathStyle::jet);
    const auto points = thinner.points();
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1].at_mm, Vector2d(10, 0));
    EXPECT_EQ(points[1].style, PathStyle::rapid);
    EXPECT_EQ(points[2].style, PathStyle::jet);
}

// X moves 100 mm in 2.5 s, Y by a law of its own in 1.5 s: the picture shows the driven path.
TEST(PlotData, DrawsUncoordinatedPathAsDriven) {
    motion::Segment segment = line(1, 0, joints(0, 0), joints(100, 0));
    segment.end = joints(100, 50);
    segment.add_follower(1, 1, motion::TimeLaw::fastest(50, kSpeed_mm_s, kAcceleration_mm_s2));
    segment.uncoordinated = motion::kApart | 3U;
    const machine::Machine machine = af5();
    PlotData data(machine);
    data.begin(segment.start);
    data.on_segment(segment, {});
    const std::vector<PathPoint> drawn = data.path();
    for (int i = 0; i <= 50; ++i) {
        const rrs::JointPos at = segment.position_at(segment.duration_s * i / 50);
        EXPECT_LT(distance_to_polyline({at[0], at[1]}, drawn), 0.1) << i;
    }
    EXPECT_GT(distance_to_polyline({50, 25}, drawn), 10) << "the straight line";
}

TEST(PathThinner, LongPathStaysBoundedAndAccurate) {
    PathThinner thinner;
    std::vector<Vector2d> all;
    for (int i = 0; i < 300000; ++i) {  // a spiral of 1000 mm
        const double phi = 0.002 * i;
        all.emplace_back(phi * std::cos(phi), phi * std::sin(phi));
        thinner.add(all.back(), i / 100 % 2 == 0 ? PathStyle::jet : PathStyle::feed);
    }
    const auto points = thinner.points();
    EXPECT_LE(points.size(), PathThinner::kMaxPoints + 1);
    EXPECT_GT(points.size(), 1000u);
    for (std::size_t i = 0; i < all.size(); i += 3001) {
        EXPECT_LT(distance_to_polyline(all[i], points), 0.5) << i;
    }
}

TEST(PathThinner, RandomWalkStaysBounded) {
    PathThinner thinner;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> mm(-1000, 1000);
    for (int i = 0; i < 200000; ++i) {
        thinner.add({mm(random), mm(random)}, static_cast<PathStyle>(random() % 3));
        if (i % 1000 == 0) {
            ASSERT_LE(thinner.points().size(), PathThinner::kMaxPoints + 1);
        }
    }
    EXPECT_LE(thinner.points().size(), PathThinner::kMaxPoints + 1);
}

TEST(TimeBuckets, KeepsEveryPeak) {
    TimeBuckets buckets;
    for (int i = 0; i < 1000000; ++i) {
        const double speed = i == 654321 ? 99 : i % 2 == 0 ? 10 : 20;
        buckets.add({0.01 * i, speed, i >= 500000 ? PathStyle::jet : PathStyle::feed});
    }
    const auto points = buckets.points();
    EXPECT_LE(points.size(), 6 * TimeBuckets::kMaxBuckets);
    double max = 0, min = 100;
    for (std::size_t i = 0; i < points.size(); ++i) {
        max = std::max(max, points[i].value);
        min = std::min(min, points[i].value);
        EXPECT_EQ(points[i].style == PathStyle::jet, points[i].t_s >= 5000) << points[i].t_s;
        EXPECT_GE(points[i].t_s, points[i > 0 ? i - 1 : 0].t_s);
    }
    EXPECT_EQ(max, 99);
    EXPECT_EQ(min, 10);
}

TEST(PlotData, KeepsShapeAndSpeedOfArcs) {
    const machine::Machine machine = af5();
    PlotData data(machine);
    data.begin(joints(600, 600));
    data.on_segment(arc(1, 0, 500, 600, 100, 0, 360), {.kind = MoveKind::arc_ccw, .process_on = true});
    EXPECT_EQ(data.labels()[0], "X (mm)");
    EXPECT_EQ(data.labels()[1], "Y (mm)");
    const auto path = data.path();
    EXPECT_GT(path.size(), 90u);
    for (const PathPoint& point : path) {
        EXPECT_NEAR((point.at_mm - Vector2d(500, 600)).norm(), 100, 1e-9);
    }
    double top = 0;
    for (const TimePoint& point : data.speed()) {
        EXPECT_EQ(point.style, PathStyle::jet);
        top = std::max(top, point.value);
    }
    EXPECT_NEAR(top, kSpeed_mm_s, 1e-9);
}

// 12.5 mm up to speed at 100 mm/s2 in 0.5 s, 75 mm in 1.5 s, and down again.
TEST(PlotData, AccelerationMatchesTimeLaw) {
    const machine::Machine machine = af5();
    PlotData data(machine);
    data.begin(joints(0, 0));
    data.on_segment(line(1, 0, joints(0, 0), joints(100, 0)), {.kind = MoveKind::linear});
    data.on_segment(standstill(2, 2.5, joints(100, 0), 1), {.kind = MoveKind::dwell});
    EXPECT_EQ(data.acceleration().back().t_s, 3.5);
    for (const TimePoint& point : data.acceleration()) {
        const bool at_jump = point.t_s == 0.5 || point.t_s == 2 || point.t_s == 2.5;
        const double value = point.t_s < 0.5 ? 100 : point.t_s > 2 && point.t_s < 2.5 ? -100 : 0;
        if (!at_jump) {
            EXPECT_NEAR(point.value, value, 1e-9) << point.t_s;
        }
    }
}

TEST(PlotData, RampsDoNotHideLongCruise) {
    const machine::Machine machine = af5();
    PlotData data(machine);
    data.begin(joints(0, 0));
    for (int i = 0; i < 100; ++i) {
        motion::Segment segment = line(i, 100.0 * i, joints(0, 0), joints(100, 0));
        segment.master = motion::TimeLaw::fastest(100, 1, 1000);  // ramps of 1 ms
        segment.duration_s = segment.master.duration_s();
        data.on_segment(segment, {.kind = MoveKind::linear});
    }
    const auto points = data.acceleration();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double slope = std::abs(points[i].value - points[i - 1].value);
        EXPECT_TRUE(slope == 0 || points[i].t_s - points[i - 1].t_s < 10) << points[i].t_s;
    }
}

TEST(PlotData, FeedIsOnlyOfMovesWithFeedInMmPerMinute) {
    const machine::Machine machine = af5();
    PlotData data(machine);
    data.begin(joints(0, 0));
    const motion::Segment segment = line(1, 0, joints(0, 0), joints(100, 0));
    data.on_segment(segment, {.kind = MoveKind::rapid, .feed_per_min = 3000});
    data.on_segment(segment, {.kind = MoveKind::linear, .feed_per_min = 3000, .timed = true});
    motion::Segment turn = segment;
    turn.length_mm = 0;
    data.on_segment(turn, {.kind = MoveKind::linear, .feed_per_min = 3000});
    EXPECT_TRUE(data.feed().empty());
    data.on_segment(segment, {.kind = MoveKind::linear, .feed_per_min = 3000});
    ASSERT_EQ(data.feed().size(), 2u);
    EXPECT_EQ(data.feed()[1].t_s, 2.5);
    EXPECT_EQ(data.feed()[1].value, 50);
}

TEST(PlotData, SideViewsShowZ) {
    const machine::Machine machine = af5();
    PlotData front(machine, Plane::zx), side(machine, Plane::yz);
    for (PlotData* each : {&front, &side}) {
        rrs::JointPos start = joints(10, 20);
        start[2] = 30;
        each->begin(start);
    }
    EXPECT_EQ(front.labels(), (std::array<std::string, 2>{"X (mm)", "Z (mm)"}));
    EXPECT_EQ(front.path()[0].at_mm, Vector2d(10, 30));
    EXPECT_EQ(side.labels(), (std::array<std::string, 2>{"Y (mm)", "Z (mm)"}));
    EXPECT_EQ(side.path()[0].at_mm, Vector2d(20, 30));
}

TEST(PlotData, SideViewNeedsItsAxes) {
    machine::Machine machine = af5();
    EXPECT_EQ(PlotData::find_missing_axes_error(machine, Plane::yz), std::nullopt);
    machine.axes.erase(machine.axes.begin() + 1);
    machine.name = "lathe";
    EXPECT_EQ(PlotData::find_missing_axes_error(machine, Plane::zx), std::nullopt);
    EXPECT_EQ(PlotData::find_missing_axes_error(machine, Plane::yz),
              "--plot-plane yz needs the axes Y and Z, which the machine 'lathe' does not have");
}

TEST(PlotData, UsesOtherAxisWithoutXAndY) {
    machine::Machine machine = af5();
    machine.axes.erase(machine.axes.begin(), machine.axes.begin() + 4);
    PlotData data(machine);
    data.begin(rrs::JointPos::Zero(1));
    EXPECT_EQ(data.labels()[0], "C (deg)");
}

}  // namespace
}  // namespace gsim::simulation::plot_data_test
