#include "cam/drawing/svg_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::svg_reader_test {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// A unit of the drawing is a mm.
std::string svg_of(const std::string& content) {
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" "
        "viewBox=\"0 0 100 50\">\n{}\n</svg>\n",
        content);
}

std::vector<double> areas_in(const std::string& content) {
    return areas_of(svg_drawing(svg_of(content)));
}

std::string path_of(const std::string& data) {
    return fmt::format("<path id=\"p\" d=\"{}\"/>", data);
}

TEST(Svg, ReadsBasicShapes) {
    EXPECT_THAT(areas_in("<rect x='1' y='2' width='30' height='20'/>"), ElementsAre(DoubleNear(600, 1e-6)));
    EXPECT_THAT(areas_in("<rect width='30' height='20' rx='3'/>"),
                ElementsAre(DoubleNear(600 - (4 - kPi) * 9, 1e-6)));
    EXPECT_THAT(areas_in("<circle cx='10' cy='20' r='5'/>"), ElementsAre(DoubleNear(25 * kPi, 1e-6)));
    EXPECT_THAT(areas_in("<ellipse cx='10' cy='20' rx='5' ry='8'/>"), ElementsAre(DoubleNear(40 * kPi, 0.1)));
    EXPECT_THAT(areas_in("<polygon points='0,0 10,0 0,8'/>"), ElementsAre(DoubleNear(40, 1e-6)));
    EXPECT_THAT(areas_in("<polyline points='0,0 10,0 0,8 0 0'/>"), ElementsAre(DoubleNear(40, 1e-6)));
    EXPECT_THAT(areas_in("<line x2='10'/><line x1='10' x2='10' y2='10'/><line x2='10' y2='10'/>"),
                ElementsAre(DoubleNear(50, 1e-6)));
}

// As older Inkscapes and CAD programs write them.
TEST(Svg, ReadsShapesWithNamespacePrefix) {
    EXPECT_THAT(areas_in("<svg:rect width='30' height='20'/>"), ElementsAre(DoubleNear(600, 1e-6)));
    EXPECT_THAT(areas_in("<svg:g><svg:circle cx='10' cy='20' r='5'/></svg:g>"),
                ElementsAre(DoubleNear(25 * kPi, 1e-6)));
    EXPECT_THAT(areas_in("<svg:path d='M0 0H10V10H0Z'/>"), ElementsAre(DoubleNear(100, 1e-6)));
    EXPECT_THAT(areas_in("<svg:polygon points='0,0 10,0 0,8'/>"), ElementsAre(DoubleNear(40, 1e-6)));
}

TEST(Svg, ConvertsToMmWithYUp) {
    const Drawing drawing = svg_drawing(svg_of("<circle cx='10' cy='20' r='5'/>"));
    const geometry::Box box = bounding_box(drawing.drawn_contours[0]);
    EXPECT_NEAR(box.low.x, 5, 1e-9);
    EXPECT_NEAR(box.low.y, 50 - 25, 1e-9);
    const Drawing px = svg_drawing("<svg><rect width='96' height='96'/></svg>");
    EXPECT_THAT(areas_of(px), ElementsAre(DoubleNear(25.4 * 25.4, 1e-6)));
    ReadOptions inches;
    inches.unit_mm = 25.4;
    const Drawing inch = svg_drawing(svg_of("<rect width='1' height='1'/>"), inches);
    EXPECT_THAT(areas_of(inch), ElementsAre(DoubleNear(25.4 * 25.4, 1e-6)));
}

