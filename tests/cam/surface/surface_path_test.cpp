#include "cam/surface/surface_path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::surface::surface_path_test {

namespace {

using solid::Vec3;
using solid::WallContour;
using solid::WallContours;
using solid::WallEdge;
using solid::WallPoint;
using testing::HasSubstr;

constexpr double kKerf_mm = 0.8;
constexpr double kDepth_mm = 6;

Vec3 to_vec3(const Vector& v) {
    return {v.x(), v.y(), v.z()};
}

// A point of the level face z = 0. The wall leans over the waste by an angle: the part is smaller below.
WallPoint wall_point(const Vector& at, const Vector& tangent, double tilt_rad = 0) {
    const Vector up(0, 0, 1);
    const Vector waste_direction = tangent.cross(up);
    WallPoint point;
    point.position_mm = to_vec3(at);
    point.normal = to_vec3(up);
    point.tangent = to_vec3(tangent);
    point.wall_normal = to_vec3(std::cos(tilt_rad) * waste_direction - std::sin(tilt_rad) * up);
    point.along_wall = to_vec3(-std::cos(tilt_rad) * up - std::sin(tilt_rad) * waste_direction);
    point.depth_mm = kDepth_mm / std::cos(tilt_rad);
    point.exit_normal = point.wall_normal;
    return point;
}

// A round hole: material to the left means clockwise, seen from above.
WallContour round_hole(double radius_mm, double tilt_rad = 0) {
    WallEdge edge{"edge #7", {}, 0};
    for (int i = 0; i <= 360; ++i) {
        const double turn = -std::numbers::pi / 180 * i;
        const Vector out(std::cos(turn), std::sin(turn), 0);
        edge.points.push_back(wall_point(radius_mm * out, Vector(0, 0, -1).cross(out), tilt_rad));
    }
    return {"the plane face #1", true, {edge}};
}

// Returns consecutive corners, with material to the left.
WallContour polygon(const std::vector<Vector>& corners, bool is_hole) {
    WallContour contour{"the plane face #1", is_hole, {}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector& from = corners[i];
        const Vector& to = corners[(i + 1) % corners.size()];
        const Vector along = (to - from).normalized();
        contour.edges.push_back(
            {"edge #" + std::to_string(i + 1),
             {wall_point(from, along), wall_point((from + to) / 2, along), wall_point(to, along)},
             0});
    }
    return contour;
}

cutting::CutRules some_rules() {
    cutting::CutRules rules;
    rules.kerf_mm = kKerf_mm;
    rules.speed_mm_min = 300;
    return rules;
}

Result<cutting::Autopath> make_autopath(const WallContour& contour, SurfaceOptions options = {},
                                        const cutting::CutRules& rules = some_rules()) {
    WallContours part;
    part.contours = {contour};
    return surface_path(part, rules, options);
}

std::string rejection(const WallContour& contour, const SurfaceOptions& options = {}) {
    const auto path = make_autopath(contour, options);
    return path ? "" : path.error().message;
}

std::vector<path::Point> path_points(const cutting::Autopath& path) {
    std::vector<path::Point> points;
    for (const path::Target& target : path.program.paths.at(1).targets)
        points.push_back(std::get<path::Point>(target));
    return points;
}

TEST(SurfacePath, RoundHoleGivesArcsHalfKerfInside) {
    const auto path = make_autopath(round_hole(5));
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->summary.pierces, 1U);
    EXPECT_EQ(path->summary.without_leads, 0U);
    int on_hole = 0;
    for (const path::Point& point : path_points(*path)) {
        const double radius = std::hypot(point.position_mm[0], point.position_mm[1]);
        EXPECT_LE(radius, 5 - kKerf_mm / 2 + 0.006);
        if (point.motion == path::MotionType::circular && std::abs(radius - 4.6) < 0.006) ++on_hole;
    }
    EXPECT_GE(on_hole, 3);  // the lead-in, and at least two arcs round the hole
    EXPECT_LE(on_hole, 6);
}

