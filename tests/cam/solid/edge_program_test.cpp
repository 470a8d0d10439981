// Edges by their numbers: closed contours that have one, and chains of them.

#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "tests/cam/solid/part_models.h"
#include "tests/cam/solid/solids.h"
#include "tests/cam/solid/step_edges.h"
#include "tests/cam/solid/surface_program.h"

namespace gsim::apps::edge_program_test {

namespace {

using namespace solid::models;
using Eigen::Vector3d;
using solid::edge_between;

class EdgeProgram : public SurfaceProgram {
  protected:
    // Returns the options --contours edges --edge ... of edges between consecutive positions.
    static std::vector<std::string> edges(const std::string& step,
                                          const std::vector<solid::Position>& places) {
        std::vector<std::string> options{"--contours", "edges"};
        for (std::size_t i = 1; i < places.size(); ++i) {
            const std::string edge = edge_between(step, places[i - 1], places[i]);
            EXPECT_NE(edge, "") << i;
            options.insert(options.end(), {"--edge", edge});
        }
        return options;
    }
    static std::vector<std::string> cut(std::vector<std::string> options) {
        options.insert(options.end(), {"--speed", "400", "--cut-height", "1"});
        return options;
    }
    std::string step(const std::string& name, const TopoDS_Shape& shape) const {
        return solids_.step(name, shape).string();
    }
    // Returns the distance of the jet's middle from a position.
    static double distance_mm(const Vector3d& position, const std::vector<Jet>& jets) {
        return deviation({position}, jets, 0).min_mm;
    }

