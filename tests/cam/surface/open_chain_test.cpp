// Paths along chains of edges that do not close.

#include <cmath>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/surface/surface_path.h"

namespace gsim::surface::open_chain_test {

namespace {

using solid::Vec3;
using solid::WallContour;
using solid::WallContours;
using solid::WallPoint;
using testing::HasSubstr;

constexpr double kKerf_mm = 1;
constexpr double kLead_mm = 3 * kKerf_mm;

Vec3 to_vec3(const Vector& v) {
    return {v.x(), v.y(), v.z()};
}

// Returns a chain through positions of the level face z = 0, with upright walls of 6 mm and material to the
// left.
WallContour chain_through(const std::vector<Vector>& corners) {
    WallContour chain{.face = "the plane face #1", .is_open = true};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vector tangent = (corners[i] - corners[i - 1]).normalized();
        const Vec3 waste_direction = to_vec3(tangent.cross(Vector::UnitZ()));
        solid::WallEdge edge{.name = "edge #" + std::to_string(i)};
        for (const Vector& at : {corners[i - 1], corners[i]})
            edge.points.push_back(
                {to_vec3(at), {0, 0, 1}, to_vec3(tangent), waste_direction, {0, 0, -1}, 6, waste_direction});
        chain.edges.push_back(edge);
    }
    return chain;
}

Result<cutting::Autopath> make_autopath(const std::vector<Vector>& corners,
                                        std::vector<solid::PartEdge> others = {},
                                        const SurfaceOptions& options = {}) {
    WallContours part;
    part.contours = {chain_through(corners)};
    part.other_edges = std::move(others);
    cutting::CutRules rules;
    rules.kerf_mm = kKerf_mm;
    rules.speed_mm_min = 300;
    return surface_path(part, rules, options);
}

std::vector<path::Point> path_points(const cutting::Autopath& path) {
    std::vector<path::Point> points;
    for (const path::Target& target : path.program.paths.at(1).targets)
        points.push_back(std::get<path::Point>(target));
    return points;
}

// X of each move with the jet on, and of the pierce.
std::vector<double> xs_with_jet(const cutting::Autopath& path) {
    std::vector<double> xs;
    bool on = false;
    for (const path::Point& point : path_points(path)) {
        const auto has = [&](const std::string& action) {
            return std::find(point.actions.begin(), point.actions.end(), action) != point.actions.end();
        };
        if (has("waterjet_on")) on = true;
        if (on) {
            xs.push_back(point.position_mm[0]);
            EXPECT_NEAR(point.position_mm[1], -kKerf_mm / 2, 1e-9);
        }
        if (has("waterjet_off")) on = false;
    }
    return xs;
}

TEST(OpenChain, PathExtendsStraightBeyondEnds) {
    const auto path = make_autopath({{0, 0, 0}, {10, 0, 0}, {30, 0, 0}});
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->summary.outlines, 1U);
    EXPECT_EQ(path->summary.pierces, 1U);
    EXPECT_EQ(path->summary.without_leads, 0U);
    EXPECT_NEAR(path->summary.cut_mm, 30 + 2 * kLead_mm, 1e-9);
    EXPECT_EQ(xs_with_jet(*path), (std::vector<double>{-kLead_mm, 0, 30, 30 + kLead_mm}));
}

TEST(OpenChain, RoundsOuterCornerButNotEnds) {
    const auto path = make_autopath({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}});
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_NEAR(path->summary.cut_mm, 40 + 2 * kLead_mm + kKerf_mm / 2 * std::acos(0), 0.01);
}

TEST(OpenChain, EdgeAheadRemovesOnlyLeadOfThatEnd) {
    // A wall across the path, 1 mm beyond the end; the jet itself is half its width away from it.
    const std::vector<solid::PartEdge> wall{{"edge #9", {{31, -20, 0}, {31, 20, 0}}}};
    const auto path = make_autopath({{0, 0, 0}, {30, 0, 0}}, wall);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->summary.without_leads, 1U);
    EXPECT_EQ(xs_with_jet(*path), (std::vector<double>{-kLead_mm, 0, 30}));
    EXPECT_THAT(path->notes, testing::Contains(HasSubstr("1 contours have no room for lead-ins")));
    // An edge next to the path, half of the kerf off the jet, is no obstacle.
    const auto adjacent = make_autopath({{0, 0, 0}, {30, 0, 0}}, {{"edge #9", {{31, 0, 0}, {50, 0, 0}}}});
    EXPECT_EQ(adjacent->summary.without_leads, 0U);
}

TEST(OpenChain, RejectsCutIntoOtherEdgeOfPart) {
    const auto path = make_autopath({{0, 0, 0}, {30, 0, 0}}, {{"edge #9", {{30, -20, 0}, {30, 0, 0}}}});
    ASSERT_FALSE(path);
    EXPECT_THAT(path.error().message,
                HasSubstr("edge #1 cannot be cut: at (30, 0, 0) the jet would cut 0.5 mm into edge #9"));
}

TEST(OpenChain, KeepsBridgesAndRejectsTooMany) {
    SurfaceOptions options;
    options.bridges = {2, 2};
    const auto path = make_autopath({{0, 0, 0}, {40, 0, 0}}, {}, options);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->summary.pierces, 3U);
    // Each is 2 mm wide, and the jet besides.
    EXPECT_NEAR(path->summary.cut_mm, 40 - 2 * 3 + 2 * kLead_mm, 1e-9);
    options.bridges = {7, 2};
    const auto narrow = make_autopath({{0, 0, 0}, {40, 0, 0}}, {}, options);
    ASSERT_FALSE(narrow);
    EXPECT_EQ(narrow.error().message,
              "a chain of edges of the plane face #1 has no room for 7 bridges of 2 mm");
}

}  // namespace

}  // namespace gsim::surface::open_chain_test
