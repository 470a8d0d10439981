#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lexer/scan.h"

namespace gsim::lexer::tokens_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Tokens, WordsIgnoreBlanksAndCase) {
    for (const char* text :
         {"G01X5Y-2\n", "g01x5y-2\n", "G 01 X 5 Y - 2\n", "\tG01\tX5  Y-2  \n", "g01 X5y -2"}) {
        const Scan result = scan(text);
        EXPECT_THAT(result.words, ElementsAre("G=01", "X=5", "Y=-2")) << text;
        EXPECT_THAT(result.tokens, ElementsAre(kOther, kAxisOrTime, kAxis, kEob)) << text;
        EXPECT_EQ(result.messages, "") << text;
    }
}

TEST(Tokens, ReadEveryNumberFormat) {
    EXPECT_THAT(scan("X.5 Y5. Z+5 A007 B-.5 C+5. I0 J-0\n").words,
                ElementsAre("X=.5", "Y=5.", "Z=5", "A=007", "B=-.5", "C=5.", "I=0", "J=-0"));
    EXPECT_EQ(scan("X.\n").words.size(), 1U) << "a dot alone is no number: X is left without a value";
    EXPECT_THAT(scan("X1.2.3\n").words, ElementsAre("X=1.2"));
}

TEST(Tokens, BlockEndsAtLineEndOrSemicolon) {
    EXPECT_THAT(scan("X1\r\nY2\r\n").tokens, ElementsAre(kAxisOrTime, kEob, kAxis, kEob));
    EXPECT_THAT(scan("X1\nY2").tokens, ElementsAre(kAxisOrTime, kEob, kAxis, kEob));
    EXPECT_THAT(scan("X1;Y2;\n").tokens, ElementsAre(kAxisOrTime, kEob, kAxis, kEob, kEob));
    EXPECT_THAT(scan("\n\n").tokens, ElementsAre(kEob, kEob));
    EXPECT_THAT(scan("").tokens, IsEmpty());
    EXPECT_THAT(scan("X1\rY2\n").tokens, ElementsAre(kAxisOrTime, kAxis, kEob)) << "a lone CR is a blank";
}

TEST(Tokens, ReadTapeMarkBlockDeleteAndSequenceNumber) {
    EXPECT_THAT(scan("%\n/N10 G0\n").tokens, ElementsAre(kTape, kEob, kSkip, kSequence, kOther, kEob));
    const Scan levels = scan("/ N0010\n/9 n7\n");
    EXPECT_THAT(levels.tokens, ElementsAre(kSkip, kSequence, kEob, kSkip, kSequence, kEob));
    EXPECT_EQ(levels.values[0].index, 1U);
    EXPECT_EQ(levels.values[1].index, 10U);
    EXPECT_EQ(levels.values[3].index, 9U);
    EXPECT_EQ(scan("X1 %\n").messages, "1:4: error: a tape mark % must be at the start of a line\n");
    EXPECT_EQ(scan("/0 X1\n").messages, "1:1: error: block delete must be / or /1 to /9, not /0\n");
    EXPECT_EQ(scan("/10 X1\n").messages, "1:1: error: block delete must be / or /1 to /9, not /10\n");
}

TEST(Tokens, ReadProgramNumbersAndNames) {
    EXPECT_THAT(scan("O12345\nO 7\n:3\no0001\n").programs, ElementsAre("12345", "7", "3", "0001"));
    EXPECT_THAT(scan("OPART\nOWheel_2\nO12AB-3_x\nO-2\n").programs,
                ElementsAre("PART", "Wheel_2", "12AB-3_x"));
    EXPECT_THAT(scan("O1 G1 X5\n").words, ElementsAre("G=1", "X=5")) << "words may follow the name";
    EXPECT_EQ(scan("O123456789012345678901234567890123\n").messages,
              "1:2: error: the program name has more than 32 characters\n");
}

TEST(Tokens, CommentsAreKeptAndHideTheirContent) {
    const Scan result = scan("(G1 X9 ; N5 %) X1 ( two )Y2()\n");
    EXPECT_THAT(result.words, ElementsAre("X=1", "Y=2"));
    EXPECT_THAT(result.comments, ElementsAre("G1 X9 ; N5 %", " two ", ""));
    EXPECT_THAT(scan("#1=[2(of two)+3]\n").comments, ElementsAre("of two")) << "in an expression too";
    EXPECT_EQ(scan("X1 (open\nY2\n").messages, "1:9: error: the comment has no ')' on its line\n");
    EXPECT_THAT(scan("X1 (open\nY2\n").words, ElementsAre("X=1", "Y=2")) << "the next block is read";
}

TEST(Tokens, ReadMultiCharacterAddresses) {
    EXPECT_THAT(scan("CIP X1 I1=5 j1 = -6 K1=.5\n").words,
                ElementsAre("CIP=", "X=1", "I1==5", "J1==-6", "K1==.5"));
    EXPECT_THAT(scan("G2 AR=90 ar = 45.\n").words, ElementsAre("G=2", "AR==90", "AR==45."));
    EXPECT_THAT(scan("I1 J1\n").words, ElementsAre("I=1", "J=1")) << "without '=' they are ordinary words";
}

TEST(Tokens, ReadCornerWords) {
    EXPECT_THAT(scan("X1 ,C5,R.5 , a - 30\n").words, ElementsAre("X=1", ",C=5", ",R=.5", ",A=-30"));
    EXPECT_THAT(scan("X1 ,C#5 ,R[1]\n").tokens,
                ElementsAre(kAxisOrTime, kOtherLetter, kVariable, kOtherLetter, '[', kNumber, ']', kEob));
    EXPECT_EQ(scan("X1 ,B5\n").messages, "1:4: error: unexpected character ','\n");
    EXPECT_EQ(scan("X1 ,\n").messages, "1:4: error: unexpected character ','\n");
    EXPECT_THAT(scan("C5 R6 A7\n").words, ElementsAre("C=5", "R=6", "A=7")) << "without a comma";
}

