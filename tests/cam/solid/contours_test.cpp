#include "cam/solid/contours.h"

#include <Interface_Static.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cam/solid/solids.h"
#include "tests/cam/solid/step_edges.h"

namespace gsim::solid::contours_test {

namespace {

using testing::HasSubstr;

class Contours : public testing::Test {
  protected:
    // A plate with two holes and a blind one, its upper side at z = 0.
    Contours() {
        const TopoDS_Shape plate = without(
            box({0, 0, -10}, {80, 50, 0}),
            {cylinder({20, 25, -11}, 8, 12), cylinder({60, 25, -11}, 5, 12), cylinder({40, 25, -4}, 3, 5)});
        file_ = folder_.step("plate.step", plate);
    }

    WallContours read(const ContourOptions& options) const {
        auto read = read_contours(file_, options);
        EXPECT_TRUE(read) << read.error().message;
        return read.value_or(WallContours{});
    }
    std::string rejection(const ContourOptions& options) const {
        const auto read = read_contours(file_, options);
        return read ? "" : read.error().message;
    }
    // Returns the edge that runs round a hole, on the upper side.
    std::string edge_at(double x_mm) const {
        for (const WallContour& contour : read({.kind = "holes"}).contours) {
            const Vec3& at = contour.edges.front().points.front().position_mm;
            if (std::abs(at[0] - x_mm) < 10) return contour.edges.front().label;
        }
        ADD_FAILURE() << "there is no hole at " << x_mm;
        return {};
    }

