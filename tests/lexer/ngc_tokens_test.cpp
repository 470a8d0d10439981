// RS274/NGC: blanks and case are ignored, letters never join to names outside of expressions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lexer/scan.h"

namespace gsim::lexer::ngc_tokens_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(NgcTokens, IgnoreBlanksAndCase) {
    for (const char* text : {"G0X12.5Y-3\n", "g0x12.5y-3\n", "G 0 X 1 2 . 5 Y - 3\n",
                             "G\t0 X1 2. 5y\t-\t3\r\n", "g0 X1 2 .5 Y- 3", "G0X12.5 Y-3  "}) {
        const Scan result = scan_ngc(text);
        EXPECT_THAT(result.words, ElementsAre("G=0", "X=12.5", "Y=-3")) << text;
        EXPECT_THAT(result.tokens, ElementsAre(kOther, kAxis, kAxis, kEob)) << text;
        EXPECT_EQ(result.messages, "") << text;
    }
}

TEST(NgcTokens, ReadEveryNumberFormat) {
    EXPECT_THAT(scan_ngc("X.5 Y5. Z+5 A007 B-. 5 C+ 5. I0 J-0\n").words,
                ElementsAre("X=.5", "Y=5.", "Z=5", "A=007", "B=-.5", "C=5.", "I=0", "J=-0"));
    EXPECT_THAT(scan_ngc("G 9 2 . 1 G5 9.3\n").words, ElementsAre("G=92.1", "G=59.3"));
    EXPECT_THAT(scan_ngc("X1 . Y2\n").words, ElementsAre("X=1.", "Y=2")) << "the point belongs to the number";
    EXPECT_THAT(scan_ngc("X1.5.5\n").tokens, ElementsAre(kAxis, kNumber, kEob)) << "one point in a number";
    EXPECT_THAT(scan_ngc("X1 (c) 2\n").tokens, ElementsAre(kAxis, kNumber, kEob)) << "a comment ends it";
    EXPECT_THAT(scan_ngc("X1E5\n").words, ElementsAre("X=1", "E=5")) << "no exponents";
    const std::string digits = "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1";
    EXPECT_EQ(scan_ngc("X" + digits + "\n").messages, "") << "24 digits, blanks do not count";
    EXPECT_EQ(scan_ngc("X" + digits + " 1\n").messages,
              "1:1: error: the number has 25 characters, at most 24 are allowed\n");
}

TEST(NgcTokens, LettersNeverJoinToNames) {
    EXPECT_THAT(scan_ngc("IFX1\n").tokens, ElementsAre(kOtherLetter, kOtherLetter, kAxis, kEob));
    EXPECT_THAT(scan_ngc("AR=5\n").tokens, ElementsAre(kAxisLetter, kOtherLetter, kSet, kNumber, kEob));
    EXPECT_THAT(scan_ngc("I1=5\n").tokens, ElementsAre(kOther, kSet, kNumber, kEob));
    EXPECT_THAT(scan_ngc("X1 U1 P1 G4 M98 M99\n").tokens,
                ElementsAre(kAxis, kAxis, kOther, kOther, kOther, kOther, kEob))
        << "X, U and P have one meaning";
    EXPECT_THAT(scan_ngc("@ 5 ^-3 0 $1\n").words, ElementsAre("@=5", "^=-30", "$=1"));
    EXPECT_THAT(scan_ngc("@5 ^30 $1\n").tokens, ElementsAre(kAxis, kAxis, kOther, kEob));
    EXPECT_EQ(scan_ngc("X1 ,C5\n").messages, "1:4: error: unexpected character ','\n");
}

TEST(NgcTokens, FunctionMayFollowLetter) {
    EXPECT_THAT(scan_ngc("XSIN[1]\n").tokens, ElementsAre(kAxisLetter, kFunction, '[', kNumber, ']', kEob));
    EXPECT_THAT(scan_ngc("A abs [#1] Y atan[1]/[2]\n").tokens,
                ElementsAre(kAxisLetter, kFunction, '[', kVariable, ']', kAxisLetter, kAtan, '[', kNumber,
                            ']', '/', '[', kNumber, ']', kEob))
        << "'/' is block delete at the start only";
    EXPECT_THAT(scan_ngc("#1=exists[#<a>]\n").tokens,
                ElementsAre(kVariable, kSet, kExists, '[', kNamedVariable, ']', kEob));
}