TEST(Tokens, ReadPrintStatements) {
    const Scan result = scan("POPEN\ndprnt [X#1[53]*Y#[2]] (a [note])\nPclos\n");
    EXPECT_EQ(result.messages, "");
    EXPECT_THAT(result.tokens, ElementsAre(kPrint, kEob, kPrint, kEob, kPrint, kEob));
    EXPECT_THAT(result.printed, ElementsAre("", "X#1[53]*Y#[2]", ""));
    EXPECT_THAT(result.comments, ElementsAre("a [note]")) << "is no part of what is printed";
    EXPECT_EQ(result.values[0].index, static_cast<std::uint32_t>(Print::open));
    EXPECT_EQ(result.values[4].index, static_cast<std::uint32_t>(Print::close));
    EXPECT_THAT(scan("X1;POPEN;DPRNT[A];PCLOS\n").tokens,
                ElementsAre(kAxisOrTime, kEob, kPrint, kEob, kPrint, kEob, kPrint, kEob))
        << "behind ';' they are no remark";
    for (const char* text : {"DPRNT\n", "DPRNT X\n", "DPRNT[A\n", "DPRNT[A[B]\n"}) {
        EXPECT_EQ(scan(text).messages,
                  "1:1: error: DPRNT requires its text in brackets, as in DPRNT[X#100[53]]\n")
            << text;
    }
    EXPECT_EQ(scan("DPRNT[" + std::string(400, 'A') + "]\n").messages, "");
    EXPECT_EQ(scan("DPRNT[" + std::string(60000, 'A') + "]\n").messages,
              "1:1: error: DPRNT accepts at most 400 characters\n");
}

TEST(Tokens, RejectSyntaxOfRs274Ngc) {
    EXPECT_EQ(scan("#1=2**3\n").messages,
              "1:5: error: '**' is not an operator of the 9/Series; use EXP[#2*LN[#1]] for a power, or a "
              "product\n");
    EXPECT_EQ(scan("X[#<a>]\n").messages, "1:3: error: unexpected character '<'\n");
    EXPECT_EQ(scan("X#<a>\n").messages, "1:3: error: unexpected character '<'\n");
    EXPECT_EQ(scan("#1=#<\n").messages, "1:4: error: unexpected character '<'\n");
    EXPECT_EQ(scan("#1=EXISTS[#2]\n").messages,
              "1:4: error: 'EXISTS' is not a function or operator of an expression\n");
    EXPECT_EQ(scan("@5\n").messages, "1:1: error: unexpected character '@'\n");
    EXPECT_EQ(scan("$1\n").messages, "1:1: error: unexpected character '$'\n");
}

TEST(Tokens, ClassifyWords) {
    EXPECT_THAT(
        scan("X1 U1 P1 A1 B1 C1 V1 W1 Y1 Z1\n").tokens,
        ElementsAre(kAxisOrTime, kAxisOrTime, kP, kAxis, kAxis, kAxis, kAxis, kAxis, kAxis, kAxis, kEob));
    EXPECT_THAT(scan("G04 G4.0 G4.1 M98 M099 M9 G98\n").tokens,
                ElementsAre(kDwell, kDwell, kOther, kCall, kCall, kOther, kOther, kEob));
    EXPECT_THAT(scan("X#1 P[1] F#2 Y-#3\n").tokens,
                ElementsAre(kAxisOrTimeLetter, kVariable, kPLetter, '[', kNumber, ']', kOtherLetter,
                            kVariable, kAxisLetter, '-', kVariable, kEob));
}

TEST(Tokens, ReadKeywords) {
    EXPECT_THAT(scan("if[#1 eq 5]goto100\n").tokens,
                ElementsAre(kIf, '[', kVariable, kRelation, kNumber, ']', kGoto, kNumber, kEob));
    EXPECT_THAT(scan("WHILE [#1LT5] DO1\nEND1\n").tokens,
                ElementsAre(kWhile, '[', kVariable, kRelation, kNumber, ']', kDo, kNumber, kEob, kEndLoop,
                            kNumber, kEob));
    EXPECT_THAT(scan("IF[1]THEN#1=2\n").tokens,
                ElementsAre(kIf, '[', kNumber, ']', kThen, kVariable, '=', kNumber, kEob));
}

TEST(Tokens, ReadFunctionsAndOperators) {
    const Scan result = scan("#1=SIN[1]+atan[2]/[3] MOD 4 or 5\n");
    EXPECT_THAT(result.tokens,
                ElementsAre(kVariable, '=', kFunction, '[', kNumber, ']', '+', kAtan, '[', kNumber, ']', '/',
                            '[', kNumber, ']', kProductWord, kNumber, kSumWord, kNumber, kEob));
    EXPECT_EQ(result.values[2].index, static_cast<std::uint32_t>(Operator::sin));
    EXPECT_EQ(result.values[15].index, static_cast<std::uint32_t>(Operator::modulo));
    EXPECT_EQ(scan("#1=SINN[1]\n").messages,
              "1:4: error: 'SINN' is not a function or operator of an expression; did you mean SIN?\n");
    EXPECT_EQ(scan("#1=5 X1\n").messages,
              "1:6: error: the word X is in the same block as an assignment; move it to a separate block\n");
}

}  // namespace
}  // namespace gsim::lexer::tokens_test