    SolidFolder folder_;
    std::filesystem::path file_;
};

TEST_F(Contours, EdgeNumberSelectsItsContour) {
    const std::string edge = edge_at(60);
    for (const std::string& number : {edge, edge.substr(1)}) {
        const WallContours one = read({.kind = "holes", .edges = {number}});
        ASSERT_EQ(one.contours.size(), 1U);
        EXPECT_EQ(one.contours.front().edges.front().label, edge);
        for (const WallPoint& point : one.contours.front().edges.front().points)
            EXPECT_NEAR(std::hypot(point.position_mm[0] - 60, point.position_mm[1] - 25), 5, 1e-6);
        // The other features of the part are not reported, because they were not requested.
        EXPECT_TRUE(one.notes.empty());
    }
    EXPECT_EQ(read({.kind = "holes", .edges = {edge, edge.substr(1)}}).contours.size(), 1U);
    EXPECT_EQ(read({.kind = "holes", .edges = {edge, edge_at(20)}}).contours.size(), 2U);
    EXPECT_EQ(read({.kind = "holes"}).contours.size(), 2U);
}

TEST_F(Contours, SeveralEdgesSelectContourOnce) {
    const WallContours outline = read({.kind = "outlines"});
    ASSERT_EQ(outline.contours.size(), 1U);
    ContourOptions options{.kind = "all"};
    for (const WallEdge& edge : outline.contours.front().edges) options.edges.push_back(edge.label);
    const WallContours one = read(options);
    ASSERT_EQ(one.contours.size(), 1U);
    EXPECT_EQ(one.contours.front().edges.size(), 4U);
}

TEST_F(Contours, ErrorNamesEdgeWithoutSelectedContour) {
    EXPECT_THAT(rejection({.edges = {"#99999"}}), HasSubstr("it has no edge with the number '#99999'"));
    EXPECT_THAT(rejection({.edges = {""}}), HasSubstr("it has no edge with the number ''"));
    const std::string hole = edge_at(60);
    EXPECT_EQ(rejection({.kind = "outlines", .edges = {hole}}),
              file_.string() + ": edge " + hole + " does not belong to a selected contour");
    EXPECT_THAT(rejection({.edges = {hole}, .side = "-z"}),
                HasSubstr("edge " + hole + " does not belong to a selected contour"));
    const std::string below = read({.side = "-z"}).contours.front().edges.front().label;
    EXPECT_THAT(rejection({.edges = {hole, below}}),
                HasSubstr("edge " + below +
                          " does not belong to a selected contour: it belongs to one that does not face z"));
}

TEST_F(Contours, ReportsReasonForEdgeOfBlindHole) {
    // The blind hole's contour is reported if all are cut, with no number of an edge.
    const WallContours all = read({.kind = "holes"});
    ASSERT_EQ(all.notes.size(), 2U);
    EXPECT_THAT(all.notes.front(), HasSubstr("is not a through cut: below edge #"));
    const std::size_t begin = all.notes.front().find("edge #") + 5;
    const std::string blind = all.notes.front().substr(begin, all.notes.front().find(' ', begin) - begin);
    EXPECT_THAT(
        rejection({.kind = "holes", .edges = {blind}}),
        HasSubstr("edge " + blind + " does not belong to a selected contour: a hole of the plane face #"));
}

TEST_F(Contours, ChainsEdgesWithMaterialOnLeft) {
    const std::string front = edge_between(file_, {0, 0, 0}, {80, 0, 0});
    const std::string right = edge_between(file_, {80, 0, 0}, {80, 50, 0});
    const std::string left = edge_between(file_, {0, 0, 0}, {0, 50, 0});
    // In whatever order they are asked for.
    const WallContours two = read({.kind = "edges", .edges = {right, front}});
    ASSERT_EQ(two.contours.size(), 1U);
    const WallContour& chain = two.contours.front();
    EXPECT_TRUE(chain.is_open);
    EXPECT_FALSE(chain.is_hole);
    ASSERT_EQ(chain.edges.size(), 2U);
    EXPECT_EQ(chain.edges[0].label, front);
    EXPECT_EQ(chain.edges[1].label, right);
    // Seen from above, the plate is to the left of a path towards +X along its front.
    EXPECT_EQ(chain.edges[0].points.front().position_mm, (Vec3{0, 0, 0}));
    EXPECT_EQ(chain.edges[1].points.back().position_mm, (Vec3{80, 50, 0}));
    EXPECT_NEAR(chain.edges[0].points.front().tangent[0], 1, 1e-9);
    for (const WallEdge& edge : chain.edges) {
        for (const WallPoint& point : edge.points) EXPECT_NEAR(point.depth_mm, 10, 1e-6);
    }
    // Edges that share no ends are separate chains.
    const WallContours apart = read({.kind = "edges", .edges = {right, left}});
    ASSERT_EQ(apart.contours.size(), 2U);
    for (const WallContour& each : apart.contours) EXPECT_TRUE(each.is_open);
}

TEST_F(Contours, ClosedChainsAreOutlinesOrHoles) {
    ContourOptions around{.kind = "edges"};
    const WallContours walls = read({.kind = "outlines"});
    for (const WallEdge& edge : walls.contours.front().edges) around.edges.push_back(edge.label);
    const WallContours outline = read(around);
    ASSERT_EQ(outline.contours.size(), 1U);
    EXPECT_FALSE(outline.contours.front().is_open);
    EXPECT_FALSE(outline.contours.front().is_hole);
    EXPECT_EQ(outline.contours.front().edges.size(), 4U);
    const WallContours hole = read({.kind = "edges", .edges = {edge_at(60)}});
    ASSERT_EQ(hole.contours.size(), 1U);
    EXPECT_FALSE(hole.contours.front().is_open);
    EXPECT_TRUE(hole.contours.front().is_hole);
    EXPECT_THAT(rejection({.kind = "edges", .edges = {"#99999"}}),
                HasSubstr("it has no edge with the number '#99999'"));
}

TEST_F(Contours, ChainsListOtherEdgesAsObstacles) {
    const WallContours front = read({.kind = "edges", .edges = {edge_between(file_, {0, 0, 0}, {80, 0, 0})}});
    const auto has = [&](const Position& a, const Position& b) {
        const std::string name = "edge " + edge_between(file_, a, b);
        return std::any_of(front.other_edges.begin(), front.other_edges.end(),
                           [&](const PartEdge& edge) { return edge.name == name; });
    };
    EXPECT_FALSE(has({0, 0, 0}, {80, 0, 0}));      // it is cut
    EXPECT_FALSE(has({0, 0, -10}, {80, 0, -10}));  // the other end of its wall
    EXPECT_FALSE(has({80, 0, 0}, {80, 0, -10}));   // and its side
    EXPECT_TRUE(has({80, 0, 0}, {80, 50, 0}));     // next to it
    EXPECT_TRUE(has({80, 0, -10}, {80, 50, -10}));
    EXPECT_TRUE(read({.kind = "all"}).other_edges.empty());
}

// Such a file does not distinguish them.
TEST_F(Contours, IgesEdgesHaveNoNumbers) {
    const auto file =
        folder_.iges("plate.iges", without(box({0, 0, -10}, {80, 50, 0}), {cylinder({20, 25, -11}, 8, 12)}));
    const auto all = read_contours(file, {.kind = "all"});
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->contours.size(), 2U);
    for (const WallContour& contour : all->contours) {
        for (const WallEdge& edge : contour.edges) EXPECT_EQ(edge.label, "");
    }
    const auto requested = read_contours(file, {.kind = "all", .edges = {"57"}});
    ASSERT_FALSE(requested);
    EXPECT_THAT(requested.error().message, HasSubstr("it has no edge with the number '57'"));
}

TEST_F(Contours, AssemblyInstancesShareEdgeNumbers) {
    const TopoDS_Shape plate = without(box({0, 0, -10}, {80, 50, 0}), {cylinder({20, 25, -11}, 8, 12)});
    gp_Trsf lateral;
    lateral.SetTranslation(gp_Vec(200, 0, 0));
    const int before = Interface_Static::IVal("write.step.assembly");
    Interface_Static::SetIVal("write.step.assembly", 1);
    const auto file = folder_.step("plates.step", together({plate, plate.Moved(TopLoc_Location(lateral))}));
    Interface_Static::SetIVal("write.step.assembly", before);
    ASSERT_THAT(read_file(file), HasSubstr("NEXT_ASSEMBLY_USAGE_OCCURRENCE"));
    const auto both = read_contours(file, {.kind = "holes"});
    ASSERT_TRUE(both) << both.error().message;
    ASSERT_EQ(both->contours.size(), 2U);
    const std::string edge = both->contours[0].edges.front().label;
    EXPECT_NE(edge, "");
    EXPECT_EQ(both->contours[1].edges.front().label, edge);
    // The box distinguishes them.
    const auto one = read_contours(
        file, {.kind = "holes", .edges = {edge}, .box_mm = std::array<double, 6>{100, 0, -10, 300, 50, 0}});
    ASSERT_TRUE(one) << one.error().message;
    ASSERT_EQ(one->contours.size(), 1U);
    EXPECT_GT(one->contours.front().edges.front().points.front().position_mm[0], 200);
}

}  // namespace

}  // namespace gsim::solid::contours_test
