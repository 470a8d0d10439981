#include "tests/conformance/canon_frame.h"

#include <array>

#include <gtest/gtest.h>

namespace gsim::conformance::canon_frame_test {
namespace {

TEST(CanonFrame, ConvertsInchesButNotDegrees) {
    CanonFrame frame;
    frame.set_unit(25.4);
    const PrintedPoint point = frame.to_machine({1, 2, 3, 90, -45, 30});
    EXPECT_EQ(point.at, (AxisValues{25.4, 50.8, 3 * 25.4, 90, -45, 30}));
    EXPECT_DOUBLE_EQ(point.tolerance[0], 25.4 * kPrinted);
    EXPECT_DOUBLE_EQ(point.tolerance[3], kPrinted);
}

TEST(CanonFrame, KeepsUnitOfGivenOffsets) {
    CanonFrame frame;
    frame.set_unit(25.4);
    frame.set_work_offset(std::array{1.0, 0.0, 0.0});
    frame.set_unit(1);
    const PrintedPoint point = frame.to_machine({10, 0, 0, 0, 0, 0});
    EXPECT_DOUBLE_EQ(point.at[0], 35.4);
    EXPECT_DOUBLE_EQ(point.tolerance[0], kPrinted * 26.4);
    EXPECT_DOUBLE_EQ(point.tolerance[1], kPrinted);  // an offset of 0 is exact
}

// The offset of G92 is part of the program's coordinates, which turn; the work offset and the tool's do not.
TEST(CanonFrame, RotatesOnlyG92Offset) {
    CanonFrame frame;
    frame.set_rotation_deg(90);
    frame.set_work_offset(std::array{100.0, 200.0, 300.0});
    frame.set_g92_offset(std::array{10.0, 20.0, 30.0});
    frame.set_tool_offset(std::array{1.0, 2.0, 3.0});
    const PrintedPoint point = frame.to_machine({5, 6, 7, 8, 9, 10});
    EXPECT_NEAR(point.at[0], 100 - 26 + 1, 1e-12);
    EXPECT_NEAR(point.at[1], 200 + 15 + 2, 1e-12);
    EXPECT_DOUBLE_EQ(point.at[2], 7 + 30 + 300 + 3);
    EXPECT_DOUBLE_EQ(point.at[3], 8);
}

TEST(CanonFrame, ToleranceGrowsWithDistanceUnderRotation) {
    CanonFrame frame;
    frame.set_rotation_deg(30);
    EXPECT_LT(frame.to_machine({0, 0, 0, 0, 0, 0}).tolerance[0], 2 * kPrinted);
    EXPECT_NEAR(frame.to_machine({1e4, 0, 0, 0, 0, 0}).tolerance[1], 1e4 * kPrinted * 3.14159 / 180, 1e-4);
}

}  // namespace
}  // namespace gsim::conformance::canon_frame_test
