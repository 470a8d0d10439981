// Recordings of set points and positions, in each form.

#include "calibrate/servo/servo_record.h"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::calibrate::servo_record_test {
namespace {

using testing::HasSubstr;

/// 25 lines of a form with three numbers: time or number, set point, and another one.
std::string lines(const std::string& columns_format, double first = 0) {
    std::string text;
    for (int i = 0; i < 25; ++i)
        text += fmt::format(fmt::runtime(columns_format), first + i, 0.5 * i, 0.4 * i);
    return text;
}

std::string error_of(const std::string& text, const ServoFormat& columns_format = {}) {
    const auto read = read_servo_record(text, columns_format);
    return read ? "no error" : read.error().message;
}

TEST(ServoRecord, ReadsPositionsFromNamedColumns) {
    const auto read = read_servo_record("t_s,line,b_deg,b_at_deg\n" + lines("{0},7,{1},{2}\n"), {});
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->size(), 1U);
    EXPECT_EQ(read->front().letter, 'B');
    ASSERT_EQ(read->front().t_s.size(), 25U);
    EXPECT_EQ(read->front().t_s[3], 3);
    EXPECT_EQ(read->front().set_points[3], 1.5);
    EXPECT_DOUBLE_EQ(read->front().positions[3], 1.2);
}

/// As a trajectory of gsim-run has them.
TEST(ServoRecord, ComputesPositionsFromErrors) {
    const auto read = read_servo_record("t_s,x_mm,y_mm,x_error_mm\n" + lines("{0},{1},3,{2}\n"), {});
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->size(), 1U) << "of Y nothing is known but its set points";
    EXPECT_DOUBLE_EQ(read->front().positions[10], 5.0 - 4.0);
}

TEST(ServoRecord, ReadsHalsamplerByGivenColumns) {
    const ServoFormat columns_format{0.002, "-Xx"};
    for (const std::string& text :
         {lines("9 {1} {2}\n"), lines("{0} 9 {1} {2}\n"), "overrun\n" + lines("{0} 9 {1} {2}\n")}) {
        const auto read = read_servo_record(text, columns_format);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_DOUBLE_EQ(read->front().t_s[4], 0.008);
        EXPECT_DOUBLE_EQ(read->front().positions[4], 1.6);
    }
    const auto late = read_servo_record(lines("{0} 9 {1} {2}\n", 100), columns_format);
    EXPECT_DOUBLE_EQ(late->front().t_s[0], 0.2) << "by its number";
}

TEST(ServoRecord, ReportsMissingData) {
    EXPECT_EQ(error_of(""), "it is empty");
    EXPECT_THAT(error_of("t_s,x_mm\n0,1\n"), HasSubstr("x_at_mm"));
    EXPECT_THAT(error_of("x_mm,x_at_mm\n0,1\n"), HasSubstr("the columns must be t_s"));
    EXPECT_THAT(error_of("t_s,x_mm,x_at_mm\n0,1,1\n1,2\n"), HasSubstr("a number is missing"));
    EXPECT_THAT(error_of("t_s,x_mm,x_at_mm\n0,1,1\n"), HasSubstr("fewer than 20 samples"));
    EXPECT_THAT(error_of("1 2\n1 2\n"), HasSubstr("--sample-period"));
    EXPECT_THAT(error_of("1 2\n1 2\n", {0.001, "Xy"}), HasSubstr("has no axis"));
    EXPECT_THAT(error_of("1 2\n1 2 3 4\n", {0.001, "Xx"}), HasSubstr("line 2: it must have the 2 numbers"));
    EXPECT_THAT(error_of("1 2\n1 nan\n", {0.001, "Xx"}), HasSubstr("line 2"));
}

}  // namespace
}  // namespace gsim::calibrate::servo_record_test
