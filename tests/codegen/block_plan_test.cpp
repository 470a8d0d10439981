// Every diagnostic about the words of one block, word for word.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/translated.h"

namespace gsim::codegen::block_plan_test {
namespace {

struct Wrong {
    const char* block;
    const char* message;  ///< After "1:".
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
        Wrong{"G1 X5 P5", "7: error: P has no meaning in a block with G1"},
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
        Wrong{"G777", "1: error: G777 is no code of Allen-Bradley 9/Series"},
        Wrong{"M77", "1: error: M77 is no code of Allen-Bradley 9/Series"},
        Wrong{"G1.5 X1",
              "1: error: G1.5 is no code of Allen-Bradley 9/Series; there is G1 (linear interpolation)"},
        Wrong{"G-1 X1", "1: error: G-1 is no code of Allen-Bradley 9/Series"},
        Wrong{"G1.55", "1: error: G1.55 is no code of Allen-Bradley 9/Series"},
        Wrong{"G99999", "1: error: G99999 is no code of Allen-Bradley 9/Series"},
        Wrong{"G#1 X1",
              "1: error: the number of a G code must be written out; a computed one is not supported"},
        Wrong{"M[5]",
              "1: error: the number of a M code must be written out; a computed one is not supported"},
        Wrong{"G64.1", "1: error: G64.1 is no code of Allen-Bradley 9/Series; there is G64 (cutting mode)"},
        Wrong{
            "G7",
            "1: error: G7 is no code of Allen-Bradley 9/Series; RS274/NGC has it (lathe diameter mode), see "
            "--dialect rs274ngc"},
        Wrong{
            "X1 G38.2",
            "4: error: G38.2 is no code of Allen-Bradley 9/Series; RS274/NGC has it (probe toward, alarm on "
            "failure), see --dialect rs274ngc"},
        Wrong{
            "M62 P1",
            "1: error: M62 is no code of Allen-Bradley 9/Series; RS274/NGC has it (output on, with the next "
            "move), see --dialect rs274ngc"},
        Wrong{"G12", "1: error: G12 (data setting) is not supported"},
        Wrong{"G12 X1", "1: error: G12 (data setting) is not supported"},
        Wrong{"M1000", "1: error: M1000 is no code of Allen-Bradley 9/Series"},
        Wrong{"M101 F5 I1 I2", "12: error: I stands twice in the block"},
        Wrong{"G65 X1", "1: error: G65 needs P, the program that it calls"},
        Wrong{"G66.1 A1", "1: error: G66.1 needs P, the program that it calls"},
        Wrong{"G65 P1 X1 X2", "11: error: X stands twice in the block"},
        Wrong{"G65 P1 Q1 I1 I2 Q2", "17: error: Q stands twice in the block"},
        Wrong{"G92 X1 ,C2", "8: error: ,C has no meaning in a block with G92"},
        Wrong{"G0 X1 ,R2", "7: error: ,R has no meaning in a block with G0"},
        Wrong{"G81 X1 Z1 R2 ,A30", "14: error: ,A has no meaning in a block with G81"},
        Wrong{"G1 X1 ,C2 ,C3", "11: error: ,C stands twice in the block"},
        Wrong{"G54 G59.3",
              "5: error: G54 and G59.3 are of one modal group (work coordinate system); a block takes one of "
              "them"},
        Wrong{"G43 H1 G49",
              "8: error: G43 and G49 are of one modal group (tool length); a block takes one of them"},
        Wrong{"G81 X1 R1 G80",
              "11: error: G81 and G80 are of one modal group (canned cycles); a block takes one of them"},
        Wrong{"M99 P1.5", "5: error: a jump leads to a block number, not to 1.5"},
        Wrong{"M99 P5", "5: error: GOTO 5: there is no N5 in this program"}));

INSTANTIATE_TEST_SUITE_P(
    BlockDelete, BlockErrors,
    testing::Values(Wrong{"/WHILE[1]DO1;END1",
                          "1: error: block delete '/' cannot stand before a program or a control "
                          "structure: its other end would be lost"},
                    Wrong{"WHILE[1]DO1;/END1",
                          "13: error: block delete '/' cannot stand before a program or a control "
                          "structure: its other end would be lost"},
                    Wrong{"/O5",
                          "3: error: block delete '/' cannot stand before a program or a control "
                          "structure: its other end would be lost"}));

}  // namespace
}  // namespace gsim::codegen::block_plan_test
