#include "base/text/format.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::text {

namespace {

TEST(Format, AppendsToExistingText) {
    std::string text = "G1 ";
    append_format(text, "X{} F{:.1f}", 12, 2.25);
    EXPECT_EQ(text, "G1 X12 F2.2");

    fmt::memory_buffer buffer;
    append_format(buffer, "{}", 'X');
    append_format(buffer, "{:>4}", 7);
    EXPECT_EQ(fmt::to_string(buffer), "X   7");
}

TEST(Format, JoinsItemsOfAnyKind) {
    EXPECT_EQ(joined(std::vector<std::string>{"X", "Y", "Z"}, ", "), "X, Y, Z");
    EXPECT_EQ(joined(std::array{'A', 'C'}, " "), "A C");
    EXPECT_EQ(joined(std::array{1.0, 0.25}, ", "), "1, 0.25");
    EXPECT_EQ(joined(std::array{1.0, 0.25}, " ", "{:.3f}"), "1.000 0.250");
    const std::array names{"dxf", "svg", "step"};
    EXPECT_EQ(joined(names.begin(), names.end() - 1, " or "), "dxf or svg");
}

TEST(Format, JoinsNothingAndOneWithoutSeparator) {
    EXPECT_EQ(joined(std::vector<int>{}, ", "), "");
    EXPECT_EQ(joined(std::vector<int>{5}, ", "), "5");
}

}  // namespace

}  // namespace gsim::text
