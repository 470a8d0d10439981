#include "cam/solid/contours.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/solid/solids.h"

namespace gsim::solid::contours_test {

namespace {

using testing::HasSubstr;

// "#12" of "edge #12 of the plane face #40"
std::string number_of(const WallEdge& edge) {
    const std::size_t begin = edge.name.find('#');
    return edge.name.substr(begin, edge.name.find(' ', begin) - begin);
}

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
        EXPECT_TRUE(read) << read.error();
        return read.value_or(WallContours{});
    }
    std::string refusal(const ContourOptions& options) const {
        const auto read = read_contours(file_, options);
        return read ? "" : read.error();
    }
    // The edge that goes round a hole, on the upper side.
    std::string edge_at(double x_mm) const {
        for (const WallContour& contour : read({.kind = "holes"}).contours) {
            const Triple& at = contour.edges.front().points.front().position_mm;
            if (std::abs(at[0] - x_mm) < 10) return number_of(contour.edges.front());
        }
        ADD_FAILURE() << "there is no hole at " << x_mm;
        return {};
    }

    SolidFolder folder_;
    std::filesystem::path file_;
};

TEST_F(Contours, AnEdgeChoosesTheContourThatHasIt) {
    const std::string edge = edge_at(60);
    for (const std::string& number : {edge, edge.substr(1)}) {
        const WallContours one = read({.kind = "holes", .edges = {number}});
        ASSERT_EQ(one.contours.size(), 1U);
        EXPECT_EQ(number_of(one.contours.front().edges.front()), edge);
        for (const WallPoint& point : one.contours.front().edges.front().points)
            EXPECT_NEAR(std::hypot(point.position_mm[0] - 60, point.position_mm[1] - 25), 5, 1e-6);
        // What else the part has is not told of: nobody asked for it.
        EXPECT_TRUE(one.notes.empty());
    }
    EXPECT_EQ(read({.kind = "holes", .edges = {edge, edge.substr(1)}}).contours.size(), 1U);
    EXPECT_EQ(read({.kind = "holes", .edges = {edge, edge_at(20)}}).contours.size(), 2U);
    EXPECT_EQ(read({.kind = "holes"}).contours.size(), 2U);
}

TEST_F(Contours, ManyEdgesOfOneContourChooseItOnce) {
    const WallContours outline = read({.kind = "outlines"});
    ASSERT_EQ(outline.contours.size(), 1U);
    ContourOptions options{.kind = "all"};
    for (const WallEdge& edge : outline.contours.front().edges) options.edges.push_back(number_of(edge));
    const WallContours one = read(options);
    ASSERT_EQ(one.contours.size(), 1U);
    EXPECT_EQ(one.contours.front().edges.size(), 4U);
}

TEST_F(Contours, AnEdgeThatChoosesNothingIsRefusedByItsNumber) {
    EXPECT_THAT(refusal({.edges = {"#99999"}}), HasSubstr("it has no edge with the number '#99999'"));
    EXPECT_THAT(refusal({.edges = {""}}), HasSubstr("it has no edge with the number ''"));
    const std::string hole = edge_at(60);
    EXPECT_EQ(refusal({.kind = "outlines", .edges = {hole}}),
              file_.string() + ": edge " + hole + " is of no contour that is chosen");
    EXPECT_THAT(refusal({.edges = {hole}, .side = "-z"}),
                HasSubstr("edge " + hole + " is of no contour that is chosen"));
    const std::string below = number_of(read({.side = "-z"}).contours.front().edges.front());
    EXPECT_THAT(
        refusal({.edges = {hole, below}}),
        HasSubstr("edge " + below +
                  " is of no contour that is chosen: it is of one that looks to another side than z"));
}

TEST_F(Contours, AnEdgeOfWhatIsNoContourSaysWhy) {
    // The blind hole's contour is told of where all are cut, with no number of an edge.
    const WallContours all = read({.kind = "holes"});
    ASSERT_EQ(all.notes.size(), 2U);
    EXPECT_THAT(all.notes.front(), HasSubstr("does not go through: below edge #"));
    const std::size_t begin = all.notes.front().find("edge #") + 5;
    const std::string blind = all.notes.front().substr(begin, all.notes.front().find(' ', begin) - begin);
    EXPECT_THAT(refusal({.kind = "holes", .edges = {blind}}),
                HasSubstr("edge " + blind + " is of no contour that is chosen: a hole of the plane face #"));
}

}  // namespace

}  // namespace gsim::solid::contours_test
