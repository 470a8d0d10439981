// Rare content of DXF files: units of old and large drawings, unequal scales, curves that cannot be read.

#include <functional>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/drawing/dxf_reader.h"
#include "cam/drawing/nurbs.h"
#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::rare_dxf_test {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

std::string with_unit(int code) {
    return dxf_of(groups({{0, "LINE"}, {10, "0"}, {20, "0"}, {11, "1"}, {21, "0"}}),
                  section("HEADER", groups({{9, "$INSUNITS"}, {70, std::to_string(code)}})));
}

// The codes of $INSUNITS (AutoCAD's DXF reference) in mm.
TEST(RareDxf, ConvertsUnitsAndRejectsUnsupportedUnit) {
    for (const auto& [code, mm] : {std::pair{0, 1.0},
                                   {1, 25.4},
                                   {2, 304.8},
                                   {4, 1},
                                   {5, 10},
                                   {6, 1000},
                                   {9, 0.0254},
                                   {10, 914.4},
                                   {14, 100}}) {
        const Drawing drawing = dxf_drawing(with_unit(code));
        ASSERT_EQ(drawing.drawn_contours.size(), 1U) << code;
        EXPECT_NEAR(bounding_box(drawing.drawn_contours[0]).high.x, mm, 1e-9) << code;
    }
    EXPECT_THAT(dxf_fault(with_unit(20)), HasSubstr("the unit $INSUNITS 20 is not supported for parts"));
}

// A half disc of radius 2 below a block that is three times as wide as high.
TEST(RareDxf, BulgeInUnequallyScaledBlockBecomesEllipse) {
    const std::string blocks = section("BLOCKS", groups({{0, "BLOCK"},
                                                         {2, "a"},
                                                         {0, "LWPOLYLINE"},
                                                         {90, "2"},
                                                         {70, "1"},
                                                         {10, "-2"},
                                                         {20, "0"},
                                                         {42, "1"},
                                                         {10, "2"},
                                                         {20, "0"},
                                                         {0, "ENDBLK"}}));
    const Drawing drawing = dxf_drawing(
        dxf_of(groups({{0, "INSERT"}, {2, "a"}, {10, "0"}, {20, "0"}, {41, "3"}, {42, "1"}}), blocks));
    EXPECT_THAT(areas_of(drawing), ElementsAre(DoubleNear(3 * kPi * 4 / 2, 0.1)));
}

TEST(RareDxf, RejectsPolylineWithoutLengthAndTooManyCopies) {
    EXPECT_THAT(
        dxf_fault(dxf_of(groups({{0, "LWPOLYLINE"}, {90, "2"}, {10, "3"}, {20, "4"}, {10, "3"}, {20, "4"}}))),
        HasSubstr("at (3, 4) has no length"));
    const std::string blocks = section("BLOCKS", groups({{0, "BLOCK"}, {2, "a"}, {0, "ENDBLK"}}));
    EXPECT_THAT(
        dxf_fault(dxf_of(
            groups({{0, "INSERT"}, {2, "a"}, {10, "0"}, {20, "0"}, {70, "30000"}, {71, "30000"}}), blocks)),
        HasSubstr("INSERT of block 'a' has 30000 rows of 30000: too many"));
}

Nurbs parabola() {
    return {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {2, 0}}, .weights = {}};
}

std::string fault_with(const std::function<void(Nurbs&)>& spoil) {
    Nurbs curve = parabola();
    spoil(curve);
    return find_curve_error(curve).value_or("").message;
}

TEST(RareDxf, ReportsReasonForInvalidCurves) {
    EXPECT_EQ(find_curve_error(parabola()), std::nullopt);
    EXPECT_THAT(fault_with([](Nurbs& curve) { curve.degree = 0; }),
                HasSubstr("has degree 0; supported are 1 to "));
    EXPECT_EQ(fault_with([](Nurbs& curve) { curve.points.pop_back(); }),
              "has 2 control points; degree 2 requires at least 3");
    EXPECT_EQ(fault_with([](Nurbs& curve) { curve.knots.pop_back(); }),
              "has 5 knots; 3 control points of degree 2 require 6");
    EXPECT_EQ(fault_with([](Nurbs& curve) { curve.knots[5] = -1; }), "has decreasing knots");
    EXPECT_EQ(fault_with([](Nurbs& curve) { curve.knots.assign(6, 1); }), "has knots without a range");
    EXPECT_EQ(fault_with([](Nurbs& curve) { curve.weights = {1}; }), "has 1 weights for 3 control points");
    EXPECT_EQ(fault_with([](Nurbs& curve) {
                  curve.weights = {1, 0, 1};
              }),
              "has a weight that is not greater than 0");
}

}  // namespace

}  // namespace gsim::drawing::rare_dxf_test
