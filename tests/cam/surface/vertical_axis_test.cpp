#include <gtest/gtest.h>

#include "base/units.h"
#include "cam/surface/vertical_points.h"

namespace gsim::surface::upright_test {

namespace {

JetPoint at(double x, double azimuth_deg, double tilt_deg) {
    JetPoint point;
    point.edge_mm = {x, 0, 0};
    point.normal = {0, 0, 1};
    point.axis = axis_direction(azimuth_deg * kRadPerDeg, tilt_deg * kRadPerDeg);
    return point;
}

double azimuth_deg(const JetPoint& point) {
    return azimuth_rad(point.axis) * kDegPerRad;
}

TEST(VerticalAxis, TiltsSlightlyTowardsNextDirection) {
    std::vector<JetPoint> points{at(0, 0, 0), at(1, 0, 0), at(2, 40, 2), at(3, 50, 4)};
    split_vertical_points(points);
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(tilt_rad(points[0].axis), 0);
    EXPECT_NEAR(tilt_rad(points[1].axis), kSingularityTilt_deg * kRadPerDeg, 1e-12);
    EXPECT_NEAR(azimuth_deg(points[1]), 30, 1e-6);  // the turn continues evenly
}

TEST(VerticalAxis, TurnsOnSpotBetweenTwoTilts) {
    std::vector<JetPoint> points{at(0, 10, 4), at(1, 10, 2), at(2, 0, 0), at(3, 120, 2), at(4, 120, 4)};
    split_vertical_points(points);
    ASSERT_EQ(points.size(), 6U);
    EXPECT_NEAR(azimuth_deg(points[2]), 10, 1e-6);
    EXPECT_NEAR(azimuth_deg(points[3]), 120, 1e-6);
    EXPECT_EQ(points[2].edge_mm, points[3].edge_mm);
}

TEST(VerticalAxis, KeepsVerticalPath) {
    std::vector<JetPoint> points{at(0, 0, 0), at(1, 0, 0)};
    split_vertical_points(points);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(tilt_rad(points[0].axis), 0);
}

}  // namespace
}  // namespace gsim::surface::upright_test
