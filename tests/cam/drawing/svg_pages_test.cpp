// Pages within pages of SVG: symbols, inner svg elements, and their errors.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/drawing/svg_reader.h"
#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::svg_pages_test {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

// A unit of the drawing is a mm.
std::string svg_of(const std::string& content) {
    return fmt::format("<svg width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">\n{}\n</svg>\n", content);
}

std::vector<double> areas_in(const std::string& content) {
    return areas_of(svg_drawing(svg_of(content)));
}

std::string error(const std::string& content) {
    return svg_fault(svg_of(content));
}

// SVG 2, 5.6.2: width and height of the use; else those of the symbol; else all of the page around it.
TEST(SvgPages, UseSetsSizeOfSymbol) {
    const std::string symbol = "<symbol id='s' viewBox='0 0 10 20'{}><rect width='10' height='20'/></symbol>";
    const auto used = [&](const char* size_of_symbol, const char* size_of_use) {
        return areas_in(fmt::format(fmt::runtime(symbol), size_of_symbol) +
                        fmt::format("<use href='#s' {}/>", size_of_use));
    };
    EXPECT_THAT(used(" width='10' height='20'", ""), ElementsAre(DoubleNear(200, 1e-6)));
    EXPECT_THAT(used(" width='10' height='20'", "width='20' height='40'"),
                ElementsAre(DoubleNear(800, 1e-6)));
    EXPECT_THAT(used("", "width='5' height='10'"), ElementsAre(DoubleNear(50, 1e-6)));
    EXPECT_THAT(used("", "width='100%' height='10'"), ElementsAre(DoubleNear(50, 1e-6)));
    EXPECT_THAT(used("", ""), ElementsAre(DoubleNear(25 * 50, 1e-6))) << "as high as the page";
    EXPECT_THAT(used(" preserveAspectRatio='none'", ""), ElementsAre(DoubleNear(100 * 50, 1e-6)));
}

TEST(SvgPages, ScalesAndCentresInnerPage) {
    const Drawing drawing =
        svg_drawing(svg_of("<svg x='10' y='10' width='20' height='40' viewBox='5 5 10 10'><circle cx='10' "
                           "cy='10' r='5'/></svg>"));
    ASSERT_EQ(drawing.drawn_contours.size(), 1U);
    const geometry::Box box = bounding_box(drawing.drawn_contours[0]);
    EXPECT_NEAR(box.low.x, 10, 1e-6);
    EXPECT_NEAR(box.high.x, 30, 1e-6);
    EXPECT_NEAR(box.low.y, 50 - 40, 1e-6) << "20 high, in the middle of 40 from 10 on";
    EXPECT_NEAR(box.high.y, 50 - 20, 1e-6);
    EXPECT_THAT(areas_in("<svg x='50'><rect width='3' height='2'/></svg>"), ElementsAre(DoubleNear(6, 1e-6)));
}

TEST(SvgPages, PageWithOneSideKeepsAspectRatio) {
    EXPECT_THAT(areas_of(svg_drawing("<svg width='50mm' viewBox='0 0 10 20'><rect width='10' height='20'/>"
                                     "</svg>")),
                ElementsAre(DoubleNear(50 * 100, 1e-6)));
    EXPECT_THAT(areas_of(svg_drawing("<svg height='50mm' viewBox='0 0 10 20'><rect width='10' height='20'/>"
                                     "</svg>")),
                ElementsAre(DoubleNear(25 * 50, 1e-6)));
}

TEST(SvgPages, PageErrorsNameLine) {
    EXPECT_THAT(error("<svg viewBox='0 0 10'/>"),
                HasSubstr("line 2: svg has viewBox=\"0 0 10\"; it must have four"));
    EXPECT_THAT(error("<svg viewBox='0 0 10 0'/>"), HasSubstr("line 2: svg has a viewBox without a size"));
    EXPECT_THAT(error("<svg id='a' x='wide'/>"),
                HasSubstr("line 2: svg a has x=\"wide\", which is not a length"));
    EXPECT_THAT(svg_fault("<svg width='0' viewBox='0 0 1 1'/>"), HasSubstr("has a page without a size"));
    EXPECT_THAT(error("<symbol id='s'><use href='#s'/></symbol><use href='#s'/>"),
                HasSubstr("nested deeper than 100 elements"));
    std::string deep;
    for (int i = 0; i < 102; ++i) deep += "<g>";
    for (int i = 0; i < 102; ++i) deep += "</g>";
    EXPECT_THAT(error(deep), HasSubstr("nested deeper than 100 elements"));
}

}  // namespace

}  // namespace gsim::drawing::svg_pages_test