TEST(Svg, AbsoluteAndRelativePathDataAgree) {
    const double half_disc = 100 + kPi * 25 / 2;  // a square of 10 with a half disc on one side
    for (const char* data : {"M0 0 H10 V10 A5 5 0 0 1 0 10 Z", "m0,0h10v10a5,5 0 0 1 -10,0z",
                             "M 0 0 10 0 10 10 A 5 5 0 01 0 10 L 0 0", "m0 0 10 0 0 10a5 5 0 01-10 0z"}) {
        EXPECT_THAT(areas_in(path_of(data)), ElementsAre(DoubleNear(half_disc, 1e-6))) << data;
    }
    // Under a parabola: two thirds of the box.
    for (const char* data : {"M0 0 Q10 20 20 0 Z", "m0 0q10 20 20 0z",
                             "M0 0C6.6666666667 13.3333333333 13.3333333333 13.3333333333 20 0z"}) {
        EXPECT_THAT(areas_in(path_of(data)), ElementsAre(DoubleNear(20 * 10 * 2 / 3.0, 0.05))) << data;
    }
    // S and T mirror the control point before.
    EXPECT_NEAR(areas_in(path_of("M0 0C0 5 5 5 5 0S10-5 10 0V20H0Z"))[0],
                areas_in(path_of("M0 0C0 5 5 5 5 0C5-5 10-5 10 0V20H0Z"))[0], 1e-9);
    EXPECT_NEAR(areas_in(path_of("M0 0Q2.5 5 5 0T10 0V20H0Z"))[0],
                areas_in(path_of("M0 0Q2.5 5 5 0Q7.5-5 10 0V20H0Z"))[0], 1e-9);
    EXPECT_THAT(areas_in(path_of("M0 0h1v1h-1zm5 5h2v2h-2z")),
                ElementsAre(DoubleNear(1, 1e-9), DoubleNear(4, 1e-9)));
}

TEST(Svg, SelectsCorrectArcOfFour) {
    // The larger part of a disc of radius 5 over a chord of 6, and the smaller one.
    const double half_angle = std::asin(0.6);
    const double small = 25 * (half_angle - std::sin(2 * half_angle) / 2);
    EXPECT_THAT(areas_in(path_of("M0 0A5 5 0 0 0 6 0Z")), ElementsAre(DoubleNear(small, 1e-6)));
    EXPECT_THAT(areas_in(path_of("M0 0A5 5 0 1 1 6 0Z")), ElementsAre(DoubleNear(25 * kPi - small, 1e-6)));
    const auto top = [](const std::string& data) {
        return bounding_box(svg_drawing(svg_of(path_of(data))).drawn_contours[0]).high.y;
    };
    EXPECT_NEAR(top("M0 40A5 5 0 0 1 10 40Z"), 15, 1e-6);  // positive angles go clockwise on the page
    EXPECT_NEAR(top("M0 40A5 5 0 0 0 10 40Z"), 10, 1e-6);
    EXPECT_THAT(areas_in(path_of("M0 0A1 1 0 0 1 20 0Z")), ElementsAre(DoubleNear(50 * kPi, 1e-6)));  // grown
}

// Clockwise and counter-clockwise: a quarter of an ellipse within 0.005 mm takes some arcs, not thousands.
TEST(Svg, ApproximatesEllipsesInBothDirectionsWithFewArcs) {
    for (const char* sweep : {"0", "1"}) {
        const Drawing drawing = svg_drawing(
            svg_of(path_of(fmt::format("M10 20A10 5 0 0 {} 30 20A10 5 0 0 {} 10 20Z", sweep, sweep))));
        EXPECT_THAT(areas_of(drawing), ElementsAre(DoubleNear(50 * kPi, 0.05)));
        EXPECT_LT(drawing.drawn_contours[0].edges(), 100U);
    }
    const Drawing stretched =
        svg_drawing(svg_of("<path transform='scale(2 1)' d='M0 0H10A5 5 0 0 0 20 0V-10H0Z'/>"));
    EXPECT_THAT(areas_of(stretched), ElementsAre(DoubleNear(2 * (200 + 12.5 * kPi), 0.05)));
    EXPECT_LT(stretched.drawn_contours[0].edges(), 100U);
}

TEST(Svg, AppliesTransformsGroupsAndUses) {
    EXPECT_THAT(
        areas_in(
            "<g transform='translate(3 4) scale(2)'><g transform='rotate(30 5 5)'><circle r='5'/></g></g>"),
        ElementsAre(DoubleNear(100 * kPi, 1e-6)));
    EXPECT_THAT(areas_in("<circle r='5' transform='matrix(2 0 0 1 0 0)'/>"),
                ElementsAre(DoubleNear(50 * kPi, 0.1)));
    EXPECT_THAT(areas_in("<circle r='5' transform='skewX(30)'/>"), ElementsAre(DoubleNear(25 * kPi, 0.1)));
    EXPECT_THAT(areas_in("<defs><rect id='r' width='2' height='3'/></defs><use href='#r' x='9'/>"
                         "<use xlink:href='#r' transform='scale(-2 1)'/>"),
                ElementsAre(DoubleNear(6, 1e-6), DoubleNear(12, 1e-6)));
    EXPECT_THAT(areas_in("<g style='display: none'><rect width='1' height='1'/></g><text>x</text>"),
                ElementsAre());
}

