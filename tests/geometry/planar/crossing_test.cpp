#include "geometry/planar/crossing.h"

#include <gtest/gtest.h>

#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry::crossing_test {

namespace {

std::optional<Crossing> crossing_of(const std::vector<Contour>& contours) {
    return find_crossing(contours, 1e-3);
}

TEST(Crossing, FindsCrossingInMiddleOfBowTie) {
    const auto found = crossing_of({polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})});
    ASSERT_TRUE(found);
    EXPECT_NEAR(distance(found->location, {5, 5}), 0, 1e-9);
}

TEST(Crossing, ReportsBothContours) {
    const auto found = crossing_of({rectangle({0, 0}, {10, 10}), circle({10, 5}, 2)});
    ASSERT_TRUE(found);
    EXPECT_NE(found->contour_a, found->contour_b);
    EXPECT_NEAR(found->location.x, 10, 1e-9);
}

TEST(Crossing, FindsTouchingContours) {
    EXPECT_TRUE(crossing_of({rectangle({0, 0}, {10, 10}), rectangle({10, 3}, {20, 5})}));
    EXPECT_TRUE(crossing_of({circle({0, 0}, 3), circle({5, 0}, 2)}));
}

TEST(Crossing, FindsLineOverlappingItself) {
    EXPECT_TRUE(crossing_of({polygon({{0, 0}, {10, 0}, {10, 10}, {10, 4}, {0, 4}})}));
}

TEST(Crossing, FindsNoneInValidContours) {
    std::mt19937 random(8);
    EXPECT_FALSE(
        crossing_of({rectangle({-30, -30}, {30, 30}), star(random, 30, 10, 20, 0.5), circle({}, 5)}));
}

TEST(Crossing, IgnoresRoundedTangent) {
    Contour contour;
    contour.closed = true;
    // The arc begins 1e-5 rad off the line's direction.
    contour.vertices = {{{0, 0}, 0, 0},
                        {{10, 0}, std::tan(std::numbers::pi / 4 - 1e-5), 0},
                        {{10, 20}, 0, 0},
                        {{0, 20}, 0, 0}};
    EXPECT_FALSE(crossing_of({contour}));
}

}  // namespace

}  // namespace gsim::geometry::crossing_test
