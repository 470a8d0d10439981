// When a box is entered or left on one segment, against closed forms.
#include "runtime/monitors/zone_box.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::zone_box_test {
namespace {

constexpr double kTime_s = 1e-9;

ZoneBox box(bool stay_inside, motion::Range x, motion::Range y) {
    ZoneBox box(stay_inside);
    box.add_side({.axis = 0, .joint = 0, .walls = x});
    box.add_side({.axis = 1, .joint = 1, .walls = y});
    return box;
}

/// Half a second of acceleration, then kSpeed_mm_s.
double time_at(double s_mm) {
    const double ramp_mm = kSpeed_mm_s * kSpeed_mm_s / kAcceleration_mm_s2 / 2;
    if (s_mm < ramp_mm) return std::sqrt(2 * s_mm / kAcceleration_mm_s2);
    return kSpeed_mm_s / kAcceleration_mm_s2 + (s_mm - ramp_mm) / kSpeed_mm_s;
}

void expect_offence(const std::optional<BoxViolation>& violation, double t_s, std::size_t axis, bool upper) {
    ASSERT_TRUE(violation);
    EXPECT_NEAR(violation->t_s, t_s, kTime_s);
    EXPECT_EQ(violation->axis, axis);
    EXPECT_EQ(violation->upper, upper);
    EXPECT_FALSE(violation->at_start);
}

TEST(ZoneBox, LineEntersWhereLastAxisEnters) {
    const motion::Segment path = line(1, 0, joints(0, 0), joints(80, 60));
    expect_offence(box(false, {8, 100}, {-10, 100}).first_violation(path), time_at(10), 0, false);
    expect_offence(box(false, {8, 100}, {30, 100}).first_violation(path), time_at(50), 1, false);
    EXPECT_FALSE(box(false, {90, 100}, {-10, 100}).first_violation(path));
    EXPECT_FALSE(box(false, {0, 40}, {31, 40}).first_violation(path)) << "past the corner at 40, 30";
}

TEST(ZoneBox, LineThroughEdgeTouchesBox) {
    const motion::Segment path = line(1, 0, joints(0, 0), joints(80, 60));
    expect_offence(box(false, {20, 40}, {30, 50}).first_violation(path), time_at(50), 1, false);
    EXPECT_FALSE(box(false, {20, 40}, {30.00001, 50}).first_violation(path));
}

TEST(ZoneBox, LineLeavesWhereFirstAxisLeaves) {
    const motion::Segment path = line(1, 0, joints(0, 0), joints(80, 60));
    expect_offence(box(true, {-1, 40}, {-1, 31}).first_violation(path), time_at(50), 0, true);
    expect_offence(box(true, {-1, 40}, {-1, 27}).first_violation(path), time_at(45), 1, true);
    EXPECT_FALSE(box(true, {0, 80}, {0, 60}).first_violation(path)) << "on its walls";
}

TEST(ZoneBox, ReportsViolationAtStart) {
    const motion::Segment path = line(1, 0, joints(0, 0), joints(80, 60));
    const auto inside = box(false, {-1, 100}, {-2, 100}).first_violation(path);
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->at_start);
    EXPECT_EQ(inside->t_s, 0);
    EXPECT_TRUE(box(true, {1, 100}, {-2, 100}).first_violation(path)->at_start);
}

TEST(ZoneBox, ArcEntersAtItsAngle) {
    const motion::Segment path = arc(1, 0, 0, 0, 40, 0, 360);
    const double deg = std::numbers::pi / 180;
    // y = 40 sin(phi) reaches 20 at 30 degrees, and again at 150 as it falls.
    expect_offence(box(false, {-100, 100}, {20, 100}).first_violation(path), time_at(40 * 30 * deg), 1,
                   false);
    expect_offence(box(false, {-100, 0}, {-100, 20}).first_violation(path), time_at(40 * 150 * deg), 1, true);
    expect_offence(box(false, {-100, -20}, {-100, 100}).first_violation(path), time_at(40 * 120 * deg), 0,
                   true);
    EXPECT_FALSE(box(false, {-20, 20}, {-20, 20}).first_violation(path)) << "within the circle";
    EXPECT_FALSE(box(false, {30, 100}, {30, 100}).first_violation(path)) << "in the corner of its square";
}

TEST(ZoneBox, ArcLeavesAtItsAngle) {
    const motion::Segment path = arc(1, 0, 0, 0, 40, 0, 360);
    const double angle = std::acos(-39.9 / 40);
    expect_offence(box(true, {-39.9, 50}, {-50, 50}).first_violation(path), time_at(40 * angle), 0, false);
    EXPECT_FALSE(box(true, {-40, 40}, {-40, 40}).first_violation(path)) << "it touches all four walls";
}