    const solid::SolidFolder solids_;
};

// Returns points at a depth along stretches of a plate's outline, from end to end of what is left of them.
Points on_stretches(const std::vector<Vector3d>& corners, double depth_mm) {
    Points points;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        for (int n = 0; n <= 100; ++n) {
            const Vector3d at = corners[i - 1] + n / 100.0 * (corners[i] - corners[i - 1]);
            points.emplace_back(at.x(), at.y(), at.z() - depth_mm);
        }
    }
    return points;
}

TEST_F(EdgeProgram, EdgeNumberSelectsItsContour) {
    const std::string bracket = sample("parts/bracket.step");
    // The error names an edge of the hole that is narrower than this kerf.
    const Ended narrow = autopath(bracket, {"--contours", "holes", "--box-low", "-45", "0", "0"}, "19");
    const std::size_t begin = narrow.err.find("edge #") + 5;
    const std::string edge = narrow.err.substr(begin, narrow.err.find(' ', begin) - begin);
    const Ended one = autopath(bracket, {"--contours", "holes", "--edge", edge});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_TRUE(contains(one.err, "1 contours, 1 pierces")) << one.err;
    const Ended none = autopath(bracket, {"--contours", "holes", "--edge", "7"});
    EXPECT_TRUE(contains(none.err, "bracket.step: it has no edge with the number '7'")) << none.err;
    EXPECT_TRUE(contains(autopath(bracket, {"--edge", edge}).err, "--edge requires --contours"));
}

TEST_F(EdgeProgram, CutsOnlySelectedSidesOfPlate) {
    const std::string plate = step("plate.step", solid::box({0, 0, -10}, {80, 50, 0}));
    const auto jet_path =
        jets(plate, {600, 600, 120}, cut(edges(plate, {{0, 0, 0}, {80, 0, 0}, {80, 50, 0}, {0, 50, 0}})));
    EXPECT_TRUE(contains(told_, "1 contours, 1 pierces, ")) << told_;
    EXPECT_FALSE(contains(told_, "no room for lead-ins")) << told_;
    for (const double depth : {0.0, 5.0, 10.0})
        expect_cut(fmt::format("three sides at {} mm", depth),
                   on_stretches({{0, 0, 0}, {80, 0, 0}, {80, 50, 0}, {0, 50, 0}}, depth), jet_path);
    EXPECT_GT(distance_mm({0, 25, 0}, jet_path), 20);
    // The path continues three kerfs straight beyond both ends, half of the kerf off the plate.
    const double lead_mm = 3 * kKerf_mm;
    for (const double y : {-kKerf_mm / 2, 50 + kKerf_mm / 2}) {
        EXPECT_LT(distance_mm({-lead_mm, y, 0}, jet_path), 0.01);
        EXPECT_NEAR(distance_mm({-lead_mm - 1, y, 0}, jet_path), 1, 0.01);
    }
}

TEST_F(EdgeProgram, TrimsInnerCornerOfChain) {
    const std::string angle = step("angle.step", solid::without(solid::box({0, 0, -6}, {60, 60, 0}),
                                                                {solid::box({30, 30, -7}, {61, 61, 1})}));
    const auto jet_path =
        jets(angle, {600, 600, 120}, cut(edges(angle, {{60, 30, 0}, {30, 30, 0}, {30, 60, 0}})));
    const double room = kKerf_mm / 2;
    for (const double depth : {0.0, 3.0, 6.0}) {
        // The corner that the jet's radius leaves is not an edge.
        expect_cut(fmt::format("one leg at {} mm", depth),
                   on_stretches({{60, 30, 0}, {30 + room, 30, 0}}, depth), jet_path);
        expect_cut(fmt::format("the other at {} mm", depth),
                   on_stretches({{30, 30 + room, 0}, {30, 60, 0}}, depth), jet_path);
        EXPECT_NEAR(distance_mm({30, 30, -depth}, jet_path), std::sqrt(2) * room, 0.01);
    }
}

TEST_F(EdgeProgram, CutsTiltedWallsAndTheirCorner) {
    // Larger below by 5 mm on each side over 10 mm: the walls lean by 26.6 degrees.
    const std::string block = step("block.step", solid::frustum({0, 0, -10}, 90, 70, 80, 60, 10));
    const auto jet_path =
        jets(block, {600, 600, 120}, cut(edges(block, {{-40, -30, 0}, {40, -30, 0}, {40, 30, 0}})));
    for (const double depth : {0.0, 5.0, 10.0}) {
        const double x = 40 + depth / 2;
        const double y = 30 + depth / 2;
        expect_cut(fmt::format("leaning walls at {} mm", depth),
                   on_stretches({{-x, -y, 0}, {x, -y, 0}, {x, y, 0}}, depth), jet_path);
    }
}

TEST_F(EdgeProgram, CutsFrontEdgeAroundBendOfBracket) {
    using B = Bracket;
    const double bend = B::kBend_deg * kRadPerDeg;
    const double inner = B::kOuterRadius_mm - B::kThickness_mm;
    // Returns a position from the bend's axis, by an angle from straight down, and along the flange from
    // there.
    const auto at = [&](double radius, double angle, double mm) -> Vector3d {
        return {radius * std::sin(angle) + mm * std::cos(angle), 0,
                B::kOuterRadius_mm - radius * std::cos(angle) + mm * std::sin(angle)};
    };
    const auto position = [&](double angle, double mm) -> solid::Position {
        const Vector3d point = at(inner, angle, mm);
        return {point.x(), point.y(), point.z()};
    };
    constexpr double kLevel_mm = 80, kRising_mm = 75;
    // The test includes a part with splines for all surfaces and curves, as some programs write them.
    for (const std::string& part :
         {sample("parts/bracket.step"), step("splines.step", solid::as_splines(bracket()))}) {
        const auto jet_path = jets(part, {600, 600, 120},
                                   cut(edges(part, {position(0, -kLevel_mm), position(0, 0),
                                                    position(bend, 0), position(bend, kRising_mm)})));
        EXPECT_TRUE(contains(told_, "1 contours, 1 pierces, ")) << told_;
        for (const double depth : {0.0, B::kThickness_mm / 2, B::kThickness_mm}) {
            const double radius = inner + depth;
            const std::string where = fmt::format(" at {} mm", depth);
            expect_cut("the level edge" + where,
                       along([&](double share) { return at(radius, 0, (share - 1) * kLevel_mm); }), jet_path);
            expect_cut("the bend's edge" + where,
                       along([&](double share) { return at(radius, share * bend, 0); }), jet_path);
            expect_cut("the rising edge" + where,
                       along([&](double share) { return at(radius, bend, share * kRising_mm); }), jet_path);
        }
    }
}

TEST_F(EdgeProgram, KeepsBridgesAwayFromChainEnds) {
    const std::string plate = step("plate.step", solid::box({0, 0, -10}, {80, 50, 0}));
    auto options = cut(edges(plate, {{0, 0, 0}, {80, 0, 0}}));
    options.insert(options.end(), {"--bridges", "2", "--bridge-width", "4"});
    const auto jet_path = jets(plate, {600, 600, 120}, options);
    EXPECT_TRUE(contains(told_, "1 contours, 3 pierces, ")) << told_;
    for (const auto& [from, to] : {std::pair(0.0, 17.6), std::pair(22.4, 57.6), std::pair(62.4, 80.0)})
        expect_cut(fmt::format("from {} to {} mm", from, to), on_stretches({{from, 0, 0}, {to, 0, 0}}, 0),
                   jet_path);
    for (const double middle : {20.0, 60.0})
        EXPECT_NEAR(distance_mm({middle, -kKerf_mm / 2, 0}, jet_path), 2 + kKerf_mm / 2, 0.02);
}

TEST_F(EdgeProgram, ChainWithoutRoomAtEndsHasNoLeads) {
    using B = Bracket;
    // Half of the slot: straight on beyond its ends is the other half.
    const std::string bracket = sample("parts/bracket.step");
    const double low = B::kSlotY_mm - B::kSlotHalf_mm;
    const double high = B::kSlotY_mm + B::kSlotHalf_mm;
    const double z = B::kThickness_mm;
    const auto jet_path = jets(bracket, {600, 600, 120},
                               cut(edges(bracket, {{B::kSlotX_mm + B::kSlotRadius_mm, low, z},
                                                   {B::kSlotX_mm + B::kSlotRadius_mm, high, z},
                                                   {B::kSlotX_mm - B::kSlotRadius_mm, high, z},
                                                   {B::kSlotX_mm - B::kSlotRadius_mm, low, z}})));
    EXPECT_TRUE(contains(told_, "1 contours have no room for lead-ins")) << told_;
    expect_cut("half of the slot", along([&](double share) {
                   const double turn = share * kTurn_rad / 2;
                   return Vector3d(B::kSlotX_mm + B::kSlotRadius_mm * std::cos(turn),
                                   high + B::kSlotRadius_mm * std::sin(turn), z);
               }),
               jet_path);
}

TEST_F(EdgeProgram, RejectsUncuttableEdgeWithPosition) {
    const std::string plate = step("plate.step", solid::box({0, 0, -10}, {80, 50, 0}));
    const auto rejection = [&](const std::string& part, const std::vector<solid::Position>& places,
                               const std::vector<std::string>& more = {}) {
        std::vector<std::string> options = edges(part, places);
        options.insert(options.end(), more.begin(), more.end());
        const Ended ended = autopath(part, options);
        EXPECT_NE(ended.status, 0);
        EXPECT_FALSE(exists("part.path.json"));
        return ended.err;
    };
    EXPECT_TRUE(contains(autopath(plate, {"--contours", "edges"}).err,
                         "--contours edges requires the numbers of edges (--edge)"));
    const std::string upright = rejection(plate, {{0, 0, 0}, {0, 0, -10}});
    EXPECT_TRUE(contains(
        upright,
        " at (0, 0, -5) cannot be entered from z: no adjacent face faces this side: the plane face #"))
        << upright;
    const std::string below = rejection(plate, {{0, 0, -10}, {80, 0, -10}});
    EXPECT_TRUE(
        contains(below, " at (40, 0, -10) cannot be entered from z: no adjacent face faces this side"))
        << below;
    const std::string unboxed = rejection(plate, {{0, 0, 0}, {80, 0, 0}}, {"--box-high", "70", "50", "0"});
    EXPECT_TRUE(contains(unboxed, " at (40, 0, 0) is not in the box")) << unboxed;
    using B = Bracket;
    const std::string smooth = rejection(sample("parts/bracket.step"),
                                         {{0, 0, B::kThickness_mm}, {0, B::kWidth_mm, B::kThickness_mm}});
    EXPECT_TRUE(contains(smooth, "it continues smoothly into the ")) << smooth;
    const std::string step_part = step("step.step", solid::without(solid::box({0, 0, -10}, {80, 50, 0}),
                                                                   {solid::box({40, -1, -4}, {81, 51, 1})}));
    const std::string foot = rejection(step_part, {{40, 0, -4}, {40, 50, -4}});
    EXPECT_TRUE(contains(foot, "it is at the foot of the plane face #")) << foot;
}

TEST_F(EdgeProgram, RejectsChainEndingInInnerCorner) {
    const std::string angle = step("angle.step", solid::without(solid::box({0, 0, -6}, {60, 60, 0}),
                                                                {solid::box({30, 30, -7}, {61, 61, 1})}));
    const Ended into = autopath(angle, edges(angle, {{60, 30, 0}, {30, 30, 0}}));
    EXPECT_EQ(into.status, 1);
    EXPECT_TRUE(contains(into.err, "cannot be cut: at (30, 30, 0) the jet would cut 0.4 mm into edge #"))
        << into.err;
}

TEST_F(EdgeProgram, RejectsBranchingChain) {
    // A block on its corner, turned so that one of its faces points up most.
    const TopoDS_Shape block = solid::turned(
        solid::turned(solid::box({0, 0, 0}, {30, 30, 30}), {0, 0, 1}, 0.7), {1, 0, 0}, 0.5, {0, 0, 0});
    const auto at = [](double x, double y, double z) -> solid::Position {
        const double along = x * std::cos(0.7) - y * std::sin(0.7);
        const double across = x * std::sin(0.7) + y * std::cos(0.7);
        return {along, across * std::cos(0.5) - z * std::sin(0.5),
                across * std::sin(0.5) + z * std::cos(0.5)};
    };
    const std::string part = step("block.step", block);
    // The highest corner, and the three that are next to it.
    std::vector<std::string> options{"--contours", "edges"};
    for (const solid::Position& next : {at(0, 30, 30), at(30, 0, 30), at(30, 30, 0)})
        options.insert(options.end(), {"--edge", edge_between(part, at(30, 30, 30), next)});
    const Ended ended = autopath(part, options);
    EXPECT_TRUE(contains(ended.err, "a chain of edges must not branch: at (")) << ended.err;
}

}  // namespace
}  // namespace gsim::apps::edge_program_test
