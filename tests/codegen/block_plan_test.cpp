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

TEST_P(BlockErrors, ReportsExactMessage) {
    const Translated result = translated(fmt::format("{}\nG1 X1\n", GetParam().block));
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.lua, "");
    EXPECT_EQ(result.messages, fmt::format("1:{}\n", GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Groups, BlockErrors,
    testing::Values(
        Wrong{"G0 G1 X5",
              "4: error: G0 and G1 are in one modal group (motion); a block may have only one of them"},
        Wrong{"G1 X5 G02 I1",
              "7: error: G1 and G2 are in one modal group (motion); a block may have only one of them"},
        Wrong{"G17 G18",
              "5: error: G17 and G18 are in one modal group (plane); a block may have only one of them"},
        Wrong{"G20 G21",
              "5: error: G20 and G21 are in one modal group (units); a block may have only one of them"},
        Wrong{"G90 G91",
              "5: error: G90 and G91 are in one modal group (distance mode); a block may have only one of "
              "them"},
        Wrong{"G93 G94",
              "5: error: G93 and G94 are in one modal group (feed mode); a block may have only one of them"},
        Wrong{"G54 G505",
              "5: error: G54 and G505 are in one modal group (work coordinate system); a block may have only "
              "one of them"},
        Wrong{"G61 G64",
              "5: error: G61 and G64 are in one modal group (path mode); a block may have only one of them"},
        Wrong{"G15 G16",
              "5: error: G15 and G16 are in one modal group (polar programming); a block may have only one "
              "of them"},
        Wrong{"M8 M9", "4: error: M8 and M9 are in one modal group (jet); a block may have only one of them"},
        Wrong{"M10 M11",
              "5: error: M10 and M11 are in one modal group (abrasive); a block may have only one of them"},
        Wrong{"M3 M5",
              "4: error: M3 and M5 are in one modal group (spindle); a block may have only one of them"},
        Wrong{
            "M2 M30",
            "4: error: M2 and M30 are in one modal group (program stop); a block may have only one of them"},
        Wrong{"G1 CIP X1 I1=5",
              "4: error: CIP is given with another motion code; a block may have only one of them"},
        Wrong{"CIP X1 I1=5 G1",
              "13: error: CIP and G1 are in one modal group (motion); a block may have only one of them"},
        Wrong{"CIP CIP",
              "5: error: CIP is given with another motion code; a block may have only one of them"},
        Wrong{"G1 X5 G01", "7: error: G1 is given twice in the block"},
        Wrong{"G28 G92 X1", "5: error: G28 and G92 both use the axis words of the block"}));

INSTANTIATE_TEST_SUITE_P(
    Words, BlockErrors,
    testing::Values(
        Wrong{"X1 X2", "4: error: X is given twice in the block"},
        Wrong{"G1 X1 F5 F6", "10: error: F is given twice in the block"},
        Wrong{"G2 X1 I5 I6", "10: error: I is given twice in the block"},
        Wrong{"G2 X1 AR=5 AR=6", "12: error: AR= is given twice in the block"},
        Wrong{"G92", "1: error: G92 requires the axis words whose coordinates it sets"},
        Wrong{"G52", "1: error: G52 requires the axis words whose coordinates it sets"},
        Wrong{"G2 X1",
              "1: error: G2 requires the centre (I, J, K), the radius (R) or the angle (AR=) of the arc"},
        Wrong{"G03 X1 F5",
              "1: error: G3 requires the centre (I, J, K), the radius (R) or the angle (AR=) of the arc"},
        Wrong{"CIP X1", "1: error: CIP requires an intermediate point: I1=, J1= or K1="},
        Wrong{"G1 X1 I5", "7: error: I has no meaning in a block with G1"},
        Wrong{"G0 X1 R5", "7: error: R has no meaning in a block with G0"},
        Wrong{"G1 X1 AR=5", "7: error: AR= has no meaning in a block with G1"},
        Wrong{"CIP X1 I1=5 R6", "13: error: R has no meaning in a block with CIP"},
        Wrong{"G4", "1: error: G4 requires one of P, X and U, the time in seconds"},
        Wrong{"G4 P1 X2", "1: error: G4 requires one of P, X and U, the time in seconds"},
        Wrong{"G4 P1 P2", "7: error: P is given twice in the block"},
        Wrong{"P5", "1: error: P has no meaning in this block: no code of the block uses it"},
        Wrong{"G1 X5 P5", "7: error: P has no meaning in a block with G1"},
        Wrong{"L5", "1: error: L has no meaning in this block: no code of the block uses it"},
        Wrong{"E5", "1: error: E has no meaning in this block: no code of the block uses it"},
        Wrong{"M98", "1: error: M98 requires P, the program that it calls"},
        Wrong{"M98 L2", "1: error: M98 requires P, the program that it calls"},
        Wrong{"M98 P1.5", "5: error: P of M98 must be an integer, not 1.5"},
        Wrong{"M98 P-1", "5: error: P of M98 must be an integer, not -1"},
        Wrong{"M98 P[1] L1.5", "10: error: L of M98 must be an integer, not 1.5"},
        Wrong{"M99 L2", "5: error: L has no meaning in this block: no code of the block uses it"}));

INSTANTIATE_TEST_SUITE_P(
    Codes, BlockErrors,
    testing::Values(
        Wrong{"G777", "1: error: G777 is not a code of Allen-Bradley 9/Series"},
        Wrong{"M77", "1: error: M77 is not a code of Allen-Bradley 9/Series"},
        Wrong{"G1.5 X1",
              "1: error: G1.5 is not a code of Allen-Bradley 9/Series; G1 (linear interpolation) exists"},
        Wrong{"G-1 X1", "1: error: G-1 is not a code of Allen-Bradley 9/Series"},
        Wrong{"G1.55", "1: error: G1.55 is not a code of Allen-Bradley 9/Series"},
        Wrong{"G99999", "1: error: G99999 is not a code of Allen-Bradley 9/Series"},
        Wrong{"G#1 X1",
              "1: error: the number of a G code must be a constant; a computed number is not supported"},
        Wrong{"M[5]",
              "1: error: the number of a M code must be a constant; a computed number is not supported"},
        Wrong{"G64.1", "1: error: G64.1 is not a code of Allen-Bradley 9/Series; G64 (cutting mode) exists"},
        Wrong{"G7",
              "1: error: G7 is not a code of Allen-Bradley 9/Series; RS274/NGC supports it (lathe diameter "
              "mode), see --dialect rs274ngc"},
        Wrong{"X1 G38.2",
              "4: error: G38.2 is not a code of Allen-Bradley 9/Series; RS274/NGC supports it (probe toward, "
              "alarm on failure), see --dialect rs274ngc"},
        Wrong{"M62 P1",
              "1: error: M62 is not a code of Allen-Bradley 9/Series; RS274/NGC supports it (output on, with "
              "the next move), see --dialect rs274ngc"},
        Wrong{"G12", "1: error: G12 (data setting) is not supported"},
        Wrong{"G12 X1", "1: error: G12 (data setting) is not supported"},
        Wrong{"M1000", "1: error: M1000 is not a code of Allen-Bradley 9/Series"},
        Wrong{"M101 F5 I1 I2", "12: error: I is given twice in the block"},
        Wrong{"G65 X1", "1: error: G65 requires P, the program that it calls"},
        Wrong{"G66.1 A1", "1: error: G66.1 requires P, the program that it calls"},
        Wrong{"G65 P1 X1 X2", "11: error: X is given twice in the block"},
        Wrong{"G65 P1 Q1 I1 I2 Q2", "17: error: Q is given twice in the block"},
        Wrong{"G92 X1 ,C2", "8: error: ,C has no meaning in a block with G92"},
        Wrong{"G0 X1 ,R2", "7: error: ,R has no meaning in a block with G0"},
        Wrong{"G81 X1 Z1 R2 ,A30", "14: error: ,A has no meaning in a block with G81"},
        Wrong{"G1 X1 ,C2 ,C3", "11: error: ,C is given twice in the block"},
        Wrong{"G54 G59.3",
              "5: error: G54 and G59.3 are in one modal group (work coordinate system); a block may have "
              "only one of them"},
        Wrong{
            "G43 H1 G49",
            "8: error: G43 and G49 are in one modal group (tool length); a block may have only one of them"},
        Wrong{"G81 X1 R1 G80",
              "11: error: G81 and G80 are in one modal group (canned cycles); a block may have only one of "
              "them"},
        Wrong{"M99 P1.5", "5: error: the target of a jump must be a block number, not 1.5"},
        Wrong{"M99 P5", "5: error: GOTO 5: N5 does not exist in this program"}));

INSTANTIATE_TEST_SUITE_P(BlockDelete, BlockErrors,
                         testing::Values(Wrong{"/WHILE[1]DO1;END1",
                                               "1: error: block delete '/' must not precede a program or a "
                                               "control structure: its end would be lost"},
                                         Wrong{"WHILE[1]DO1;/END1",
                                               "13: error: block delete '/' must not precede a program or a "
                                               "control structure: its end would be lost"},
                                         Wrong{"/O5",
                                               "3: error: block delete '/' must not precede a program or a "
                                               "control structure: its end would be lost"}));

}  // namespace
}  // namespace gsim::codegen::block_plan_test
