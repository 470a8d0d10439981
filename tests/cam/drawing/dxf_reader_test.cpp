#include "cam/drawing/dxf_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::dxf_reader_test {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

std::string circle(const std::string& x, const std::string& y, const std::string& r) {
    return groups({{0, "CIRCLE"}, {5, "C1"}, {8, "0"}, {10, x}, {20, y}, {40, r}});
}

TEST(Dxf, ReadsCircleExactly) {
    const Drawing drawing = dxf_drawing(dxf_of(circle("5", "-3", "7")));
    ASSERT_THAT(areas_of(drawing), ElementsAre(DoubleNear(49 * kPi, 1e-9)));
    EXPECT_EQ(drawing.entities[0].kind, "CIRCLE");
    EXPECT_EQ(drawing.entities[0].name, "C1");
}

TEST(Dxf, LinesAndArcFormClosedContour) {
    const std::string text =
        dxf_of(groups({{0, "LINE"}, {10, "0"}, {20, "0"}, {11, "10"}, {21, "0"}}) +
               groups({{0, "ARC"}, {10, "10"}, {20, "2"}, {40, "2"}, {50, "270"}, {51, "90"}}) +
               groups({{0, "LINE"}, {10, "0"}, {20, "4"}, {11, "10"}, {21, "4"}}) +
               groups({{0, "LINE"}, {10, "0"}, {20, "4"}, {11, "0"}, {21, "0"}}));
    EXPECT_THAT(areas_of(dxf_drawing(text)), ElementsAre(DoubleNear(40 + 2 * kPi, 1e-6)));
}

TEST(Dxf, ReadsBulgesOfBothPolylineTypes) {
    // A slot of length 10 between half circles of radius 2.
    const std::string light = groups({{0, "LWPOLYLINE"},
                                      {90, "4"},
                                      {70, "1"},
                                      {10, "0"},
                                      {20, "-2"},
                                      {10, "10"},
                                      {20, "-2"},
                                      {42, "1"},
                                      {10, "10"},
                                      {20, "2"},
                                      {10, "0"},
                                      {20, "2"},
                                      {42, "1"}});
    const std::string heavy = groups({{0, "POLYLINE"},
                                      {66, "1"},
                                      {70, "1"},
                                      {0, "VERTEX"},
                                      {10, "0"},
                                      {20, "-2"},
                                      {0, "VERTEX"},
                                      {10, "10"},
                                      {20, "-2"},
                                      {42, "1"},
                                      {0, "VERTEX"},
                                      {10, "10"},
                                      {20, "2"},
                                      {0, "VERTEX"},
                                      {10, "0"},
                                      {20, "2"},
                                      {42, "1"},
                                      {0, "SEQEND"}});
    for (const std::string& entity : {light, heavy}) {
        EXPECT_THAT(areas_of(dxf_drawing(dxf_of(entity))), ElementsAre(DoubleNear(40 + 4 * kPi, 1e-9)));
    }
}

TEST(Dxf, ApproximatesEllipseAndSplineWithinTolerance) {
    const std::string ellipse = groups({{0, "ELLIPSE"},
                                        {10, "1"},
                                        {20, "2"},
                                        {11, "30"},
                                        {21, "40"},
                                        {40, "0.5"},
                                        {41, "0"},
                                        {42, "6.283185307179586"}});
    EXPECT_THAT(areas_of(dxf_drawing(dxf_of(ellipse))), ElementsAre(DoubleNear(kPi * 50 * 25, 1)));
    // A circle of radius 1 as a rational spline (Piegl and Tiller, 7.5).
    std::string spline = groups({{0, "SPLINE"}, {70, "12"}, {71, "2"}});
    for (const char* knot : {"0", "0", "0", "1", "1", "2", "2", "3", "3", "4", "4", "4"}) {
        spline += groups({{40, knot}});
    }
    const std::vector<std::pair<std::string, std::string>> corners = {{"1", "0"},  {"1", "1"},  {"0", "1"},
                                                                      {"-1", "1"}, {"-1", "0"}, {"-1", "-1"},
                                                                      {"0", "-1"}, {"1", "-1"}, {"1", "0"}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        spline += groups({{41, i % 2 == 0 ? "1" : "0.70710678118654752"}});
        spline += groups({{10, corners[i].first}, {20, corners[i].second}});
    }
    EXPECT_THAT(areas_of(dxf_drawing(dxf_of(spline))), ElementsAre(DoubleNear(kPi, 1e-6)));
}

