#include "cam/cutting/autopath.h"

#include <gtest/gtest.h>

#include "cam/cutting/lead.h"
#include "geometry/planar/intersection.h"
#include "geometry/planar/nesting.h"
#include "tests/cam/cutting/cut_path.h"
#include "tests/geometry/planar/shapes.h"
#include "toolpath/model/validate.h"

namespace gsim::cutting::autopath_test {

namespace {

using geometry::Contour;
using geometry::Point;

CutRules rules() {
    CutRules rules;
    rules.kerf_mm = 0.8;
    rules.speed_mm_min = 300;
    rules.pierce_s = 2;
    return rules;
}

Autopath path_of(const std::vector<Contour>& contours, const AutopathOptions& options = {}) {
    auto result = autopath(drawing_of(contours), rules(), options);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : Autopath{};
}

TEST(Autopath, CutsCircleWithLeads) {
    AutopathOptions options;
    options.lead_mm = 2;
    const Autopath result = path_of({geometry::circle({50, 50}, 10)}, options);
    EXPECT_EQ(result.summary.pierces, 1U);
    constexpr double kPi = std::numbers::pi;
    EXPECT_NEAR(result.summary.cut_mm, 2 * kPi * 10.4 + 2 * kPi, 1e-6);
    EXPECT_NEAR(result.summary.cut_s, result.summary.cut_mm / 300 * 60, 1e-6);
    const std::vector<JetPath> ways = jet_ways(result.program);
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_NEAR(length_mm(ways[0].jet_path), result.summary.cut_mm, 1e-6);
    EXPECT_GT(distance(ways[0].pierce, {50, 50}), 10.4);
}

// Plates have random holes at any position: the jet's path is never nearer to a contour than half of the
// kerf.
TEST(Autopath, JetStaysHalfKerfOffAllContours) {
    std::mt19937 random(61);
    for (int i = 0; i < 10; ++i) {
        std::vector<Contour> contours = {geometry::rectangle({-60, -60}, {60, 60})};
        for (const Point at : {Point{-30, -30}, Point{30, -30}, Point{-30, 30}, Point{30, 30}}) {
            Contour hole = geometry::star(random, 12, 8, 25, 0.5);
            for (geometry::Vertex& vertex : hole.vertices) vertex.position = at + vertex.position;
            contours.push_back(hole);
        }
        const auto result = autopath(drawing_of(contours), rules(), {});
        if (!result) continue;  // a random hole came too near to another one
        EXPECT_FALSE(path::validate(result->program));
        for (const JetPath& path : jet_ways(result->program)) {
            for (const Point& point : geometry::flattened(path.jet_path, 0.01)) {
                for (const Contour& contour : contours) {
                    for (std::size_t e = 0; e < contour.edges(); ++e) {
                        ASSERT_GE(distance_mm(contour.edge(e), point), 0.4 - 0.001);
                    }
                }
                // In waste: outside of the plate or within a hole.
                std::size_t around = 0;
                for (const Contour& contour : contours) around += inside(contour, point) ? 1 : 0;
                ASSERT_EQ(around % 2, 0U);
            }
        }
    }
}

// Two edges that face each other, nearer than their two leads are deep.
TEST(Autopath, LeadsOfAdjacentPartsDoNotIntersect) {
    std::vector<Contour> contours;
    for (int i = 0; i < 6; ++i) {
        Contour part = geometry::rectangle({15.0 * i, 0}, {15.0 * i + 10, 40});
        // The right side first, or the left one.
        std::rotate(part.vertices.begin(), part.vertices.begin() + (i % 2 == 0 ? 1 : 3), part.vertices.end());
        contours.push_back(part);
    }
    const auto layout = make_layout(drawing_of(contours), {0.8, 0.02});
    ASSERT_TRUE(layout);
    const std::vector<Cut> cuts = add_leads(*layout, 0.8, 2.4);
    std::vector<geometry::Edge> leads;
    for (const Cut& cut : cuts) {
        ASSERT_TRUE(cut.lead_in && cut.lead_out);
        for (const geometry::Edge& lead : {*cut.lead_in, *cut.lead_out}) {
            EXPECT_NEAR(radius_mm(lead), 2.4, 1e-9) << "there is room for whole ones";
            for (const geometry::Edge& other : leads) {
                const bool own = distance(other.end, lead.start) < 1e-9;
                EXPECT_TRUE(own || geometry::intersections(lead, other).count == 0);
                for (const double share : {0.0, 0.3, 0.6, 1.0}) {
                    EXPECT_TRUE(own || distance_mm(other, point_at(lead, share)) > 0.7);
                }
            }
            leads.push_back(lead);
        }
    }
}

TEST(Autopath, CutsHolesBeforeOutline) {
    const Autopath result = path_of({geometry::rectangle({0, 0}, {100, 50}), geometry::circle({20, 25}, 8),
                                     geometry::circle({80, 25}, 8)});
    const std::vector<JetPath> ways = jet_ways(result.program);
    ASSERT_EQ(ways.size(), 3U);
    EXPECT_GT(length_mm(ways[2].jet_path), 300);
}

TEST(Autopath, BevelTiltsToolOverWaste) {
    AutopathOptions options;
    options.program.bevel_deg = 30;
    const Autopath result = path_of({geometry::rectangle({0, 0}, {40, 30})}, options);
    EXPECT_FALSE(path::validate(result.program));
    double highest = 0;
    for (const path::Target& target : result.program.paths[1].targets) {
        const auto& point = std::get<path::Point>(target);
        if (!point.orientation) continue;
        const auto& axis = std::get<path::ToolAxis>(*point.orientation).direction;
        EXPECT_NEAR(axis[2], std::cos(std::numbers::pi / 6), 1e-9);
        EXPECT_NEAR(std::hypot(axis[0], axis[1]), 0.5, 1e-9);
        // Beyond the upper edge of the rectangle the waste is above. The TCP is 3 mm over the material.
        const double length = 30 + 0.4 / std::cos(std::numbers::pi / 6) + 3 * std::tan(std::numbers::pi / 6);
        if (std::abs(point.position_mm[1] - length) < 1e-6 && std::abs(axis[0]) < 1e-6) highest = axis[1];
    }
    EXPECT_NEAR(highest, 0.5, 1e-9);
}

// The side of the part that a jet leaves, above a depth: half of the kerf from the jet's middle.
Point cut_at(const path::Point& point, double depth_mm) {
    const auto& axis = std::get<path::ToolAxis>(*point.orientation).direction;
    const double down = (point.position_mm[2] + depth_mm) / axis[2];
    const Point middle{point.position_mm[0] - down * axis[0], point.position_mm[1] - down * axis[1]};
    const Point to_waste = geometry::unit({axis[0], axis[1]});
    const double tilt_rad = std::atan2(std::hypot(axis[0], axis[1]), axis[2]);
    return middle - 0.4 / std::cos(tilt_rad) * to_waste;
}

// A box has a bevel of its own on each side, and a conical hole.
TEST(Autopath, CutsDifferentBevelPerEdge) {
    constexpr double kDepth = 10;
    drawing::Drawing drawing;
    const Contour rectangle = geometry::rectangle({0, 0}, {60, 40});
    const std::vector<double> bevels{5, 20, 12, 33};
    for (std::size_t i = 0; i < 4; ++i) {
        Contour side;
        append_edge(side, rectangle.edge(i), static_cast<std::uint32_t>(i));
        drawing.drawn_contours.push_back(side);
        drawing.entities.push_back({"side", std::to_string(i), 0, bevels[i]});
    }
    drawing.drawn_contours.push_back(geometry::circle({30, 20}, 8));
    for (geometry::Vertex& vertex : drawing.drawn_contours.back().vertices) vertex.source = 4;
    drawing.entities.push_back({"hole", "", 0, 25});
    const auto autopath_result = autopath(drawing, rules(), {});
    ASSERT_TRUE(autopath_result) << autopath_result.error().message;
    EXPECT_FALSE(path::validate(autopath_result->program));
    const double round = 8 + kDepth * std::tan(25 * std::numbers::pi / 180);
    const auto at = [&](std::size_t side) {
        return kDepth * std::tan(bevels[side] * std::numbers::pi / 180);
    };
    std::size_t straight = 0;
    std::size_t curved = 0;
    for (const path::Path& path : autopath_result->program.paths) {
        for (const path::Target& target : path.targets) {
            const auto* point = std::get_if<path::Point>(&target);
            if (point == nullptr || !point->orientation || !point->feed_mm_min) continue;
            const Point upper = cut_at(*point, 0);
            const Point lower = cut_at(*point, kDepth);
            if (std::abs(distance(upper, {30, 20}) - 8) < 1e-6) {
                EXPECT_NEAR(distance(lower, {30, 20}), round, 1e-6);
                ++curved;
            }
            // The part's corners on the upper side have those of the lower side below them.
            const bool on_x_side = upper.x > 1 && upper.x < 59;
            if (on_x_side && std::abs(upper.y) < 1e-6) {
                EXPECT_NEAR(lower.y, at(0), 1e-6);
                ++straight;
            }
            if (on_x_side && std::abs(upper.y - 40) < 1e-6) {
                EXPECT_NEAR(lower.y, 40 - at(2), 1e-6);
                ++straight;
            }
        }
    }
    EXPECT_GE(straight, 1U);
    EXPECT_GE(curved, 2U);
}

// If the TCP would stand still over the middle of a hole, the tool turns there.
TEST(Autopath, TcpOverHoleCentreGivesValidProgram) {
    AutopathOptions options;
    options.program.bevel_deg = 45;
    options.program.heights.cut_mm = 10 - 0.4 / std::cos(std::numbers::pi / 4);
    const Autopath result = path_of({geometry::circle({50, 50}, 10)}, options);
    EXPECT_FALSE(path::validate(result.program));
}

TEST(Autopath, OriginShiftsPathAndToolStaysVertical) {
    const Autopath current = path_of({geometry::rectangle({0, 0}, {40, 30})}, {});
    AutopathOptions options;
    options.program.origin_mm = {100, 200, 50};
    const Autopath there = path_of({geometry::rectangle({0, 0}, {40, 30})}, options);
    const auto& targets = current.program.paths[1].targets;
    ASSERT_EQ(there.program.paths[1].targets.size(), targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto& from = std::get<path::Point>(targets[i]).position_mm;
        const auto& to = std::get<path::Point>(there.program.paths[1].targets[i]).position_mm;
        EXPECT_NEAR(to[0] - from[0], 100, 1e-9);
        EXPECT_NEAR(to[1] - from[1], 200, 1e-9);
        EXPECT_NEAR(to[2] - from[2], 50, 1e-9);
    }
    const path::Orientation upright = path::ToolAxis{{0, 0, 1}};
    EXPECT_EQ(std::get<path::Point>(targets.front()).orientation, upright);
}

TEST(Autopath, HoleTooSmallForPierceHasNoLead) {
    const Autopath result =
        path_of({geometry::rectangle({0, 0}, {40, 30}), geometry::circle({20, 15}, 0.42)});
    EXPECT_EQ(result.summary.without_leads, 1U);
    EXPECT_EQ(result.notes.size(), 1U);
}

}  // namespace

}  // namespace gsim::cutting::autopath_test
