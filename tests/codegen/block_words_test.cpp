// Combined effect of the words of a block: the code that takes each word, and the order in which the
// controller acts.
#include <gtest/gtest.h>

#include "tests/codegen/translated.h"

namespace gsim::codegen::block_words_test {
namespace {

TEST(BlockWords, ValuesKeepTheirDigits) {
    EXPECT_EQ(lua_of("G01 X500.000 Y-0.5 Z.5 B5. C+007"), "G1{x=500.000, y=-0.5, z=.5, b=5., c=007}");
    EXPECT_EQ(lua_of("F250.000"), "F(250.000)");
}

TEST(BlockWords, CodesAreNormalised) {
    EXPECT_EQ(lua_of("g00"), "G0()");
    EXPECT_EQ(lua_of("G092.1"), "G92_1()");
    EXPECT_EQ(lua_of("M002"), "M2()");
    EXPECT_EQ(lua_of("G4.0 P1"), "G4{p=1}");
    EXPECT_EQ(lua_of("G599"), "G599()");
}

TEST(BlockWords, AxisWordsBelongToCodeOfBlockOrModalMotion) {
    EXPECT_EQ(lua_of("X5"), "move{x=5}");
    EXPECT_EQ(lua_of("U5 V6 W7 A8"), "move{u=5, v=6, w=7, a=8}");
    EXPECT_EQ(lua_of("X5 G0"), "G0{x=5}");
    EXPECT_EQ(lua_of("X1 G92 Y2"), "G92{x=1, y=2}");
    EXPECT_EQ(lua_of("G52 X1"), "G52{x=1}");
    EXPECT_EQ(lua_of("G28 X0"), "G28{x=0}");
    EXPECT_EQ(lua_of("X1 I2"), "move{x=1, i=2}") << "an arc that goes on";
    EXPECT_EQ(lua_of("I2"), "move{i=2}") << "a full circle that goes on";
    EXPECT_EQ(lua_of("G92 G1 X1"), "G92{x=1} G1()") << "G92 takes the axis words, G1 holds from here on";
}

TEST(BlockWords, ArcCodesTakeCentreRadiusOrAngle) {
    EXPECT_EQ(lua_of("G2 X1 Y2 I3 J4"), "G2{x=1, y=2, i=3, j=4}");
    EXPECT_EQ(lua_of("X1 R5 G3"), "G3{x=1, r=5}");
    EXPECT_EQ(lua_of("G3 AR=90 I5"), "G3{ar=90, i=5}");
    EXPECT_EQ(lua_of("CIP X1 Y2 I1=3 J1=4 K1=5"), "CIP{x=1, y=2, i1=3, j1=4, k1=5}");
    EXPECT_EQ(lua_of("G2"), "G2()") << "the bare code selects the motion";
}

TEST(BlockWords, DwellTakesPOrX) {
    EXPECT_EQ(lua_of("X5 F200 G04"), "F(200) G4{x=5}");
    EXPECT_EQ(lua_of("X5 M8 G04"), "M8() G4{x=5}");
    EXPECT_EQ(lua_of("G4 P[#1/2]"), "G4{p=v[1] / 2.0}");
}

TEST(BlockWords, CallAndReturnFollowMoveOfBlock) {
    EXPECT_EQ(lua_of("O2;M98 P0002 L03"), "program(2, function() M98{p=2, l=03}");
    EXPECT_EQ(lua_of("P#1 M98"), "M98{p=v[1]}");
    EXPECT_EQ(lua_of("M99"), "do return (M99()) end");
    EXPECT_EQ(lua_of("O3;X5 M98 P3"), "program(3, function() move{x=5} M98{p=3}")
        << "the move, then the call";
    EXPECT_EQ(lua_of("M99 X5"), "move{x=5} do return (M99()) end") << "the move, then the return";
}

TEST(BlockWords, CodesActInOrderOfController) {
    EXPECT_EQ(lua_of("X1 G1 F100 G90 G21 G17"), "G17() G21() G90() F(100) G1{x=1}");
    EXPECT_EQ(lua_of("M9 X5 G1"), "G1{x=5} M9()") << "the jet goes off behind the move";
    EXPECT_EQ(lua_of("X5 G1 M8"), "M8() G1{x=5}") << "and on before it";
    EXPECT_EQ(lua_of("M10 M8 X5"), "M10() M8() move{x=5}");
    EXPECT_EQ(lua_of("G1 X5 M30 M5 M9"), "G1{x=5} M9() M5() M30()");
    EXPECT_EQ(lua_of("X1 M0"), "move{x=1} M0()") << "a stop comes behind the move";
    EXPECT_EQ(lua_of("M3 S1000 X1"), "S(1000) M3() move{x=1}");
    EXPECT_EQ(lua_of("M6 T5"), "T(5) M6()");
    EXPECT_EQ(lua_of("X1 G55 G0 G91"), "G91() G55() G0{x=1}") << "the frame before the move in it";
    EXPECT_EQ(lua_of("X1 G0 G53"), "G53() G0{x=1}");
    EXPECT_EQ(lua_of("X1 F5 G93"), "G93() F(5) move{x=1}") << "F is understood in the block's own feed mode";
}

TEST(BlockWords, AcceptsCodesOfDifferentGroups) {
    EXPECT_EQ(lua_of("G17 G40 G80 G90 G54 G94 G00"), "G17() G40() G80() G90() G54() G94() G0()");
    EXPECT_EQ(lua_of("D1 H1"), "D(1) H(1)");
}

TEST(BlockWords, WarnsAboutOneShotCodeWithoutMove) {
    const Translated result = translated("G53\nG1 X1\nG9 F5\n");
    EXPECT_TRUE(result.ok);
    EXPECT_EQ(result.messages,
              "1:1: warning: G53 has no effect in a block without a move\n3:1: warning: G9 has no effect in "
              "a block without a move\n");
    EXPECT_EQ(result.code(1), "");
    EXPECT_EQ(result.code(3), "F(5)");
}

TEST(BlockWords, BareCodesBecomeCallsWithoutArguments) {
    EXPECT_EQ(lua_of("G14"), "G14()");
    EXPECT_EQ(lua_of("G14.1"), "G14_1()");
    EXPECT_EQ(lua_of("G40 G49 G80 G23 G69 G67"), "G40() G49() G80() G23() G69() G67()");
}

TEST(BlockWords, CodesTakeTheirWords) {
    EXPECT_EQ(lua_of("G41 D5 X1"), "G41{d=5} move{x=1}");
    EXPECT_EQ(lua_of("D5 G1 G42 X1"), "G42{d=5} G1{x=1}");
    EXPECT_EQ(lua_of("D5 X1"), "D(5) move{x=1}");
    EXPECT_EQ(lua_of("G43 H2 Z1 G0"), "G43{h=2} G0{z=1}");
    EXPECT_EQ(lua_of("G81 X1 Y2 Z-3 R1 L4 F100 G99"), "G99() F(100) G81{x=1, y=2, z=-3, r=1, l=4}");
    EXPECT_EQ(lua_of("X5 L2"), "move{x=5, l=2}") << "a cycle that goes on";
    EXPECT_EQ(lua_of("L2 X5"), "move{l=2, x=5}");
    EXPECT_EQ(lua_of("G10 L2 P1 X5 Y6"), "G10{l=2, p=1, x=5, y=6}");
    EXPECT_EQ(lua_of("G50 S2000"), "G50{s=2000}");
    EXPECT_EQ(lua_of("G33 Z5 F2"), "G33{z=5, f=2}") << "F is the lead";
    EXPECT_EQ(lua_of("G68 X1 Y2 R30"), "G68{x=1, y=2, r=30}");
    EXPECT_EQ(lua_of("G51.1 X0"), "G51_1{x=0}");
    EXPECT_EQ(lua_of("G30 P3 X1"), "G30{p=3, x=1}");
    EXPECT_EQ(lua_of("G22 X1 I5"), "G22{x=1, i=5}");
}

TEST(BlockWords, MacroCallsPassWordsAsArguments) {
    EXPECT_EQ(lua_of("G65 P9010 A1 B2 X3"), "G65{p=9010, a=1, b=2, x=3}");
    EXPECT_EQ(lua_of("G65 P1 F5 S6 T7 D8 H9"), "G65{p=1, f=5, s=6, t=7, d=8, h=9}") << "arguments, not F(5)";
    EXPECT_EQ(lua_of("G65 P1 I1 J2 K3 I4 J5"),
              "G65{p=1, {\"i\", 1}, {\"j\", 2}, {\"k\", 3}, {\"i\", 4}, {\"j\", 5}}")
        << "in their order";
    EXPECT_EQ(lua_of("G65 P1 I1 J2 A5"), "G65{p=1, i=1, j=2, a=5}");
    EXPECT_EQ(lua_of("G66 P1 L2 X5"), "G66{p=1, l=2, x=5}");
    EXPECT_EQ(lua_of("G66.1 P1 I[#1] I#2"), "G66_1{p=1, {\"i\", v[1]}, {\"i\", v[2]}}");
    EXPECT_EQ(lua_of("G67"), "G67()");
}

TEST(BlockWords, UserCodesLeaveAxisWordsToMove) {
    EXPECT_EQ(lua_of("M101"), "M[101]()");
    EXPECT_EQ(lua_of("M999 P1 Q[#1] D5"), "M[999]{p=1, q=v[1], d=5}");
    EXPECT_EQ(lua_of("X5 M101 P1"), "M[101]{p=1} move{x=5}") << "axis words are the move's";
    EXPECT_EQ(lua_of("M0100"), "M[100]()");
}

TEST(BlockWords, CornerWordsPrecedeMove) {
    EXPECT_EQ(lua_of("G1 X10 ,R2"), "corner(2) G1{x=10}");
    EXPECT_EQ(lua_of(",C1.5 X10 F5"), "F(5) chamfer(1.5) move{x=10}");
    EXPECT_EQ(lua_of("X10 ,A30 ,C[#1]"), "line_angle(30) chamfer(v[1]) move{x=10}");
    EXPECT_EQ(lua_of(",A30"), "line_angle(30) move()") << "the next block tells where the line ends";
    EXPECT_EQ(lua_of("G1 ,A-45"), "line_angle(-45) G1()");
    EXPECT_EQ(lua_of("G2 X1 R5 ,C2"), "chamfer(2) G2{x=1, r=5}");
    EXPECT_EQ(lua_of("CIP X1 I1=5 ,R2"), "corner(2) CIP{x=1, i1=5}");
    EXPECT_EQ(lua_of("/3 X1 ,C2"), "if not skipped(3) then chamfer(2) move{x=1} end");
}

TEST(BlockWords, BlockDeleteMakesBlockConditional) {
    EXPECT_EQ(lua_of("/X5"), "if not skipped(1) then move{x=5} end");
    EXPECT_EQ(lua_of("/3 #1=5"), "if not skipped(3) then v[1] = 5.0 end");
    EXPECT_EQ(lua_of("/2 M99"), "if not skipped(2) then do return (M99()) end end");
    EXPECT_EQ(lua_of("N5 /GOTO5"),
              "::N5:: if not skipped(1) then if last_pass(5) then return end goto N5 end")
        << "the label stands before it";
    EXPECT_EQ(lua_of("/"), "");
}

TEST(BlockWords, AliasesReplaceCodes) {
    TranslateOptions options;
    ASSERT_FALSE(options.aliases.add("WaterJetOn", "M08"));
    ASSERT_FALSE(options.aliases.add("Linear", "G01"));
    EXPECT_EQ(translated("X5 Linear waterjeton\n", options).code(1), "M8() G1{x=5}");
    EXPECT_EQ(translated("WaterJetOf\n", options).messages,
              "1:1: error: 'WaterJetOf' is neither a keyword nor an alias of the machine data; did you mean "
              "WATERJETON?\n");
}

}  // namespace
}  // namespace gsim::codegen::block_words_test
