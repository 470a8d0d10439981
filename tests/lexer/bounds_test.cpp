#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lexer/scan.h"

namespace gsim::lexer::bounds_test {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// Returns `before` followed by `piece` many times.
std::string repeated(std::string before, std::string_view fragment, std::size_t count) {
    std::string text = std::move(before);
    for (std::size_t i = 0; i < count; ++i) text += fragment;
    return text;
}

TEST(Bounds, LimitWordsPerBlock) {
    EXPECT_EQ(scan(repeated("", "Q1 ", 500) + "\nX1\n").messages, "");
    const Scan over = scan(repeated("", "Q1 ", 501) + " X5 Y6\nX7\n");
    EXPECT_EQ(over.messages, "1:1501: error: the block has more than 500 words\n");
    EXPECT_EQ(over.words.size(), 501U);
    EXPECT_EQ(over.words.back(), "X=7") << "the rest of the line is dropped, the next line is read";
}

TEST(Bounds, LimitSymbolsPerBlock) {
    EXPECT_EQ(scan(repeated("#1=1", "+1", 998) + "\n").messages, "");
    EXPECT_EQ(scan(repeated("#1=1", "+1", 1000) + "\nX1\n").messages,
              "1:2002: error: the block has more than 2000 symbols\n");
}

TEST(Bounds, LimitBracketDepth) {
    EXPECT_EQ(scan(repeated("X", "[", 100) + "1" + repeated("", "]", 100) + "\n").messages, "");
    const Scan over = scan(repeated("X", "[", 101) + "1\nY2\n");
    EXPECT_EQ(over.messages, "1:102: error: brackets are nested more than 100 deep\n");
    EXPECT_THAT(over.words, Contains("Y=2"));
}

TEST(Bounds, MillionBracketsStopAtLimit) {
    const Scan result = scan(repeated("X", "[", 1000000) + "\nY2\n");
    EXPECT_THAT(result.messages,
                testing::StartsWith("1:102: error: brackets are nested more than 100 deep\n"));
    EXPECT_THAT(result.words, Contains("Y=2"));
    EXPECT_LT(result.tokens.size(), 200U);
}

TEST(Bounds, LimitLineLength) {
    const std::string max_length = "X1" + std::string(kMaxLineBytes - 2, ' ');
    EXPECT_EQ(scan(max_length + "\nY2\n").messages, "");
    const Scan over = scan(max_length + "7\nY2 @\n");
    EXPECT_EQ(over.messages,
              "1:1: error: the line has more than 65536 bytes\n"
              "2:4: error: unexpected character '@'\n");
    EXPECT_THAT(over.words, ElementsAre("X=1", "Y=2"));
    EXPECT_EQ(scan(max_length + "7").messages, "1:1: error: the line has more than 65536 bytes\n")
        << "as last line";
}

TEST(Bounds, LimitDigitsOfNumbers) {
    EXPECT_EQ(scan(repeated("X", "1", 24) + "\n").messages, "");
    EXPECT_EQ(scan(repeated("X", "1", 25) + "\n").messages,
              "1:1: error: the number has 25 characters, at most 24 are allowed\n");
    EXPECT_EQ(scan("N999999999\n").messages, "");
    EXPECT_EQ(scan("N0000000000001\n").messages, "");
    EXPECT_EQ(scan("N1000000000\n").messages, "1:1: error: the sequence number has more than 9 digits\n");
    EXPECT_EQ(scan("#1000000000=1\n").messages, "1:1: error: the variable's number has more than 9 digits\n");
}

TEST(Bounds, UnexpectedBytesAreReported) {
    EXPECT_EQ(scan(std::string_view("X1\0Y2\n", 6)).messages, "1:3: error: unexpected byte 0x00\n");
    EXPECT_EQ(scan("X1 \x1b Y2\n").messages, "1:4: error: unexpected byte 0x1B\n");
    EXPECT_EQ(scan("X1 \xc3\xa4\n").messages, "1:4: error: unexpected byte 0xC3\n") << "one error a block";
    EXPECT_EQ(scan("X1 @\nX2 !\n").messages,
              "1:4: error: unexpected character '@'\n2:4: error: unexpected character '!'\n");
}

TEST(Bounds, ByteOrderMarkIsSkippedOnlyAtStart) {
    EXPECT_THAT(scan("\xEF\xBB\xBFX1\n").words, ElementsAre("X=1"));
    EXPECT_EQ(scan("\xEF\xBB\xBFX1 @\n").messages, "1:4: error: unexpected character '@'\n");
    EXPECT_EQ(scan("X1 \xEF\xBB\xBF\n").messages, "1:4: error: unexpected byte 0xEF\n")
        << "elsewhere it is an error";
}

TEST(Bounds, MissingBracketIsReportedAtEndOfBlock) {
    EXPECT_EQ(scan("X[1+2\nY1\n").messages, "1:6: error: ']' is missing at the end of the block\n");
    EXPECT_EQ(scan("X[1+2;Y1\n").messages, "1:6: error: ']' is missing before ';'\n");
    EXPECT_THAT(scan("X[1+2\nY1\n").words, Contains("Y=1"));
}

}  // namespace
}  // namespace gsim::lexer::bounds_test