TEST(SurfacePath, OffsetsTcpOfTiltedJetByCutHeight) {
    const double tilt = 0.3;
    SurfaceOptions options;
    options.cut_height_mm = 2;
    const auto path = make_autopath(round_hole(20, tilt), options);
    ASSERT_TRUE(path) << path.error().message;
    // The distance from the edge is the height's share, plus half of the kerf across the level face.
    const double lateral = 2 * std::tan(tilt) + kKerf_mm / 2 / std::cos(tilt);
    for (const path::Point& point : path_points(*path)) {
        if (point.motion != path::MotionType::circular || !point.orientation) continue;
        EXPECT_NEAR(std::hypot(point.position_mm[0], point.position_mm[1]), 20 - lateral, 0.006);
        EXPECT_NEAR(point.position_mm[2], 2, 0.006);
        const auto& axis = std::get<path::ToolAxis>(*point.orientation).direction;
        EXPECT_NEAR(axis[2], std::cos(tilt), 1e-9);
    }
}

TEST(SurfacePath, TrimsInnerCornersAndRoundsOuterCorners) {
    const std::vector<Vector> square{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    const auto outside = make_autopath(polygon(square, false));
    const auto inside = make_autopath(polygon({square.rbegin(), square.rend()}, true));
    ASSERT_TRUE(outside) << outside.error().message;
    ASSERT_TRUE(inside) << inside.error().message;
    double max = 0;
    for (const path::Point& point : path_points(*inside))
        max = std::max({max, std::abs(point.position_mm[0]), std::abs(point.position_mm[1])});
    EXPECT_NEAR(max, 10 - kKerf_mm / 2, 1e-6);
    int arcs = 0;
    for (const path::Point& point : path_points(*outside)) {
        if (point.motion != path::MotionType::circular) continue;
        ++arcs;
        const auto& at = point.position_mm;
        const double out_of_range =
            std::hypot(std::max(std::abs(at[0]) - 10, 0.0), std::max(std::abs(at[1]) - 10, 0.0));
        EXPECT_GE(out_of_range, kKerf_mm / 2 - 0.006);
    }
    EXPECT_GE(arcs, 4 + 2);  // the corners and both leads
}

TEST(SurfacePath, ReducesFeedBeforeAndAfterInnerCorners) {
    cutting::CutRules rules = some_rules();
    rules.feed_in_corner_mm_min = [](double turn_rad) { return turn_rad > 1.5 ? 100.0 : 300.0; };
    rules.corner_zone_mm = 2;
    const std::vector<Vector> square{{-10, 10, 0}, {10, 10, 0}, {10, -10, 0}, {-10, -10, 0}};
    const auto path = make_autopath(polygon(square, true), {}, rules);
    ASSERT_TRUE(path) << path.error().message;
    const std::vector<path::Point> points = path_points(*path);
    double slow_mm = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto& from = points[i - 1].position_mm;
        const auto& to = points[i].position_mm;
        if (!points[i].feed_mm_min || points[i].motion != path::MotionType::linear) continue;
        const double mm = std::hypot(to[0] - from[0], to[1] - from[1]);
        if (*points[i].feed_mm_min < 200) slow_mm += mm;
        // If the feed is slow, a corner of the jet's path is as near as the zone.
        const double nearest =
            std::hypot(std::abs(to[0]) - 10 + kKerf_mm / 2, std::abs(to[1]) - 10 + kKerf_mm / 2);
        if (*points[i].feed_mm_min < 200) {
            EXPECT_LT(nearest, 2 + 1e-6);
        }
    }
    EXPECT_NEAR(slow_mm, 4 * 2 * 2, 1e-6);
    EXPECT_NEAR(path->summary.slowdown_s, 60 * slow_mm * (1.0 / 100 - 1.0 / 300), 1e-6);
}