std::string fitted(const std::string& flags, const std::vector<geometry::Point>& points,
                   const std::string& ends = {}) {
    std::string spline = groups({{0, "SPLINE"}, {5, "2A"}, {70, flags}, {71, "3"}, {74, "9"}}) + ends;
    for (const geometry::Point& point : points) {
        spline +=
            groups({{11, fmt::format("{:.9f}", point.x)}, {21, fmt::format("{:.9f}", point.y)}, {31, "0"}});
    }
    return dxf_of(spline);
}

// A smooth curve through points of a circle is nearly that circle.
TEST(Dxf, InterpolatesSplineThroughFitPoints) {
    std::vector<geometry::Point> points;
    for (int i = 0; i <= 12; ++i) {
        points.push_back({50 + 20 * std::cos(kPi * i / 6), 50 + 20 * std::sin(kPi * i / 6)});
    }
    for (const std::size_t count : {13U, 12U}) {  // the first one again at the end, or not
        points.resize(count);
        const Drawing ring = dxf_drawing(fitted("11", points));
        EXPECT_THAT(areas_of(ring), ElementsAre(DoubleNear(400 * kPi, 0.6)));
        for (const geometry::Vertex& vertex : ring.drawn_contours[0].vertices) {
            EXPECT_NEAR(distance(vertex.position, {50, 50}), 20, 0.02);
        }
    }
    // Half of it with its directions at the ends, which have any length.
    points.resize(7);
    const std::string ends = groups({{12, "0"}, {22, "7"}, {13, "0"}, {23, "-0.1"}});
    const Drawing half = dxf_drawing(fitted("8", points, ends));
    for (const geometry::Vertex& vertex : half.drawn_contours.at(0).vertices) {
        EXPECT_NEAR(distance(vertex.position, {50, 50}), 20, 0.02);
    }
    const Drawing straight = dxf_drawing(fitted("8", {{0, 0}, {0, 0}, {10, 0}, {25, 0}}));
    for (const geometry::Vertex& vertex : straight.drawn_contours.at(0).vertices) {
        EXPECT_NEAR(vertex.position.y, 0, 1e-9);
        EXPECT_NEAR(vertex.bulge, 0, 1e-9);
    }
    EXPECT_THAT(dxf_fault(fitted("8", {{3, 4}, {3, 4}})),
                HasSubstr("SPLINE 2A has 2 fit points, which have no length"));
}

TEST(Dxf, RejectsEmptyAndBinaryFiles) {
    EXPECT_EQ(dxf_fault(""), "line 1: the file ends without EOF: it is truncated, or not a DXF file");
    EXPECT_THAT(dxf_fault(std::string("AutoCAD Binary DXF\r\n\x1a\0\0", 23)),
                HasSubstr("save it as text (ASCII)"));
}

TEST(Dxf, InsertsBlocksScaledRotatedAndRepeated) {
    const std::string blocks = section(
        "BLOCKS", groups({{0, "BLOCK"}, {2, "hole"}, {10, "1"}, {20, "1"}}) + circle("1", "1", "2") +
                      groups({{0, "ENDBLK"}}) + groups({{0, "BLOCK"}, {2, "pair"}, {10, "0"}, {20, "0"}}) +
                      groups({{0, "INSERT"}, {2, "hole"}, {10, "0"}, {20, "0"}, {41, "2"}, {42, "0.5"}}) +
                      groups({{0, "ENDBLK"}}));
    const std::string insert = groups({{0, "INSERT"},
                                       {2, "pair"},
                                       {10, "100"},
                                       {20, "0"},
                                       {41, "-1"},
                                       {42, "1"},
                                       {50, "30"},
                                       {70, "3"},
                                       {71, "2"},
                                       {44, "50"},
                                       {45, "60"}});
    const Drawing drawing = dxf_drawing(dxf_of(insert, blocks));
    const std::vector<double> areas = areas_of(drawing);
    ASSERT_EQ(areas.size(), 6U);
    for (const double area : areas) EXPECT_NEAR(area, kPi * 4, 0.1);
    geometry::Box box;
    for (const geometry::Contour& drawn_contour : drawing.drawn_contours)
        box.add(bounding_box(drawn_contour));
    // The last centre: (100, 60) in the turned frame of the array.
    const double half_width = std::hypot(4 * std::cos(kPi / 6), 1 * std::sin(kPi / 6));
    EXPECT_NEAR(box.high.x, 100 + 100 * std::cos(kPi / 6) + half_width, 0.01);
}