TEST(NgcTokens, ReadOperatorsOfExpressions) {
    EXPECT_THAT(scan_ngc("X[1 eq 2 and 3**4 Mod 5]\n").tokens,
                ElementsAre(kAxisLetter, '[', kNumber, kComparison, kNumber, kLogicWord, kNumber, kPower,
                            kNumber, kProductWord, kNumber, ']', kEob));
    const Scan near = scan_ngc("X[1 EQ 2 NE 3]\n");
    EXPECT_EQ(near.values[3].index, static_cast<std::uint32_t>(Operator::near_equal));
    EXPECT_EQ(near.values[5].index, static_cast<std::uint32_t>(Operator::not_near_equal));
    EXPECT_EQ(scan_ngc("X[BCD[1]]\n").messages,
              "1:3: error: 'BCD' is not a function or operator of an expression\n");
    EXPECT_THAT(scan_ngc("X[1]Y2\n").tokens, ElementsAre(kAxisLetter, '[', kNumber, ']', kAxis, kEob))
        << "behind the bracket words go on";
}

TEST(NgcTokens, NormalizeAndLimitParameterNames) {
    const Scan result = scan_ngc("#<Width>=1 # < _The GLOBAL\tone > = 2 X#<a-b.c>\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.names, ElementsAre("width", "_theglobalone", "a-b.c"));
    EXPECT_EQ(scan_ngc("#< >=1\n").messages, "1:1: error: the name of a parameter is empty\n");
    const std::string max_length(100, 'n');
    EXPECT_EQ(scan_ngc("#<" + max_length + ">=1\n").messages, "");
    for (const std::string& text :
         {"#<" + max_length + "n>=1\n", std::string("#<a=1\n"), "X[#<" + max_length + "n>]\n"}) {
        EXPECT_THAT(scan_ngc(text).messages,
                    testing::HasSubstr("error: the name has no '>' after it, or more than 100 characters\n"))
            << text;
    }
}

TEST(NgcTokens, ReadOWordsWithNamesAndKeywords) {
    const Scan result = scan_ngc("o100 sub\nO 0 1 0 0 Call [1] [2]\nO<My Sub> CALL\nN10 o<1b>return [1]\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.tokens, ElementsAre(kFlowName, kFlow, kEob, kFlowName, kFlow, '[', kNumber, ']', '[',
                                           kNumber, ']', kEob, kFlowName, kFlow, kEob, kSequence, kFlowName,
                                           kFlow, '[', kNumber, ']', kEob));
    EXPECT_THAT(result.programs, ElementsAre("100", "100", "mysub", "1b"))
        << "zeros before a number mean nothing";
    EXPECT_THAT(scan_ngc("O[#1+1] call\nO#2 call\n").tokens,
                ElementsAre(kFlowLetter, '[', kVariable, '+', kNumber, ']', kFlow, kEob, kFlowLetter,
                            kVariable, kFlow, kEob));
    EXPECT_THAT(scan_ngc("o000\n").programs, ElementsAre("0"));
}

TEST(NgcTokens, RejectInvalidOWords) {
    EXPECT_EQ(scan_ngc("o1 cal [1]\n").messages,
              "1:4: error: 'cal' is not a keyword after an O-word; did you mean CALL?\n");
    EXPECT_EQ(scan_ngc("o1 goto\n").messages, "1:4: error: 'goto' is not a keyword after an O-word\n");
    EXPECT_EQ(scan_ngc("o<> call\n").messages, "1:1: error: the name of an O-word is empty\n");
    EXPECT_EQ(scan_ngc("o<" + std::string(101, 'n') + "> call\n").messages,
              "1:1: error: the name has no '>' after it, or more than 100 characters\n");
    EXPECT_EQ(scan_ngc("o<a call\n").messages,
              "1:1: error: the name has no '>' after it, or more than 100 characters\n");
    EXPECT_THAT(scan_ngc("OPART\n").tokens,
                ElementsAre(kOtherLetter, kOtherLetter, kAxisLetter, kOtherLetter, kOtherLetter, kEob))
        << "no names without < >";
}

