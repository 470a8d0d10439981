// Every diagnostic about the words of one block, word for word.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/translated.h"

namespace gsim::codegen {
namespace {

struct Wrong {
    const char* block;
    const char* message;  ///< Behind "1:".
};

class BlockErrors : public testing::TestWithParam<Wrong> {};

TEST_P(BlockErrors, WordForWord) {
    const Translated result = translated(fmt::format("{}\nG1 X1\n", GetParam().block));
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.lua, "");
    EXPECT_EQ(result.messages, fmt::format("1:{}\n", GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Groups, BlockErrors,
    testing::Values(
        Wrong{"G0 G1 X5", "4: error: G0 and G1 are of one modal group (motion); a block takes one of them"},
        Wrong{"G1 X5 G02 I1",
              "7: error: G1 and G2 are of one modal group (motion); a block takes one of them"},
        Wrong{"G17 G18", "5: error: G17 and G18 are of one modal group (plane); a block takes one of them"},
        Wrong{"G20 G21", "5: error: G20 and G21 are of one modal group (units); a block takes one of them"},
        Wrong{"G90 G91",
              "5: error: G90 and G91 are of one modal group (distance mode); a block takes one of them"},
        Wrong{"G93 G94",
              "5: error: G93 and G94 are of one modal group (feed mode); a block takes one of them"},
        Wrong{"G54 G505",
              "5: error: G54 and G505 are of one modal group (work coordinate system); a block takes one of "
              "them"},
        Wrong{"G61 G64",
              "5: error: G61 and G64 are of one modal group (path mode); a block takes one of them"},
        Wrong{"G15 G16",
              "5: error: G15 and G16 are of one modal group (polar programming); a block takes one of them"},
        Wrong{"M8 M9", "4: error: M8 and M9 are of one modal group (jet); a block takes one of them"},
        Wrong{"M10 M11",
              "5: error: M10 and M11 are of one modal group (abrasive); a block takes one of them"},
        Wrong{"M3 M5", "4: error: M3 and M5 are of one modal group (spindle); a block takes one of them"},
        Wrong{"M2 M30",
              "4: error: M2 and M30 are of one modal group (program stop); a block takes one of them"},
        Wrong{"G1 CIP X1 I1=5", "4: error: CIP stands with another motion code; a block takes one of them"},
        Wrong{"CIP X1 I1=5 G1",
              "13: error: CIP and G1 are of one modal group (motion); a block takes one of them"},
        Wrong{"CIP CIP", "5: error: CIP stands with another motion code; a block takes one of them"},
        Wrong{"G1 X5 G01", "7: error: G1 stands twice in the block"},
        Wrong{"G28 G92 X1", "5: error: G28 and G92 both take the axis words of the block"}));

INSTANTIATE_TEST_SUITE_P(
    Words, BlockErrors,
    testing::Values(
        Wrong{"X1 X2", "4: error: X stands twice in the block"},
        Wrong{"G1 X1 F5 F6", "10: error: F stands twice in the block"},
        Wrong{"G2 X1 I5 I6", "10: error: I stands twice in the block"},
        Wrong{"G2 X1 AR=5 AR=6", "12: error: AR= stands twice in the block"},
        Wrong{"G92", "1: error: G92 needs the axis words whose coordinates it sets"},
        Wrong{"G52", "1: error: G52 needs the axis words whose coordinates it sets"},
        Wrong{"G2 X1",
              "1: error: G2 needs the centre (I, J, K), the radius (R) or the angle (AR=) of the arc"},
        Wrong{"G03 X1 F5",
              "1: error: G3 needs the centre (I, J, K), the radius (R) or the angle (AR=) of the arc"},
        Wrong{"CIP X1", "1: error: CIP needs a point on the way: I1=, J1= or K1="},
        Wrong{"G1 X1 I5", "7: error: I has no meaning in a block with G1"},
        Wrong{"G0 X1 R5", "7: error: R has no meaning in a block with G0"},
        Wrong{"G1 X1 AR=5", "7: error: AR= has no meaning in a block with G1"},
        Wrong{"CIP X1 I1=5 R6", "13: error: R has no meaning in a block with CIP"},
        Wrong{"G4", "1: error: G4 takes one of P, X and U, its seconds"},
        Wrong{"G4 P1 X2", "1: error: G4 takes one of P, X and U, its seconds"},
        Wrong{"G4 P1 P2", "7: error: P stands twice in the block"},
        Wrong{"P5", "1: error: P has no meaning in this block: no code of the block takes it"},
        Wrong{"G1 X5 P5", "7: error: P has no meaning in this block: no code of the block takes it"},
        Wrong{"L5", "1: error: L has no meaning in this block: no code of the block takes it"},
        Wrong{"E5", "1: error: E has no meaning in this block: no code of the block takes it"},
        Wrong{"M98", "1: error: M98 needs P, the program that it calls"},
        Wrong{"M98 L2", "1: error: M98 needs P, the program that it calls"},
        Wrong{"M98 P1.5", "5: error: P of M98 is a whole number, not 1.5"},
        Wrong{"M98 P-1", "5: error: P of M98 is a whole number, not -1"},
        Wrong{"M98 P[1] L1.5", "10: error: L of M98 is a whole number, not 1.5"},
        Wrong{"M99 L2", "5: error: L has no meaning in this block: no code of the block takes it"}));

INSTANTIATE_TEST_SUITE_P(
    Codes, BlockErrors,
    testing::Values(
        Wrong{"G777", "1: error: G777 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"M77", "1: error: M77 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"G1.5 X1", "1: error: G1.5 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"G-1 X1", "1: error: G-1 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"G1.55", "1: error: G1.55 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"G99999", "1: error: G99999 is no code of the Allen-Bradley 9/Series dialect"},
        Wrong{"G#1 X1",
              "1: error: the number of a G code must be written out; a computed one is not supported"},
        Wrong{"M[5]",
              "1: error: the number of a M code must be written out; a computed one is not supported"},
        Wrong{"G41 D1", "1: error: G41 (cutter compensation, left) is not supported yet"},
        Wrong{"G42 D1", "1: error: G42 (cutter compensation, right) is not supported yet"},
        Wrong{"X1 G81 R2", "4: error: G81 (drilling cycle) is not supported yet"},
        Wrong{"G14 P2", "1: error: G14 (scaling) is not supported yet"},
        Wrong{"G14.1 P2", "1: error: G14.1 (scaling) is not supported yet"},
        Wrong{"G51.1 X0", "1: error: G51.1 (mirror image on) is not supported yet"},
        Wrong{"G22 X1 I5", "1: error: G22 (programmable zone on) is not supported yet"},
        Wrong{"G43 H1", "1: error: G43 (tool length offset, plus) is not supported yet"},
        Wrong{"G65 P1", "1: error: G65 (macro call) is not supported yet"},
        Wrong{"M99 P10", "1: error: M99 with P (return to a block) is not supported yet"},
        Wrong{"X1 ,C5", "4: error: chamfers, corner radii and angles (,C ,R ,A) are not supported yet"}));

INSTANTIATE_TEST_SUITE_P(
    BlockDelete, BlockErrors,
    testing::Values(Wrong{"/WHILE[1]DO1;END1",
                          "1: error: block delete '/' cannot stand before O, WHILE or END: the "
                          "program would lose its structure"},
                    Wrong{"WHILE[1]DO1;/END1",
                          "13: error: block delete '/' cannot stand before O, WHILE or END: the "
                          "program would lose its structure"},
                    Wrong{"/O5",
                          "3: error: block delete '/' cannot stand before O, WHILE or END: the program would "
                          "lose its structure"}));

}  // namespace
}  // namespace gsim::codegen