TEST(Dxf, AppliesUnitsLayersAndMirroredPlanes) {
    const std::string header = section("HEADER", groups({{9, "$INSUNITS"}, {70, "1"}}));
    const std::string tables = section("TABLES", groups({{0, "TABLE"},
                                                         {2, "LAYER"},
                                                         {0, "LAYER"},
                                                         {2, "off"},
                                                         {70, "0"},
                                                         {62, "-3"},
                                                         {0, "LAYER"},
                                                         {2, "frozen"},
                                                         {70, "1"},
                                                         {62, "3"},
                                                         {0, "ENDTAB"}}));
    const std::string ground_truth = groups({{0, "CIRCLE"}, {8, "off"}, {10, "0"}, {20, "0"}, {40, "1"}}) +
                                     groups({{0, "CIRCLE"}, {8, "frozen"}, {10, "0"}, {20, "0"}, {40, "1"}});
    const std::string mirrored =
        groups({{0, "CIRCLE"}, {8, "cut"}, {10, "2"}, {20, "0"}, {40, "1"}, {230, "-1"}});
    const Drawing drawing = dxf_drawing(dxf_of(ground_truth + mirrored, header + tables));
    EXPECT_THAT(areas_of(drawing), ElementsAre(DoubleNear(kPi * 25.4 * 25.4, 1e-6)));
    EXPECT_NEAR(bounding_box(drawing.drawn_contours[0]).low.x, -3 * 25.4, 1e-9);
    ReadOptions options;
    options.layers = {"other"};
    EXPECT_TRUE(dxf_drawing(dxf_of(mirrored), options).drawn_contours.empty());
}

TEST(Dxf, ReportsIgnoredEntities) {
    const Drawing drawing = dxf_drawing(
        dxf_of(circle("0", "0", "1") + groups({{0, "TEXT"}, {1, "part 7"}, {0, "TEXT"}, {1, "x"}})));
    EXPECT_THAT(drawing.notes, ElementsAre("not cut: 2 TEXT"));
}

TEST(Dxf, ErrorsNameEntityAndSourceLocation) {
    const auto error = [](Groups list) { return dxf_fault(dxf_of(groups(list))); };
    EXPECT_THAT(error({{0, "LINE"}, {5, "2F"}, {10, "3"}, {20, "4"}, {11, "3"}, {21, "4"}}),
                testing::AllOf(HasSubstr("line 6"), HasSubstr("LINE 2F at (3, 4) has no length")));
    EXPECT_THAT(error({{0, "CIRCLE"}, {10, "0"}, {20, "nan"}, {40, "1"}}), HasSubstr("line 10: 'nan'"));
    EXPECT_THAT(error({{0, "CIRCLE"}, {10, "0"}, {20, "1e300"}, {40, "1"}}),
                HasSubstr("CIRCLE has the point"));
    EXPECT_THAT(error({{0, "CIRCLE"}, {10, "0"}, {20, "0"}, {40, "-1"}}), HasSubstr("radius -1"));
    EXPECT_THAT(error({{0, "CIRCLE"}, {10, "0"}, {40, "1"}}), HasSubstr("no value of group code 20"));
    EXPECT_THAT(error({{0, "INSERT"}, {2, "gone"}, {10, "0"}, {20, "0"}}), HasSubstr("'gone'"));
    EXPECT_THAT(error({{0, "LWPOLYLINE"}, {90, "3"}, {10, "0"}, {20, "0"}, {10, "1"}, {20, "0"}}),
                HasSubstr("specifies 3 corners, but has 2"));
    EXPECT_THAT(error({{0, "SPLINE"}, {71, "3"}, {10, "0"}, {20, "0"}}), HasSubstr("control points"));
    EXPECT_THAT(error({{0, "LINE"}, {10, "0"}, {20, "0"}, {30, "0"}, {11, "3"}, {21, "4"}, {31, "5"}}),
                HasSubstr("rises by 5"));
    EXPECT_THAT(error({{0, "CIRCLE"}, {10, "0"}, {20, "0"}, {40, "1"}, {210, "1"}, {230, "0"}}),
                HasSubstr("flat"));
}

TEST(Dxf, RejectsRecursiveBlock) {
    const std::string blocks = section("BLOCKS", groups({{0, "BLOCK"},
                                                         {2, "a"},
                                                         {0, "INSERT"},
                                                         {2, "a"},
                                                         {10, "0"},
                                                         {20, "0"},
                                                         {70, "100"},
                                                         {71, "100"},
                                                         {0, "ENDBLK"}}));
    const std::string text = dxf_of(groups({{0, "INSERT"}, {2, "a"}, {10, "0"}, {20, "0"}}), blocks);
    EXPECT_THAT(dxf_fault(text), HasSubstr("does one contain itself?"));
}

TEST(Dxf, RejectsTruncatedFile) {
    const std::string text = dxf_of(circle("5", "-3", "7") + circle("5", "30", "7"));
    for (std::size_t size = 0; size + 5 < text.size(); ++size)
        EXPECT_FALSE(read_dxf(text.substr(0, size), {}));
}

}  // namespace

}  // namespace gsim::drawing::dxf_reader_test