TEST(NgcTokens, KeepRemarksAndComments) {
    const Scan result = scan_ngc("G0 X1 ;G1 Y2 (no) % \r\n(one)Y2(two);three\n;\n#1=2;four\no1 call;five");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.words, ElementsAre("G=0", "X=1", "Y=2"));
    EXPECT_THAT(result.comments, ElementsAre("G1 Y2 (no) % ", "one", "two", "three", "four", "five"));
    EXPECT_EQ(scan_ngc("X1 (open\nY2\n").messages, "1:9: error: the comment has no ')' on its line\n");
    EXPECT_EQ(
        scan_ngc("X1 ) 2\n").messages,
        "1:4: error: ')' without '('; a comment ends at its first ')', even if it contains another '('\n");
    EXPECT_THAT(scan_ngc("X[1(c)+2] Y3\n").words, ElementsAre("X=", "Y=3")) << "in an expression too";
}

TEST(NgcTokens, IgnoreTextAfterSecondTapeMark) {
    const Scan result = scan_ngc("%\nG0 X1\n%\nnothing @@@ (\no1 sub\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.tokens, ElementsAre(kTape, kEob, kOther, kAxis, kEob, kTape));
    EXPECT_THAT(scan_ngc("G0 X1\n%\nX2\n").words, ElementsAre("G=0", "X=1", "X=2"))
        << "the first one may begin the tape";
    EXPECT_EQ(scan_ngc("X1 %\n").messages, "1:4: error: a tape mark % must be at the start of a line\n");
    EXPECT_THAT(scan("%\nX1\n%\nX2\n").words, ElementsAre("X=1", "X=2")) << "9/Series: further programs";
}

TEST(NgcTokens, SkipLinesAfterM2UntilOWord) {
    const Scan result = scan_ngc(
        "X1\nM2\nthis is no code ((\nX2 @\n  \r\n O 100 sub\nX3\no100 endsub\nX4\nm30\nX5 o1 call\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.words, ElementsAre("X=1", "M=2", "X=3", "X=4", "M=30"));
    EXPECT_THAT(result.programs, ElementsAre("100", "100"));
    for (const char* text : {"M2\n(c) o1 sub\n", "M2\n;o1 sub\n", "M2\nG0 o1 sub\n", "M2\n/o1 sub"})
        EXPECT_THAT(scan_ngc(text).programs, IsEmpty()) << text;
    for (const char* text : {"M2\no1 sub\n", "M2\n\to<1>sub", "M2\nN 1 0 O1 sub\n", "M2\r\nn5o1sub\r\n"})
        EXPECT_THAT(scan_ngc(text).programs, ElementsAre("1")) << text;
    EXPECT_THAT(scan_ngc("%\nM2\nX1\n%\no1 sub\n").tokens,
                ElementsAre(kTape, kEob, kOther, kEob, kEob, kTape))
        << "the tape's end is seen there too";
    EXPECT_THAT(scan_ngc("M2\nX1\n\nX2").tokens, ElementsAre(kOther, kEob, kEob, kEob, kEob))
        << "its lines still count";
    EXPECT_THAT(scan("M2\nX1\n").words, ElementsAre("M=2", "X=1")) << "not so in the 9/Series";
}

TEST(NgcTokens, ReportUnexpectedBytes) {
    EXPECT_EQ(scan_ngc(std::string_view("X1\0Y2\n", 6)).messages, "1:3: error: unexpected byte 0x00\n");
    EXPECT_EQ(scan_ngc(std::string_view("X[1\0]\n", 6)).messages, "1:4: error: unexpected byte 0x00\n");
    EXPECT_EQ(scan_ngc(std::string_view("#<a\0b>=1\n", 9)).messages, "");
    EXPECT_EQ(scan_ngc(std::string_view("M2\nX\0\0\n(\0\nX1\n", 13)).messages, "") << "where nothing is read";
    EXPECT_EQ(scan_ngc(std::string_view("(\0)X1\n", 6)).comments, std::vector(1, std::string(1, '\0')));
    EXPECT_EQ(scan_ngc("X1 \xc3\xa4 ?\nX2 !\n").messages,
              "1:4: error: unexpected byte 0xC3\n2:4: error: unexpected character '!'\n");
}

TEST(NgcTokens, ReadSequenceNumbersAndBlockDelete) {
    const Scan result = scan_ngc("/N 1 0 G0\nn10.5 G1\n/ 3\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.tokens,
                ElementsAre(kSkip, kSequence, kOther, kEob, kSequence, kOther, kEob, kSkip, kEob));
    EXPECT_EQ(result.values[1].index, 10U);
    EXPECT_EQ(result.values[4].index, 10U);
    EXPECT_EQ(result.values[7].index, 3U);
}

}  // namespace
}  // namespace gsim::lexer::ngc_tokens_test
