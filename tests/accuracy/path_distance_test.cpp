#include "tests/accuracy/path_distance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace gsim::accuracy::path_distance_test {
namespace {

constexpr double kAcceleration_mm_s2 = 500;
constexpr double kMove_s = 0.8;  // until standstill at the target
constexpr double kLength_mm = kAcceleration_mm_s2 * kMove_s * kMove_s / 4;

// Returns the distance of a move that speeds up for half its time and slows down for the other half.
double distance_mm(double t_s) {
    if (t_s <= 0) return 0;
    if (t_s >= kMove_s) return kLength_mm;
    if (t_s <= kMove_s / 2) return kAcceleration_mm_s2 * t_s * t_s / 2;
    const double remaining_s = kMove_s - t_s;
    return kLength_mm - kAcceleration_mm_s2 * remaining_s * remaining_s / 2;
}

// Line 3 along X, after a pause line 5 along Y, sampled every 10 ms.
TimedPath two_moves(double pause_s, double sideways_mm = 0) {
    TimedPath path;
    const double second_s = kMove_s + pause_s;
    const double end_s = second_s + kMove_s;
    for (int i = 0; i * 0.01 <= end_s; ++i) {
        const double t_s = i * 0.01;
        path.trajectory.push_back({t_s, {distance_mm(t_s), distance_mm(t_s - second_s), sideways_mm}});
    }
    path.trajectory.push_back({end_s, {kLength_mm, kLength_mm, sideways_mm}});
    path.blocks = {{3, 0, kMove_s}, {5, second_s, end_s}};
    return path;
}

TEST(PathDistance, IsZeroForSamePath) {
    const auto distance = largest_distance(two_moves(0), two_moves(0));
    ASSERT_TRUE(distance) << distance.error().message;
    EXPECT_NEAR(distance->mm, 0, 1e-9);
}

TEST(PathDistance, MeasuresTimeFromStartOfEachBlock) {
    const auto distance = largest_distance(two_moves(0), two_moves(0.303));
    ASSERT_TRUE(distance) << distance.error().message;
    // Between samples 10 ms apart a straight line misses a parabola by at most a t^2 / 8. The samples of the
    // second block are cut at its borders.
    EXPECT_LT(distance->mm, kAcceleration_mm_s2 * 0.01 * 0.01 / 2);
}

TEST(PathDistance, IsMaximumOverTime) {
    EXPECT_NEAR(largest_distance(two_moves(0), two_moves(0, 3))->mm, 3, 1e-9);

    TimedPath late = two_moves(0);  // all of it 20 ms late, but the blocks are said to begin on time
    for (Sample& sample : late.trajectory) sample.t_s += 0.02;
    const auto distance = largest_distance(two_moves(0), late);
    ASSERT_TRUE(distance);
    const double top_speed_mm_s = kAcceleration_mm_s2 * kMove_s / 2;
    EXPECT_NEAR(distance->mm, top_speed_mm_s * 0.02, kAcceleration_mm_s2 * 0.02 * 0.02);
    EXPECT_NEAR(distance->into_block_s, kMove_s / 2 + 0.01, 0.011);
}

TEST(PathDistance, HoldsPositionAfterEarlierBlockEnd) {
    TimedPath recorded = two_moves(0);
    TimedPath found = two_moves(0);
    found.blocks[0].end_s = kMove_s / 2;  // half the path, and no farther
    const auto distance = largest_distance(recorded, found);
    ASSERT_TRUE(distance);
    EXPECT_NEAR(distance->mm, kLength_mm / 2, 1e-9);
    EXPECT_EQ(distance->line, 3);
    EXPECT_NEAR(distance->into_block_s, kMove_s, 1e-9);
}

TEST(PathDistance, NamesFirstDifferentBlock) {
    TimedPath found = two_moves(0);
    found.blocks[1].line = 6;
    EXPECT_EQ(largest_distance(two_moves(0), found).error().message, "block 2 is line 6, line 5 is recorded");
    found.blocks.pop_back();
    EXPECT_EQ(largest_distance(two_moves(0), found).error().message,
              "block 2 is the end, line 5 is recorded");
    EXPECT_EQ(largest_distance(found, two_moves(0)).error().message,
              "block 2 is line 5, the end is recorded");
}

TEST(PathDistance, RejectsPathsWithoutBlocks) {
    TimedPath nothing = two_moves(0);
    nothing.blocks.clear();
    EXPECT_EQ(largest_distance(nothing, nothing).error().message, "no sample lies in a block");
}

}  // namespace
}  // namespace gsim::accuracy::path_distance_test