TEST(ZoneBox, HelixEntersAtHeightAndAngleOfBox) {
    motion::Segment path = arc(1, 0, 0, 0, 10, 0, 3600);
    path.arc.lift = {0, 0, 100};
    path.end = joints(10, 0, 100);
    path.length_mm = path.arc.length_mm();
    path.master = motion::TimeLaw::fastest(path.length_mm, kSpeed_mm_s, kAcceleration_mm_s2);
    path.duration_s = path.master.duration_s();
    ZoneBox high = box(false, {-20, -5}, {-20, 20});
    high.add_side({.axis = 2, .joint = 2, .walls = {52, 60}});  // 5.2 turns, at 72 degrees
    expect_offence(high.first_violation(path), time_at(path.length_mm * (5 + 120.0 / 360) / 10), 0, true);
    ZoneBox low = box(false, {-20, -5}, {-20, 20});
    low.add_side({.axis = 2, .joint = 2, .walls = {54, 60}});  // 5.4 turns, at 144 degrees
    expect_offence(low.first_violation(path), time_at(path.length_mm * 5.4 / 10), 2, false);
    ZoneBox between_turns = box(false, {-20, -9}, {-1, 1});
    between_turns.add_side({.axis = 2, .joint = 2, .walls = {56, 64}});
    EXPECT_FALSE(between_turns.first_violation(path));
}

// Two motions run at once, of which one takes x back.
TEST(ZoneBox, SuperimposedMotionsCrossWallsAtRootOfSum) {
    const motion::LawSection slowing{1, 0, 50, -50, 0};
    const motion::LawSection gaining{1, 0, 0, 50, 0};
    motion::Segment path;
    path.kind = motion::SegmentKind::linear;
    path.start = joints(0, 0);
    path.end = joints(25, 0);
    path.master = motion::TimeLaw::from_sections({&slowing, 1});
    path.duration_s = 1;
    auto superimposed = std::make_shared<motion::Segment>(path);
    superimposed->start = joints(25, 0);
    superimposed->end = joints(15, 15);
    superimposed->master = motion::TimeLaw::from_sections({&gaining, 1});
    path.superimposed = superimposed;
    // x = 50 t - 25 t^2 - 10 t^2 = 50 t - 35 t^2, at most 17.857 at t = 5/7; y = 15 t^2
    expect_offence(box(true, {-1, 17.5}, {-1, 20}).first_violation(path),
                   (50 - std::sqrt(2500 - 4 * 35 * 17.5)) / 70, 0, true);
    EXPECT_FALSE(box(true, {-1, 17.8572}, {-1, 15}).first_violation(path));
    EXPECT_TRUE(box(true, {-1, 17.8571}, {-1, 15}).first_violation(path));
    expect_offence(box(false, {-1, 20}, {5.4, 20}).first_violation(path), 0.6, 1, false);
}

// A circle in the frame of a conveyor: an arc, and a straight motion at once.
TEST(ZoneBox, ArcOnConveyorCrossesWallsBySumOfPaths) {
    motion::Segment path = arc(1, 0, 0, 0, 40, 0, 720);
    const motion::LawSection steady{path.duration_s, 0, 10, 0, 0};
    auto belt = std::make_shared<motion::Segment>(line(1, 0, joints(0, 0), joints(10 * path.duration_s, 0)));
    belt->master = motion::TimeLaw::from_sections({&steady, 1});
    belt->duration_s = path.duration_s;
    path.superimposed = belt;
    const auto x_at = [&](double t_s) { return 40 * std::cos(path.master.at(t_s).s / 40) + 10 * t_s; };
    double wall = 0;  // the highest x of the first half turn, and when that is
    double turns_s = 0;
    for (double t_s = 0; t_s < 1; t_s += 1e-4) {
        if (x_at(t_s) > wall) turns_s = t_s;
        wall = std::max(wall, x_at(t_s));
    }
    for (const double deviation_mm : {-1e-2, -1e-4}) {
        const auto left = box(true, {-100, wall + deviation_mm}, {-50, 50}).first_violation(path);
        ASSERT_TRUE(left);
        EXPECT_LT(left->t_s, turns_s);
        EXPECT_NEAR(x_at(left->t_s), wall + deviation_mm, 1e-9);
    }
    const auto later = box(true, {-100, wall + 1e-2}, {-50, 50}).first_violation(path);
    ASSERT_TRUE(later);
    EXPECT_GT(later->t_s, 2);
    EXPECT_NEAR(x_at(later->t_s), wall + 1e-2, 1e-9);
    expect_offence(box(false, {-100, 200}, {20, 100}).first_violation(path),
                   time_at(40 * std::numbers::pi / 6), 1, false);
}

TEST(ZoneBox, FollowerCrossesWallByItsTimeLaw) {
    motion::Segment path = line(1, 0, joints(0, 0), joints(100, 0));
    const double duration_s = path.duration_s;
    const motion::LawSection steady{duration_s, 0, 30 / duration_s, 0, 0};
    path.end = joints(100, 30);
    path.add_follower(1, 1, motion::TimeLaw::from_sections({&steady, 1}));
    expect_offence(box(false, {-1, 200}, {12, 40}).first_violation(path), 0.4 * duration_s, 1, false);
}

}  // namespace
}  // namespace gsim::simulation::zone_box_test
