#include "geometry/planar/nesting.h"

#include <gtest/gtest.h>

#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry::nesting_test {

namespace {

TEST(Nesting, ParentIsSmallestEnclosingContour) {
    const std::vector<Contour> contours = {circle({0, 0}, 1), rectangle({-10, -10}, {10, 10}),
                                           circle({0, 0}, 5), circle({7, 7}, 1), circle({30, 0}, 4)};
    const std::vector<NestingLevel> nestings = find_nesting(contours);
    EXPECT_EQ(nestings[0].depth, 2U);
    EXPECT_EQ(nestings[0].parent, 2U);
    EXPECT_EQ(nestings[1].depth, 0U);
    EXPECT_FALSE(nestings[1].parent);
    EXPECT_EQ(nestings[2].parent, 1U);
    EXPECT_EQ(nestings[3].parent, 1U);
    EXPECT_EQ(nestings[4].depth, 0U);
}

TEST(Nesting, BulgeCountsAsInside) {
    // The point lies between chord and arc.
    EXPECT_TRUE(inside(circle({0, 0}, 5), {0.5, 4.9}));
    EXPECT_TRUE(inside(circle({0, 0}, 5), {0, -4.9}));
    EXPECT_FALSE(inside(circle({0, 0}, 5), {3.6, 3.6}));
}

// Against the sum of angles under which the contour is seen.
TEST(Nesting, InsideAgreesWithWindingNumber) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-25, 25);
    for (int i = 0; i < 20; ++i) {
        const Contour contour = star(random, 15, 5, 20, 0.6);
        const std::vector<Point> points = flattened(contour, 1e-5);
        for (int k = 0; k < 20; ++k) {
            const Point probe{value(random), value(random)};
            double turned = 0;
            for (std::size_t p = 0; p < points.size(); ++p) {
                const Point a = points[p] - probe;
                const Point b = points[(p + 1) % points.size()] - probe;
                turned += std::atan2(cross(a, b), dot(a, b));
            }
            EXPECT_EQ(inside(contour, probe), std::abs(turned) > std::numbers::pi);
        }
    }
}

}  // namespace

}  // namespace gsim::geometry::nesting_test
