#include "base/text/read_number.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace gsim::text {
namespace {

struct Read {
    double value = 7;
    std::ptrdiff_t taken = 0;
    std::errc error{};

    bool operator==(const Read& other) const {
        return std::memcmp(&value, &other.value, sizeof value) == 0 && taken == other.taken &&
               error == other.error;
    }
};

Read as_we_do(const std::string& text) {
    Read read;
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), read.value);
    read.taken = end - text.data();
    read.error = error;
    return read;
}

Read as_the_library_does(const std::string& text) {
    Read read;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read.value);
    read.taken = end - text.data();
    read.error = error;
    return read;
}

TEST(ReadNumber, MatchesFromChars) {
    for (const char* text : {"0",
                             "-0",
                             "00012",
                             "5.",
                             ".5",
                             "-.5",
                             ".",
                             "-",
                             "",
                             "+1",
                             " 1",
                             "-+1",
                             "1e",
                             "1e+",
                             "1e+05",
                             "1.5e3x",
                             "0x10",
                             "1'0",
                             "9007199254740993",
                             "123456789012345678901234567890",
                             "1.7976931348623157e308",
                             "1.7976931348623159e308",
                             "1e309",
                             "-1e400",
                             "1e99999999999999999999",
                             "2.2250738585072011e-308",
                             "4.9e-324",
                             "3e-324",
                             "2e-324",
                             "-1e-400",
                             "1e-99999999999999999999",
                             "0e999",
                             "0.0e-9999",
                             "0e99999999999999999999",
                             "inf",
                             "-inf",
                             "infinity",
                             "nan",
                             "-nan",
                             "NaN",
                             "nanx"})
        EXPECT_EQ(as_we_do(text), as_the_library_does(text)) << text;
}

TEST(ReadNumber, MatchesFromCharsForRandomDigits) {
    std::mt19937_64 random(20261124);
    for (int i = 0; i < 200'000; ++i) {
        std::string text = random() % 2 == 0 ? "-" : "";
        for (std::uint64_t digits = random() % 20 + 1; digits > 0; --digits)
            text += static_cast<char>('0' + random() % 10);
        text += '.';
        for (std::uint64_t digits = random() % 20; digits > 0; --digits)
            text += static_cast<char>('0' + random() % 10);
        if (random() % 3 == 0) text += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
        ASSERT_EQ(as_we_do(text), as_the_library_does(text)) << text;
    }
}

TEST(ParseNumber, AcceptsSignedNumber) {
    EXPECT_EQ(parse_number("+1.5"), 1.5);
    EXPECT_EQ(parse_number("-1.5e3"), -1500);
    EXPECT_EQ(parse_number(".5"), 0.5);
}

TEST(ParseNumber, RejectsPartialOrNonFiniteNumber) {
    for (const char* text : {"", "+", "-", "+-1", "1 ", " 1", "1.5mm", "1e400", "inf", "nan", "0x10"})
        EXPECT_EQ(parse_number(text), std::nullopt) << text;
}

}  // namespace
}  // namespace gsim::text
