// Families of conflicts that the grammar leaves to GLR (see %expect in gcode.y), each in blocks with several
// readings until their last word. An ambiguity that stayed would stop the parser.
#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::conflicts_test {
namespace {

/// Block with exactly one valid reading, and the reading.
struct Reading {
    const char* text;
    const char* block;
};

void expect_reading(const Reading& reading, const Dialect& dialect) {
    const std::string after = dialect.text().ambiguous_words ? "words X=1:axis" : "words X=1";
    const Parsed parsed = parse(std::string(reading.text) + "\nX1\n", dialect);
    EXPECT_TRUE(parsed.finished) << "ambiguous: " << reading.text;
    EXPECT_EQ(parsed.messages, "") << reading.text;
    ASSERT_EQ(parsed.blocks.size(), 2U) << reading.text;
    EXPECT_EQ(parsed.blocks[0], reading.block) << reading.text;
    EXPECT_EQ(parsed.blocks[1], after) << "the block behind " << reading.text;
}

class Ab9Conflicts : public testing::TestWithParam<Reading> {};
TEST_P(Ab9Conflicts, AreResolved) {
    expect_reading(GetParam(), dialect_ab9());
}

class NgcConflicts : public testing::TestWithParam<Reading> {};
TEST_P(NgcConflicts, AreResolved) {
    expect_reading(GetParam(), dialect_rs274ngc());
}

// X or U, an axis or the time of a dwell, before each token that fits both kinds of block.
INSTANTIATE_TEST_SUITE_P(XAndU, Ab9Conflicts,
                         testing::Values(Reading{"X5", "words X=5:axis"},
                                         Reading{"X5 F1", "words X=5:axis F=1"},
                                         Reading{"X5 F1 G4", "words X=5:time F=1 G=4"},
                                         Reading{"X5 U6 F1", "words X=5:axis U=6:axis F=1"},
                                         Reading{"X5 U6 F1 G4", "words X=5:time U=6:time F=1 G=4"},
                                         Reading{"X5 P6 F1", "words X=5:axis P=6:parameter F=1"},
                                         Reading{"X5 P6 F1 G4", "words X=5:time P=6:time F=1 G=4"},
                                         Reading{"X5 P6 F1 M98", "words X=5:axis P=6:program F=1 M=98"},
                                         Reading{"U5 F1 Y2", "words U=5:axis F=1 Y=2"},
                                         Reading{"U5 F1 M99", "words U=5:axis F=1 M=99"},
                                         Reading{"X5 X6 X7", "words X=5:axis X=6:axis X=7:axis"},
                                         Reading{"X5 X6 G4 X7", "words X=5:time X=6:time G=4 X=7:time"},
                                         Reading{"N7 /2 X5 U6 G4", "N7 /2 words X=5:time U=6:time G=4"}));

// P, a parameter, the time of a dwell or a program, before the same tokens.
INSTANTIATE_TEST_SUITE_P(
    P, Ab9Conflicts,
    testing::Values(Reading{"P5", "words P=5:parameter"}, Reading{"P5 F1", "words P=5:parameter F=1"},
                    Reading{"P5 F1 G4", "words P=5:time F=1 G=4"},
                    Reading{"P5 F1 M98", "words P=5:program F=1 M=98"},
                    Reading{"P5 F1 M99", "words P=5:program F=1 M=99"},
                    Reading{"P5 X6", "words P=5:parameter X=6:axis"},
                    Reading{"P5 X6 G4", "words P=5:time X=6:time G=4"},
                    Reading{"P5 X6 M98", "words P=5:program X=6:axis M=98"},
                    Reading{"P5 P6 M98", "words P=5:program P=6:program M=98"},
                    Reading{"P5 P6 G4", "words P=5:time P=6:time G=4"},
                    Reading{"P5 Y1 P6 F1", "words P=5:parameter Y=1 P=6:parameter F=1"},
                    Reading{"P5 Y1 M98 P6", "words P=5:program Y=1 M=98 P=6:program"},
                    Reading{"M98 P5 Y1 U2 P6", "words M=98 P=5:program Y=1 U=2:axis P=6:program"}));

// The same with values that are expressions, which have conflicts of their own.
INSTANTIATE_TEST_SUITE_P(
    InValues, Ab9Conflicts,
    testing::Values(
        Reading{"X[ATAN[1]/[2]] P[ATAN[3]/4]", "words X=(ATAN 1 2):axis P=(/ (ATAN 3) 4):parameter"},
        Reading{"X[ATAN[1]/[2]] P[ATAN[3]/4] G4", "words X=(ATAN 1 2):time P=(/ (ATAN 3) 4):time G=4"},
        Reading{"X[ATAN[1]/[2]] P[ATAN[3]/4] M98", "words X=(ATAN 1 2):axis P=(/ (ATAN 3) 4):program M=98"},
        Reading{"X[ATAN[1]/[2]] F1 G4", "words X=(ATAN 1 2):time F=1 G=4"},
        Reading{"X#1 P##2 F#[3]", "words X=#1:axis P=(# #2):parameter F=(# 3)"},
        Reading{"X#1 P##2 F#[3] G4", "words X=#1:time P=(# #2):time F=(# 3) G=4"},
        Reading{"IF[ATAN[1]/[2] EQ 3]THEN X5 F1 G4", "if (EQ (ATAN 1 2) 3) then X=5:time F=1 G=4"},
        Reading{"IF[1]THEN X5 P6 F1 M98", "if 1 then X=5:axis P=6:program F=1 M=98"}));

// #1 at the start of a block and after THEN: assignments here.
INSTANTIATE_TEST_SUITE_P(
    Assignments, Ab9Conflicts,
    testing::Values(Reading{"#1=2", "assign #1:=2"}, Reading{"#1=2 #[3]=4", "assign #1:=2 (# 3):=4"},
                    Reading{"##1=#2+3", "assign (# #1):=(+ #2 3)"},
                    Reading{"#[ATAN[1]/[2]]=ATAN[3]/4", "assign (# (ATAN 1 2)):=(/ (ATAN 3) 4)"},
                    Reading{"IF[#1]THEN #2=3 #4=5", "if #1 then #2:=3 #4:=5"},
                    Reading{"IF[#1]THEN", "if #1 then"}, Reading{"N5 /1 #1=2", "N5 /1 assign #1:=2"}));

// In RS274/NGC X, U and P have one meaning each; a block of settings alone is a block of words.
INSTANTIATE_TEST_SUITE_P(Words, NgcConflicts,
                         testing::Values(Reading{"X5 F1 G4", "words X=5 F=1 G=4"},
                                         Reading{"P5 X6 U7 F1 G4", "words P=5 X=6 U=7 F=1 G=4"},
                                         Reading{"P5 X6 M98", "words P=5 X=6 M=98"},
                                         Reading{"G4 X1 P2 G4", "words G=4 X=1 P=2 G=4"},
                                         Reading{"@5 ^6 $1", "words @=5 ^=6 $=1"}));

INSTANTIATE_TEST_SUITE_P(
    Settings, NgcConflicts,
    testing::Values(Reading{"#1=2", "words #1:=2"},
                    Reading{"#1=2 #<a>=3 #[4]=5 ##6=7", "words #1:=2 #<a>:=3 (# 4):=5 (# #6):=7"},
                    Reading{"X1 #1=2 Y3", "words X=1 Y=3 #1:=2"}, Reading{"X#1 #2=3", "words X=#1 #2:=3"},
                    Reading{"X##1 ##2=3", "words X=(# #1) (# #2):=3"},
                    Reading{"X#[1] #[2]=3", "words X=(# 1) (# 2):=3"},
                    Reading{"X#<a> #<a>=#<b>", "words X=#<a> #<a>:=#<b>"},
                    Reading{"#1=#2 #3=#4", "words #1:=#2 #3:=#4"},
                    Reading{"#1=##2 ##3=4", "words #1:=(# #2) (# #3):=4"},
                    Reading{"#1=-5 #2=+6 #3=-#4", "words #1:=(neg 5) #2:=6 #3:=(neg #4)"},
                    Reading{"#1=[2+3]X4", "words X=4 #1:=(+ 2 3)"},
                    Reading{"#1=sin[30]#2=atan[1]/[2]G0", "words G=0 #1:=(SIN 30) #2:=(ATAN 1 2)"},
                    Reading{"#1=2#3=4", "words #1:=2 #3:=4"}, Reading{"/N5#1=2", "N5 /1 words #1:=2"}));

INSTANTIATE_TEST_SUITE_P(Atan, NgcConflicts,
                         testing::Values(Reading{"X[ATAN[1]/[2]]", "words X=(ATAN 1 2)"},
                                         Reading{"XATAN[1]/[2]Y3", "words X=(ATAN 1 2) Y=3"},
                                         Reading{"X[ATAN[1]/[2]/[3]]", "words X=(/ (ATAN 1 2) 3)"},
                                         Reading{"X[8/ATAN[1]/[2]]", "words X=(/ 8 (ATAN 1 2))"},
                                         Reading{"X[2**ATAN[1]/[2]]", "words X=(** 2 (ATAN 1 2))"},
                                         Reading{"X[ATAN[1]/[2]**2]", "words X=(** (ATAN 1 2) 2)"},
                                         Reading{"o1 if [ATAN[1]/[2] GT ATAN[3]/[4]]",
                                                 "if o1 (GT (ATAN 1 2) (ATAN 3 4))"}));

/// A block that fails in all its readings is an error, never an ambiguity.
TEST(Conflicts, BlockWithoutValidReadingIsRejected) {
    for (const char* text :
         {"X5 G4 Y1", "Y1 X5 G4", "P5 M98 G4", "X5 P6 G4 M98", "X1 #1", "X1 #1=2", "P1 # #", "X1 #[1]",
          "X[ATAN[1]/]", "X[ATAN[1]/[2]", "#1 X1", "IF[1]THEN #1", "IF[1]THEN #1=2 X1"}) {
        const Parsed parsed = parse(std::string(text) + "\nX1\n");
        EXPECT_TRUE(parsed.finished) << text;
        ASSERT_EQ(parsed.blocks.size(), 2U) << text;
        EXPECT_EQ(parsed.blocks[0], "bad") << text;
        EXPECT_EQ(parsed.blocks[1], "words X=1:axis") << text;
    }
    for (const char* text : {"X1 #1", "#1", "#1=", "#1=2=3", "#1=#2+3", "X#1=2", "#<a>", "#1=(c)", "#1=X1",
                             "=2", "##=1", "#[1=2", "X1 #1= Y2", "#1=[ATAN[1]/]", "#1=-", "#1=--Y2", "X-"}) {
        const Parsed parsed = parse_ngc(std::string(text) + "\nX1\n");
        EXPECT_TRUE(parsed.finished) << text;
        ASSERT_EQ(parsed.blocks.size(), 2U) << text;
        EXPECT_EQ(parsed.blocks[0], "bad") << text;
        EXPECT_EQ(parsed.blocks[1], "words X=1") << text;
    }
}

}  // namespace
}  // namespace gsim::grammar::conflicts_test
