#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::parser_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string block(const std::string& text) {
    const Parsed parsed = parse(text + "\n");
    EXPECT_EQ(parsed.messages, "") << text;
    return parsed.blocks.size() == 1 ? parsed.blocks[0] : "not one block";
}

TEST(Roles, XIsAxisOrDwellTime) {
    EXPECT_EQ(block("X5 F200"), "words X=5:axis F=200");
    EXPECT_EQ(block("X5 F200 G04"), "words X=5:time F=200 G=04");
    EXPECT_EQ(block("X5 G04"), "words X=5:time G=04");
    EXPECT_EQ(block("G04 X5"), "words G=04 X=5:time");
    EXPECT_EQ(block("X5 M8 G04"), "words X=5:time M=8 G=04");
    EXPECT_EQ(block("M8 F1 G4.0 S5 X5"), "words M=8 F=1 G=4.0 S=5 X=5:time");
    EXPECT_EQ(block("X5 Y6"), "words X=5:axis Y=6");
    EXPECT_EQ(block("X5 G1"), "words X=5:axis G=1");
    EXPECT_EQ(block("U5"), "words U=5:axis");
    EXPECT_EQ(block("U5 M9 G4"), "words U=5:time M=9 G=4");
}

TEST(Roles, PIsTimeProgramOrParameter) {
    EXPECT_EQ(block("P5 G4"), "words P=5:time G=4");
    EXPECT_EQ(block("P2 M98"), "words P=2:program M=98");
    EXPECT_EQ(block("M98 P2 L3"), "words M=98 P=2:program L=3");
    EXPECT_EQ(block("L3 P2 F5 M98"), "words L=3 P=2:program F=5 M=98");
    EXPECT_EQ(block("M99 P30"), "words M=99 P=30:program");
    EXPECT_EQ(block("G30 P2 X0"), "words G=30 P=2:parameter X=0:axis");
    EXPECT_EQ(block("X0 P2 G30"), "words X=0:axis P=2:parameter G=30");
}

TEST(Roles, SubprogramCallMayMoveAxes) {
    EXPECT_EQ(block("X5 P2 M98"), "words X=5:axis P=2:program M=98");
    EXPECT_EQ(block("P2 X5 U1 M98 Y1"), "words P=2:program X=5:axis U=1:axis M=98 Y=1");
    EXPECT_EQ(block("X5 M99"), "words X=5:axis M=99");
}

TEST(Roles, ValueMayBeExpression) {
    EXPECT_EQ(block("X#1 G04"), "words X=#1:time G=04");
    EXPECT_EQ(block("X[1+2] F#3"), "words X=(+ 1 2):axis F=#3");
    EXPECT_EQ(block("P[#1*2] M98"), "words P=(* #1 2):program M=98");
    EXPECT_EQ(block("X-[1] Y+#2 Z-#[3]"), "words X=(neg 1):axis Y=#2 Z=(neg (# 3))");
    EXPECT_EQ(block("AR=[5] I1=#2"), "words AR==5 I1==#2");
}

TEST(Blocks, AcceptPrefixes) {
    EXPECT_EQ(block("/N0010 G0"), "N10 /1 words G=0");
    EXPECT_EQ(block("N10 /3 G0"), "N10 /3 words G=0");
    EXPECT_EQ(block("O0001 G0"), "O0001 words G=0");
    EXPECT_EQ(block("N5 OPART"), "OPART N5 words");
    EXPECT_EQ(block("N5"), "N5 words");
    EXPECT_EQ(block("(only a comment)"), "words");
}

TEST(Blocks, AcceptAssignments) {
    EXPECT_EQ(block("#1=5"), "assign #1:=5");
    EXPECT_EQ(block("#1=5 #2=#1+1"), "assign #1:=5 #2:=(+ #1 1)");
    EXPECT_EQ(block("#1=5,#2=6"), "assign #1:=5 #2:=6");
    EXPECT_EQ(block("##1=5"), "assign (# #1):=5");
    EXPECT_EQ(block("#[#1+2]=-5"), "assign (# (+ #1 2)):=(neg 5)");
    EXPECT_EQ(block("N7 #1=5"), "N7 assign #1:=5");
}

TEST(Blocks, AcceptControlStructures) {
    EXPECT_EQ(block("IF[#1 EQ 5]GOTO100"), "if (EQ #1 5) goto 100");
    EXPECT_EQ(block("if [#1 GT 5] goto [#2+10]"), "if (GT #1 5) goto (+ #2 10)");
    EXPECT_EQ(block("IF[#1 NE 5]THEN #2=3"), "if (NE #1 5) then #2:=3");
    EXPECT_EQ(block("IF[#1 LE 5]THEN G1 X5"), "if (LE #1 5) then G=1 X=5:axis");
    EXPECT_EQ(block("IF[#1 LE 5]THEN X5 G4"), "if (LE #1 5) then X=5:time G=4");
    EXPECT_EQ(block("WHILE[#1 LT 5]DO2"), "while (LT #1 5) do 2");
    EXPECT_EQ(block("END3"), "end 3");
    EXPECT_EQ(block("GOTO 10"), "goto 10");
    EXPECT_EQ(block("GOTO#1"), "goto #1");
    EXPECT_EQ(block("/2 IF[#1]GOTO5"), "/2 if #1 goto 5");
}

TEST(Blocks, AcceptWordsOf9Series) {
    EXPECT_EQ(block("G1 X1 ,C5 ,R[#1] ,A-30"), "words G=1 X=1:axis ,C=5 ,R=#1 ,A=-30");
    EXPECT_EQ(block(",A30"), "words ,A=30");
    EXPECT_EQ(block("G65 P1 I1 J2 K3 I4 X5"), "words G=65 P=1:parameter I=1 J=2 K=3 I=4 X=5:axis");
    EXPECT_EQ(block("X5 G65 P1"), "words X=5:axis G=65 P=1:parameter");
    EXPECT_EQ(block("POPEN"), "print 0 ");
    EXPECT_EQ(block("N5 /3 dprnt[X#1[53]]"), "N5 /3 print 2 X#1[53]");
    EXPECT_EQ(block("PCLOS (c)"), "print 1 ");
    EXPECT_EQ(parse("X1 POPEN\n").messages,
              "1:4: error: POPEN, PCLOS and DPRNT[..] must be in a separate block\n");
    EXPECT_EQ(parse("POPEN X1\n").messages, "1:7: error: X is not allowed here\n");
}

TEST(Blocks, EndAtLineEndOrSemicolon) {
    EXPECT_THAT(parse("%\nO1\nG0 X1;Y2\n\nM2\n%\n").blocks,
                ElementsAre("tape", "words", "O1 words", "words G=0 X=1:axis", "words Y=2", "words",
                            "words M=2", "tape", "words"));
    EXPECT_THAT(parse("").blocks, IsEmpty());
    EXPECT_TRUE(parse("").finished);
}

}  // namespace
}  // namespace gsim::grammar::parser_test