TEST(SurfacePath, TiltedJetIsSlowerByCutDepth) {
    const double tilt = 0.9;
    cutting::CutRules rules = some_rules();
    const auto plain = make_autopath(round_hole(20, tilt), {}, rules);
    rules.speed_at_depth_mm_min = [](double depth_mm) { return 300 * kDepth_mm / depth_mm; };
    const auto slower = make_autopath(round_hole(20, tilt), {}, rules);
    const auto upright = make_autopath(round_hole(20), {}, rules);
    ASSERT_TRUE(plain && slower && upright);
    // The jet's path through the wall is longer by 1 / cos.
    EXPECT_NEAR(plain->summary.cut_s / slower->summary.cut_s, std::cos(tilt), 1e-6);
    for (const path::Point& point : path_points(*upright)) {
        if (!point.feed_mm_min) continue;
        EXPECT_LE(*point.feed_mm_min, 300.0 + 1e-9);
    }
}

TEST(SurfacePath, TiltsJetFromFaceNormalOverWaste) {
    SurfaceOptions options;
    options.jet.along_walls = false;
    options.jet.tilt_deg = 30;
    const auto path = make_autopath(round_hole(20), options);
    ASSERT_TRUE(path) << path.error().message;
    for (const path::Point& point : path_points(*path)) {
        if (!point.orientation) continue;
        const auto& axis = std::get<path::ToolAxis>(*point.orientation).direction;
        const auto& at = point.position_mm;
        EXPECT_NEAR(axis[2], std::cos(std::numbers::pi / 6), 1e-6);
        if (point.motion == path::MotionType::circular) {
            EXPECT_LT(at[0] * axis[0] + at[1] * axis[1], 0);  // towards the middle of the hole
        }
    }
}

TEST(SurfacePath, BridgesShortenCutAndAddPierces) {
    SurfaceOptions options;
    options.bridges = {3, 0.5};
    const auto full = make_autopath(round_hole(20));
    const auto retained = make_autopath(round_hole(20), options);
    ASSERT_TRUE(full && retained);
    EXPECT_EQ(retained->summary.pierces, 4U);
    // Each bridge takes its width and that of the jet from the edge; the jet's path is shorter by the ratio
    // of radii.
    const double share = (20 - kKerf_mm / 2) / 20;
    EXPECT_NEAR(full->summary.cut_mm - retained->summary.cut_mm, 3 * (0.5 + kKerf_mm) * share, 0.01);
    options.bridges = {40, 2};
    EXPECT_EQ(rejection(round_hole(20), options),
              "a hole of the plane face #1 has no room for 40 bridges of 2 mm");
}

TEST(SurfacePath, ErrorsNameEdgeAndReason) {
    EXPECT_EQ(rejection(round_hole(0.3)),
              "edge #7 cannot be cut: at (0.299954, -0.00523572, 0) its radius is smaller than half the "
              "kerf, 0.4 mm");
    EXPECT_EQ(rejection(round_hole(20, 1.2)),
              "edge #7 cannot be cut: at (20, 0, 0) the jet would be tilted 68.75 deg from the face normal, "
              "more than 60 deg (--max-tilt)");
    // A slit of 0.6 mm: the paths along both sides do not even cross.
    const std::vector<Vector> slit{{0, 0, 0}, {0, 0.6, 0}, {20, 0.6, 0}, {20, 0, 0}};
    EXPECT_THAT(rejection(polygon(slit, true)),
                HasSubstr("cannot be cut: it is narrower than the kerf of 0.8 mm"));
    // Narrow in its middle, wide at its ends.
    const std::vector<Vector> waist{{0, 0, 0},    {0, 6, 0},    {8, 6, 0},   {9, 3.3, 0},
                                    {11, 3.3, 0}, {12, 6, 0},   {20, 6, 0},  {20, 0, 0},
                                    {12, 0, 0},   {11, 2.7, 0}, {9, 2.7, 0}, {8, 0, 0}};
    EXPECT_THAT(rejection(polygon(waist, true)), HasSubstr("the jet would cut"));
}

TEST(SurfacePath, ReportsSurfaceHitByJetAfterWall) {
    WallContour hole = round_hole(5);
    hole.edges.front().next_surface_mm = 42;
    const auto path = make_autopath(hole);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_THAT(
        path->notes,
        testing::Contains(
            "after edge #7 of the plane face #1 the jet hits the part again, at a distance of 42 mm"));
}

}  // namespace
}  // namespace gsim::surface::surface_path_test
