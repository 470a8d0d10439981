#include "tests/accuracy/controller.h"

#include <limits>

#include <gtest/gtest.h>

namespace gsim::accuracy::controller_test {
namespace {

TEST(Tolerance, IsLargerOfPercentageAndFixedTime) {
    const Tolerance tolerance{0.5, 0.005};
    EXPECT_TRUE(tolerance.is_within(0.05, 10));  // 0.5 % of 10 s
    EXPECT_TRUE(tolerance.is_within(-0.05, 10));
    EXPECT_FALSE(tolerance.is_within(0.0501, 10));
    EXPECT_FALSE(tolerance.is_within(-0.0501, 10));
    EXPECT_TRUE(tolerance.is_within(0.005, 0.1));  // 5 %, but 5 ms
    EXPECT_FALSE(tolerance.is_within(0.0051, 0.1));
}

TEST(Tolerance, IncludesItsBorderDespiteRounding) {
    const Tolerance tolerance{0.5, 0.005};
    for (int ms = 100; ms < 1000; ++ms) {
        const double recorded_s = ms / 1000.0;
        const double found_s = (ms + 5) / 1000.0;
        EXPECT_TRUE(tolerance.is_within(found_s - recorded_s, recorded_s)) << ms;
        EXPECT_FALSE(tolerance.is_within((ms + 6) / 1000.0 - recorded_s, recorded_s)) << ms;
    }
}

TEST(Tolerance, RejectsNonFiniteErrors) {
    const Tolerance tolerance{0.5, 0.005};
    EXPECT_FALSE(tolerance.is_within(std::numeric_limits<double>::quiet_NaN(), 10));
    EXPECT_FALSE(tolerance.is_within(std::numeric_limits<double>::infinity(), 10));
}

TEST(Controllers, FairToleranceIncludesCloseTolerance) {
    for (const Controller& controller : kControllers) {
        for (const double recorded_s : {0.0, 0.05, 0.3, 1.0, 100.0}) {
            for (const double error_s : {0.0, 0.001, 0.004, 0.01, 0.4}) {
                if (!controller.close.is_within(error_s, recorded_s)) continue;
                EXPECT_TRUE(controller.fair.is_within(error_s, recorded_s))
                    << controller.name << ' ' << recorded_s << ' ' << error_s;
            }
        }
    }
}

}  // namespace
}  // namespace gsim::accuracy::controller_test
