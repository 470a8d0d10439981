#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::recovery_test {
namespace {

using testing::ElementsAre;

TEST(Recovery, ErrorAffectsOnlyItsBlock) {
    const Parsed parsed = parse("G1 X1\nX5 Y\nG1 X2;5 5;X3\nX4\n");
    EXPECT_THAT(parsed.blocks, ElementsAre("words G=1 X=1:axis", "bad", "words G=1 X=2:axis", "bad",
                                           "words X=3:axis", "words X=4:axis"));
    EXPECT_EQ(parsed.messages, "2:4: error: Y has no value\n3:7: error: a number without its letter\n");
}

TEST(Recovery, ReportsOneMessagePerBlock) {
    EXPECT_EQ(parse("X Y ] @ [ Z\n").messages, "1:1: error: X has no value\n");
}

TEST(Recovery, NextBlockIsReadIndependently) {
    const Parsed parsed = parse("X5 G04 Y1\nX5\nP5 Y G4\nP2 M98\n");
    EXPECT_THAT(parsed.blocks, ElementsAre("bad", "words X=5:axis", "bad", "words P=2:program M=98"));
}

struct Wrong {
    const char* text;
    const char* message;
};

class SyntaxErrors : public testing::TestWithParam<Wrong> {};

TEST_P(SyntaxErrors, HaveExactMessages) {
    const Parsed parsed = parse(fmt::format("{}\nX1\n", GetParam().text));
    EXPECT_EQ(parsed.messages, fmt::format("1:{}\n", GetParam().message));
    ASSERT_EQ(parsed.blocks.size(), 2U);
    EXPECT_EQ(parsed.blocks[0], "bad");
    EXPECT_EQ(parsed.blocks[1], "words X=1:axis");
}

constexpr const char* kKeywordMessage =
    "7: error: a keyword is not allowed here; IF [..] GOTO n, IF [..] THEN .., WHILE [..] DO m, END m and "
    "GOTO n must be in a separate block";

INSTANTIATE_TEST_SUITE_P(
    All, SyntaxErrors,
    testing::Values(
        Wrong{"X", "1: error: X has no value"}, Wrong{"X G1", "1: error: X has no value"},
        Wrong{"G4 X", "4: error: X has no value"}, Wrong{"AR=", "1: error: AR= has no value"},
        Wrong{"5", "1: error: a number without its letter"},
        Wrong{"X1 0", "4: error: a number without its letter"},
        Wrong{"[1]", "1: error: '[' is not allowed here"},
        Wrong{"X[1]]", "5: error: ']' is not allowed here"},
        Wrong{"X[1+]", "5: error: ']' is not allowed here"},
        Wrong{"X[1*/2]", "5: error: '/' is not allowed here"},
        Wrong{"#1", "1: error: a variable must be the value of a word, or precede '='"},
        Wrong{"X1 #1 Y2", "4: error: a variable must be the value of a word, or precede '='"},
        Wrong{"X#1 #2 #3", "5: error: a variable must be the value of a word, or precede '='"},
        Wrong{"X1 #1=5", "6: error: an assignment must be in a separate block"},
        Wrong{"X#1=5", "4: error: an assignment must be in a separate block"},
        Wrong{"#1=", "4: error: the block ends too early"},
        Wrong{"X1 #1", "4: error: a variable must be the value of a word, or precede '='"},
        Wrong{"N5 N6", "4: error: a block must have only one N"},
        Wrong{"//G1", "2: error: a block must have only one block delete '/'"},
        Wrong{"X1 N5", "4: error: N must be at the start of a block, and only once"},
        Wrong{"X1 /", "4: error: block delete '/' must be at the start of a block, and only once"},
        Wrong{"X1 O5", "5: error: a program name must be at the start of a block"},
        Wrong{"G4 Y1", "4: error: Y has no meaning in a block with G04, which requires one of P, X and U"},
        Wrong{"Y1 G4",
              "4: error: G04 is given with an axis word, M98 or M99, or twice; it requires one of P, X and "
              "U, the time in seconds"},
        Wrong{"G4 G4",
              "4: error: G04 is given with an axis word, M98 or M99, or twice; it requires one of P, X and "
              "U, the time in seconds"},
        Wrong{"M98 P1 G4",
              "8: error: G04 is given with an axis word, M98 or M99, or twice; it requires one of P, X and "
              "U, the time in seconds"},
        Wrong{"M98 P1 M99", "8: error: M98 and M99 must be given only once in a block, and not with G04"},
        Wrong{"G4 P1 M99", "7: error: M98 and M99 must be given only once in a block, and not with G04"},
        Wrong{"G1 X5 GOTO5", kKeywordMessage}, Wrong{"IF[1 EQ 1]", "11: error: the block ends too early"},
        Wrong{"WHILE[1]DO", "11: error: the block ends too early"},
        Wrong{"WHILE[1]DO4", "11: error: DO and END require 1, 2 or 3"},
        Wrong{"END0", "4: error: DO and END require 1, 2 or 3"},
        Wrong{"END12", "4: error: DO and END require 1, 2 or 3"},
        Wrong{"GOTO", "5: error: the block ends too early"},
        Wrong{"GOTO-5", "5: error: '-' is not allowed here"},
        Wrong{"IF[1 LT 2 LT 3]GOTO5",
              "11: error: a comparison is not allowed here; comparisons are combined as [..] AND [..]"}));

}  // namespace
}  // namespace gsim::grammar::recovery_test
