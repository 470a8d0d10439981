#include "cam/cutting/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cam/cutting/cut_path.h"
#include "tests/geometry/planar/shapes.h"

namespace gsim::cutting::layout_test {

namespace {

using geometry::Contour;
using testing::AllOf;
using testing::HasSubstr;

std::string error_message(const std::vector<Contour>& contours, double kerf_mm = 1) {
    const auto layout = make_layout(drawing_of(contours), {kerf_mm, 0.02});
    EXPECT_FALSE(layout);
    return layout ? "" : layout.error().message;
}

TEST(Layout, OffsetsPartsOutwardAndHolesInward) {
    const auto layout =
        make_layout(drawing_of({geometry::circle({0, 0}, 10), geometry::rectangle({-30, -20}, {30, 20}),
                                geometry::circle({0, 0}, 4)}),
                    {0.8, 0.02});
    ASSERT_TRUE(layout) << layout.error().message;
    ASSERT_EQ(layout->loops.size(), 3U);
    constexpr double kPi = std::numbers::pi;
    EXPECT_NEAR(area_mm2(layout->loops[0].contour), -kPi * 9.6 * 9.6, 1e-6);  // a hole, clockwise
    EXPECT_NEAR(area_mm2(layout->loops[1].contour), 60 * 40 + 200 * 0.4 + kPi * 0.16, 1e-6);
    EXPECT_NEAR(area_mm2(layout->loops[2].contour), kPi * 4.4 * 4.4, 1e-6);  // a part in the hole
    EXPECT_EQ(layout->outlines[2].parent, 0U);
}

TEST(Layout, ErrorsNameEntityAndPosition) {
    Contour open = geometry::rectangle({0, 0}, {10, 10});
    open.closed = false;
    EXPECT_THAT(error_message({open}),
                AllOf(HasSubstr("piece 0 at line 1"), HasSubstr("(0, 10)"), HasSubstr("10 mm apart")));
    EXPECT_THAT(error_message({geometry::polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}),
                HasSubstr("meet at (5, 5)"));
    EXPECT_THAT(error_message({geometry::circle({}, 5), geometry::circle({8, 0}, 5)}),
                AllOf(HasSubstr("piece 0 at line 1 and piece 1 at line 2"), HasSubstr("meet at (4, ")));
    EXPECT_THAT(error_message({geometry::circle({}, 5), geometry::circle({}, 5)}), HasSubstr("meet at"));
    EXPECT_THAT(error_message({geometry::circle({}, 20), geometry::circle({}, 0.4)}),
                HasSubstr("narrower than the kerf"));
    EXPECT_THAT(error_message({geometry::circle({}, 5), geometry::circle({10.5, 0}, 5)}),
                HasSubstr("closer to each other than the kerf of 1 mm"));
    EXPECT_THAT(error_message({geometry::polygon({{0, 0}, {5, 5}})}), HasSubstr("encloses no area"));
    EXPECT_THAT(error_message({}), HasSubstr("no contour"));
}

TEST(Layout, SplitsHoleWithNarrowNeckAndReportsIt) {
    const Contour neck = geometry::polygon({{0, 0},
                                            {10, 0},
                                            {10, 4.6},
                                            {20, 4.6},
                                            {20, 0},
                                            {30, 0},
                                            {30, 10},
                                            {20, 10},
                                            {20, 5.4},
                                            {10, 5.4},
                                            {10, 10},
                                            {0, 10}});
    const auto layout = make_layout(drawing_of({geometry::rectangle({-10, -10}, {40, 20}), neck}), {1, 0.02});
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->loops.size(), 3U);
    ASSERT_EQ(layout->notes.size(), 1U);
    EXPECT_THAT(layout->notes[0], HasSubstr("narrower than the kerf"));
}

}  // namespace

}  // namespace gsim::cutting::layout_test
