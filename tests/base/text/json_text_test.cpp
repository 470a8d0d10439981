#include "base/text/json_text.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace gsim::text::json_text_test {
namespace {

std::string number(double value) {
    fmt::memory_buffer out;
    append_number(out, value);
    return fmt::to_string(out);
}

std::string string(std::string_view text) {
    fmt::memory_buffer out;
    append_json_string(out, text);
    return fmt::to_string(out);
}

TEST(JsonText, WritesRoundedNumbers) {
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(-0.0), "0");
    EXPECT_EQ(number(-1e-10), "0");
    EXPECT_EQ(number(254), "254");
    EXPECT_EQ(number(-0.5), "-0.5");
    EXPECT_EQ(number(0.1 + 0.2), "0.3");
    EXPECT_EQ(number(1e-9), "0.000000001");
    EXPECT_EQ(number(999999.999999999), "999999.999999999");
    EXPECT_EQ(number(1234567.5), "1234567.5");
    EXPECT_EQ(number(1e300), "1e+300");
    EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(number(std::nan("")), "null");
}

TEST(JsonText, NumbersReadBackAsRoundedValue) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-10, 8), mantissa(-1, 1);
    for (int i = 0; i < 100000; ++i) {
        const double value = mantissa(random) * std::pow(10, exponent(random));
        ASSERT_EQ(std::strtod(number(value).c_str(), nullptr), rounded(value)) << value;
        ASSERT_NEAR(rounded(value), value, 0.7e-9) << value;
    }
}

TEST(JsonText, RoundingLeavesNoNegativeZero) {
    EXPECT_FALSE(std::signbit(rounded(-1e-12)));
    EXPECT_FALSE(std::signbit(rounded(-0.0)));
}

TEST(JsonText, EscapesStrings) {
    EXPECT_EQ(string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
    EXPECT_EQ(string(std::string_view("\n\0", 2)), R"("\u000a\u0000")");
    EXPECT_EQ(string("\u00fc \u20ac \U0001F600"), "\"\u00fc \u20ac \U0001F600\"");
    EXPECT_EQ(string("\xff"), R"("\ufffd")");
    EXPECT_EQ(string("\xc3"), R"("\ufffd")");
    EXPECT_EQ(string("\xc0\xaf"), R"("\ufffd\ufffd")");            // overlong
    EXPECT_EQ(string("\xed\xa0\x80"), R"("\ufffd\ufffd\ufffd")");  // a surrogate
}

}  // namespace
}  // namespace gsim::text::json_text_test
