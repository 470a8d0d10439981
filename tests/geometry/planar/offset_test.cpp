#include "geometry/planar/offset.h"

#include <gtest/gtest.h>

#include "geometry/planar/box_tree.h"
#include "geometry/planar/crossing.h"
#include "tests/geometry/planar/clipper_area.h"
#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry::offset_test {

namespace {

constexpr double kPi = std::numbers::pi;

double total_area(const std::vector<Contour>& contours) {
    double sum = 0;
    for (const Contour& contour : contours) sum += area_mm2(contour);
    return sum;
}

std::vector<Contour> offset_of(const Contour& contour, double distance_mm) {
    auto result = offset(contour, distance_mm);
    EXPECT_TRUE(result) << result.error().message << result.error().location.x << ' '
                        << result.error().location.y;
    return result ? *result : std::vector<Contour>{};
}

TEST(Offset, AreaOfConvexShapesMatchesSteinerFormula) {
    Contour slot;
    slot.closed = true;
    slot.vertices = {{{0, -2}, 0, 0}, {{10, -2}, 1, 0}, {{10, 2}, 0, 0}, {{0, 2}, 1, 0}};
    for (const Contour& contour :
         {rectangle({0, 0}, {30, 20}), circle({500, 3}, 12), slot, polygon({{0, 0}, {40, 1}, {13, 29}})}) {
        for (const double d : {0.001, 0.4, 3.0, 100.0}) {
            const std::vector<Contour> expanded = offset_of(contour, d);
            ASSERT_EQ(expanded.size(), 1U);
            const double expected = area_mm2(contour) + length_mm(contour) * d + kPi * d * d;
            EXPECT_NEAR(area_mm2(expanded[0]), expected, 1e-9 * expected);
            EXPECT_NEAR(length_mm(expanded[0]), length_mm(contour) + 2 * kPi * d, 1e-6);
        }
    }
}

TEST(Offset, ShrinksRectangleToRectangleThenNothing) {
    const Contour contour = rectangle({0, 0}, {30, 20});
    const std::vector<Contour> shrunk = offset_of(contour, -4);
    ASSERT_EQ(shrunk.size(), 1U);
    EXPECT_NEAR(area_mm2(shrunk[0]), 22 * 12, 1e-9);
    EXPECT_TRUE(offset_of(contour, -10.001).empty());
    EXPECT_TRUE(offset_of(circle({}, 3), -3).empty());
}

TEST(Offset, SplitsDumbbellIntoTwo) {
    const Contour dumbbell = polygon({{0, 0},
                                      {10, 0},
                                      {10, 4},
                                      {20, 4},
                                      {20, 0},
                                      {30, 0},
                                      {30, 10},
                                      {20, 10},
                                      {20, 6},
                                      {10, 6},
                                      {10, 10},
                                      {0, 10}});
    const std::vector<Contour> parts = offset_of(dumbbell, -1.5);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_NEAR(total_area(parts), clipper_offset_area_mm2(dumbbell, -1.5), 0.01);
}

TEST(Offset, AreaOfContourWithCuspsMatchesClipper) {
    Contour horns;  // a rectangle with a bite that leaves two horns without an angle
    horns.closed = true;
    horns.vertices = {{{10, 2.5}, 0, 0}, {{5, 2.5}, 0, 0}, {{5, -2.5}, 0, 0}, {{10, -2.5}, -1, 0}};
    Contour slit = horns;  // the same from the other side: slits that close completely
    reverse(slit);
    for (const double d : {-0.4, 0.4}) {
        EXPECT_NEAR(total_area(offset_of(horns, d)), clipper_offset_area_mm2(horns, d, 1e-5), 0.005);
        EXPECT_NEAR(total_area(offset_of(slit, -d)), -total_area(offset_of(horns, d)), 1e-6);
    }
}

TEST(Offset, AcceptsRoundedTangent) {
    // Lines leave the arcs of a slot 3e-4 rad off their tangents, as a drawing program wrote them.
    Contour slot;
    slot.closed = true;
    slot.vertices = {{{8.23153742199, 7.98769132675}, 0, 0},
                     {{13.231537422, 16.6476913268}, 1, 0},
                     {{9.77, 18.64858001}, 0, 0},
                     {{4.76846257801, 9.98946869325}, 1, 0}};
    for (const double d : {-0.4, 0.4}) {
        EXPECT_NEAR(total_area(offset_of(slot, d)), clipper_offset_area_mm2(slot, d, 1e-5), 0.005);
    }
}

TEST(Offset, AcceptsSlotAsWideAsTool) {
    // The walls are at exactly twice the distance.
    const Contour comb = polygon({{0, 0}, {30, 0}, {30, 20}, {20, 20}, {20, 5}, {18, 5}, {18, 20}, {0, 20}});
    const std::vector<Contour> expanded = offset_of(comb, 1);
    EXPECT_NEAR(total_area(expanded), clipper_offset_area_mm2(comb, 1), 0.01);
}

// No point of the offset is nearer to the contour than the distance, or farther.
TEST(Offset, KeepsDistanceEverywhere) {
    std::mt19937 random(31);
    for (int i = 0; i < 20; ++i) {
        const Contour contour = star(random, 40, 20, 40, 0.5);
        const BoxTree tree(edge_boxes(contour));
        for (const double d : {-1.5, 0.4, 2.0}) {
            for (const Contour& loop : offset_of(contour, d)) {
                for (const Point& point : flattened(loop, 1e-3)) {
                    double nearest = HUGE_VAL;
                    for (std::size_t e = 0; e < contour.edges(); ++e) {
                        nearest = std::min(nearest, distance_mm(contour.edge(e), point));
                    }
                    EXPECT_NEAR(nearest, std::abs(d), 1e-4);
                }
            }
        }
    }
}

TEST(Offset, AreaOfRandomShapesMatchesClipper) {
    std::mt19937 random(32);
    for (int i = 0; i < 40; ++i) {
        const Contour contour = star(random, 5 + 2 * i, 10, 40, (i % 5) / 4.0);
        for (const double d : {-3.0, -0.5, 0.5, 4.0}) {
            const std::vector<Contour> result = offset_of(contour, d);
            EXPECT_NEAR(total_area(result), clipper_offset_area_mm2(contour, d),
                        1e-3 * std::abs(area_mm2(contour)))
                << i << ' ' << d;
            EXPECT_FALSE(find_crossing(result, 1e-3)) << i << ' ' << d;
        }
    }
}

TEST(Offset, NearlyTangentEdgesJoin) {
    // A circle of many arcs and chords with directions that differ by little or by rounding alone.
    for (const int count : {8, 100, 1000}) {
        for (const double part_of_bulge : {0.0, 0.5, 1.0}) {
            Contour contour;
            contour.closed = true;
            for (int i = 0; i < count; ++i) {
                const double angle = 2 * kPi * i / count;
                contour.vertices.push_back({{20 * std::cos(angle), 20 * std::sin(angle)},
                                            part_of_bulge * std::tan(kPi / 2 / count),
                                            0});
            }
            for (const double d : {-0.5, 0.5}) {
                const std::vector<Contour> loops = offset_of(contour, d);
                ASSERT_EQ(loops.size(), 1U);
                EXPECT_NEAR(area_mm2(loops[0]), clipper_offset_area_mm2(contour, d), 0.05);
            }
        }
    }
}

}  // namespace

}  // namespace gsim::geometry::offset_test