TEST(Svg, StyleSheetsHideShapes) {
    const std::string shapes =
        "<rect width='1' height='1' class='a frame'/><rect id='b' width='2' height='1'/>"
        "<circle r='1' class='frame'/><rect width='4' height='1' class='frame' style='display:inline'/>";
    const auto left = [&shapes](const std::string& sheet) {
        return areas_in("<style type='text/css'>" + sheet + "</style>" + shapes);
    };
    const auto near = [](double area) { return DoubleNear(area, 1e-6); };
    EXPECT_THAT(left(""), ElementsAre(near(1), near(2), near(kPi), near(4)));
    EXPECT_THAT(left(".frame { fill: none; display: none }"), ElementsAre(near(2), near(4)));
    EXPECT_THAT(left("<![CDATA[ rect.frame, #b {visibility:hidden;} ]]>"), ElementsAre(near(kPi)));
    EXPECT_THAT(left("circle{display:none} .frame{display:inline} "),
                ElementsAre(near(1), near(2), near(kPi), near(4)));
    EXPECT_THAT(left("/* .a{ */ *{display:none !important} @import url(x); #b{display:block}"),
                ElementsAre(near(2), near(4)));
    EXPECT_THAT(left(".frame{display:none"), ElementsAre(near(2), near(4)));  // cut off
    EXPECT_THAT(left("{}}{;{@media print{.frame{fill:red}}"), testing::SizeIs(4));

    const Drawing drawing =
        svg_drawing(svg_of("<style>g > rect{display:none} g rect{fill:red} @media print{a{display:none}}"
                           "</style><rect width='1' height='1'/>"));
    EXPECT_THAT(drawing.notes, ElementsAre(HasSubstr("'g > rect' of the style sheet is not supported"),
                                           HasSubstr("'@media print'")));
}

TEST(Svg, VisibleGroupInHiddenGroupIsCut) {
    EXPECT_THAT(areas_in("<g visibility='hidden'><rect width='1' height='1'/>"
                         "<g visibility='visible'><rect width='2' height='1'/></g></g>"),
                ElementsAre(DoubleNear(2, 1e-6)));
}

TEST(Svg, ErrorsNameElementAndLine) {
    const auto error = [](const std::string& content) { return svg_fault(svg_of(content)); };
    EXPECT_THAT(error(path_of("M0 0 L10")),
                HasSubstr("line 3: path p has path data that cannot be read at character"));
    EXPECT_THAT(error(path_of("L0 0")), HasSubstr("does not begin with M"));
    EXPECT_THAT(error(path_of("M0 0L nan 3")), HasSubstr("line 3"));
    EXPECT_THAT(error(path_of("M0 0L1e300 3z")), HasSubstr("coordinates must not exceed 500000 mm"));
    EXPECT_THAT(error(path_of("M1 1")), HasSubstr("has no length"));
    EXPECT_THAT(error("<rect width='3'/>"), HasSubstr("rect has the size 3 x 0"));
    EXPECT_THAT(error("<circle r='50%'/>"), HasSubstr("has r=\"50%\", which is not a length"));
    EXPECT_THAT(error("\n\n<g transform='turn(3)'/>"), HasSubstr("line 5: g has transform"));
    EXPECT_THAT(error("<use href='#gone'/>"), HasSubstr("'#gone'"));
    EXPECT_THAT(error("<g id='a'><use href='#a'/></g>"), HasSubstr("nested deeper"));
    EXPECT_THAT(svg_fault("<svg><rect"), HasSubstr("not valid XML"));
    EXPECT_THAT(svg_fault("<html/>"), HasSubstr("<html>"));
}

}  // namespace

}  // namespace gsim::drawing::svg_reader_test
