#include "base/text/number.h"

#include <cmath>

#include <gtest/gtest.h>

namespace gsim::text::number_test {
namespace {

TEST(Number, FixedHasRequestedDigitsAndNoNegativeZero) {
    EXPECT_EQ(fixed(1.23456, 3), "1.235");
    EXPECT_EQ(fixed(-1.23456, 3), "-1.235");
    EXPECT_EQ(fixed(-0.0004, 3), "0.000");
    EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
    EXPECT_EQ(fixed(-0.0, 1), "0.0");
    EXPECT_EQ(fixed(-0.4, 0), "0");
    EXPECT_EQ(fixed(-10, 0), "-10");
    EXPECT_EQ(fixed(1e300, 2).size(), 304U);
}

TEST(Number, RemovesSignOfZero) {
    EXPECT_FALSE(std::signbit(unsigned_zero(-0.0)));
    EXPECT_EQ(unsigned_zero(-1e-300), -1e-300);
    EXPECT_EQ(unsigned_zero("-0."), "0.");
    EXPECT_EQ(unsigned_zero("-00.10"), "-00.10");
    EXPECT_EQ(unsigned_zero("-.0"), ".0");
}

}  // namespace
}  // namespace gsim::text::number_test
