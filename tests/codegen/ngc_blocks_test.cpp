// Blocks of RS274/NGC: the code that takes each word, order of execution, settings, unknown codes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::ngc_blocks_test {
namespace {

TEST(NgcBlocks, CodesTakeTheirWords) {
    EXPECT_EQ(ngc_lua_of("g 0 x 1 2 . 5"), "G0{x=12.5}");
    EXPECT_EQ(ngc_lua_of("X5 U6 @7 ^30"), "move{x=5, u=6, radius=7, angle=30}");
    EXPECT_EQ(ngc_lua_of("G2 X1 Y2 I3 J4 P2"), "G2{x=1, y=2, i=3, j=4, p=2}");
    EXPECT_EQ(ngc_lua_of("G4 P1.5"), "G4{p=1.5}");
    EXPECT_EQ(ngc_lua_of("G5.2 X1 Y2 P1 L3"), "G5_2{x=1, y=2, p=1, l=3}");
    EXPECT_EQ(ngc_lua_of("X1 Y2 P1"), "move{x=1, y=2, p=1}") << "goes on with G5.2";
    EXPECT_EQ(ngc_lua_of("G10 L2 P1 X5 R30"), "G10{l=2, p=1, x=5, r=30}");
    EXPECT_EQ(ngc_lua_of("G43 H5 Z1"), "G43{h=5} move{z=1}");
    EXPECT_EQ(ngc_lua_of("G43.1 Z5"), "G43_1{z=5}");
    EXPECT_EQ(ngc_lua_of("G64 P0.1 Q0.2"), "G64{p=0.1, q=0.2}");
    EXPECT_EQ(ngc_lua_of("G76 P1 Z-2 I-1 J0.5 R1.5 K2 Q30 H2 E1 L2"),
              "G76{p=1, z=-2, i=-1, j=0.5, r=1.5, k=2, q=30, h=2, e=1, l=2}");
    EXPECT_EQ(ngc_lua_of("M3 $1 S100"), "S(100) M3{spindle=1}");
    EXPECT_EQ(ngc_lua_of("M66 P0 L3 Q5"), "M66{p=0, l=3, q=5}");
    EXPECT_EQ(ngc_lua_of("M199 P1 Q#<x>"), "M[199]{p=1, q=p.x}");
    EXPECT_EQ(ngc_lua_of("F#<feed>"), "F(p.feed)");
    EXPECT_EQ(ngc_lua_of("G92.1"), "G92_1()");
}

/// P of G64 may be the turns of a modal arc, too.
TEST(NgcBlocks, PassesWordToEveryCodeUsingIt) {
    EXPECT_EQ(ngc_lua_of("G64 P1 M19 R90 Q2"), "M19{p=1, r=90, q=2} G64{p=1, q=2}");
    EXPECT_EQ(ngc_lua_of("G64 P2 G3 X1 I5"), "G64{p=2} G3{p=2, x=1, i=5}");
    EXPECT_EQ(ngc_lua_of("M50 P0 G4"), "M50{p=0} G4{p=0}");
    EXPECT_EQ(ngc_lua_of("G64 P2 X1 I5"), "G64{p=2} move(shared({x=1, i=5}, {p=2}))");
    EXPECT_EQ(ngc_lua_of("G64 P#1 X#1"),
              "do local w1, w2 = v[1], v[1] G64{p=w1} move(shared({x=w2}, {p=w1})) end");
}

/// The order that LinuxCNC documents, in blocks that give the words in another.
TEST(NgcBlocks, CodesActInOrderOfLinuxCnc) {
    EXPECT_EQ(ngc_lua_of("M2 G1 X1 G98 G90 G64 G54 G40 G20 G17 M48 M8 M3 T1 S5 F6 G94"),
              "G94() F(6) S(5) T(1) M3() M8() M48() G17() G20() G40() G54() G64() G90() G98() G1{x=1} M2()");
    EXPECT_EQ(ngc_lua_of("X1 M6 T2"), "T(2) M6() move{x=1}");
    EXPECT_EQ(ngc_lua_of("G1 X1 M9 M5"), "M5() M9() G1{x=1}")
        << "before the move, other than in the 9/Series";
    EXPECT_EQ(lua_of("G1 X1 M9 M5"), "G1{x=1} M9() M5()");
    EXPECT_EQ(ngc_lua_of("X1 G4 P2"), "G4{p=2} move(shared({x=1}, {p=2}))") << "the dwell first";
    EXPECT_EQ(ngc_lua_of("X1 G55 G91 G20"), "G20() G55() G91() move{x=1}");
    EXPECT_EQ(lua_of("X1 G55 G91 G20"), "G20() G91() G55() move{x=1}");
    EXPECT_EQ(ngc_lua_of("X1 G92 F5"), "F(5) G92{x=1}");
    EXPECT_EQ(ngc_lua_of("M0 X1"), "move{x=1} M0()");
    EXPECT_EQ(ngc_lua_of("X1 M62 P1"), "M62{p=1} move(shared({x=1}, {p=1}))");
    EXPECT_EQ(ngc_lua_of("G53 G0 X1 G43 H1"), "G43{h=1} G53() G0{x=1}");
    EXPECT_EQ(ngc_lua_of("G80 G28 X1"), "G80() G28{x=1}");
    EXPECT_EQ(ngc_lua_of("S5 G96 D100"), "G96{d=100} S(5)");
}

TEST(NgcBlocks, RejectsInvalidBlocks) {
    const auto error = [](const char* block, const char* message) {
        EXPECT_EQ(ngc_lua_of(block), fmt::format("1:{}\n", message)) << block;
    };
    error("G4", "1: error: G4 requires P, the time in seconds");
    error("G4 X1", "1: error: G4 requires P, the time in seconds");
    error("G2 X1", "1: error: G2 requires the centre (I, J, K) or the radius (R) of the arc");
    error("G92", "1: error: G92 requires the axis words whose coordinates it sets");
    error("G1 X1 I5", "7: error: I has no meaning in a block with G1");
    error("P5", "1: error: P has no meaning in this block: no code of the block uses it");
    error("M3 P5", "4: error: P has no meaning in this block: no code of the block uses it");
    error("H5", "1: error: H has no meaning in this block: no code of the block uses it");
    error("$1", "1: error: $ has no meaning in this block: no code of the block uses it");
    error(
        "G10 L2 P1 G92 X1",
        "11: error: G10 and G92 are in one modal group (one action per block); a block may have only one of "
        "them");
    error("G43.1 Z1 G10 L1", "10: error: G43.1 and G10 both use the axis words of the block");
    error("G43.1 Z5 G0 X1", "10: error: G43.1 and G0 both use the axis words of the block");
    error("G1 G92 X1", "4: error: G1 and G92 both use the axis words of the block");
    error("G28 G0", "5: error: G28 and G0 both use the axis words of the block");
    EXPECT_EQ(ngc_lua_of("G43.2 H1 G0"), "G43_2{h=1} G0()") << "no axis words";
    EXPECT_EQ(lua_of("G92 X1 G1"), "G92{x=1} G1()") << "the 9/Series makes the motion modal";
    const char* const standalone = "error: M98 must be in a separate block, only with its P and L";
    error("M98 P3 G0 X1", fmt::format("1: {}", standalone).c_str());
    error("F5 M98 P3 L2", fmt::format("4: {}", standalone).c_str());
    error("#1=2 M98 P#1", fmt::format("6: {}", standalone).c_str());
    EXPECT_EQ(ngc_lua_of("N5 M98 P[#1+1] L2 (c)"), "M98{p=v[1] + 1.0, l=2}");
    error("G90 G91",
          "5: error: G90 and G91 are in one modal group (distance mode); a block may have only one of them");
    error("G1 G81 X1 R1",
          "4: error: G1 and G81 are in one modal group (motion); a block may have only one of them");
    error("M7 M8", "4: error: M7 and M8 are in one modal group (coolant); a block may have only one of them");
    error("@1 @2", "4: error: @ is given twice in the block");
    error("G72", "1: error: G72 (lathe facing cycle) is not supported");
    error("G17.1", "1: error: G17.1 (UV plane) is not supported");
    error("G65 P1",
          "1: error: G65 is not a code of RS274/NGC; Allen-Bradley 9/Series supports it (macro call), see "
          "--dialect ab9");
    error("G38.9 X1", "1: error: G38.9 is not a code of RS274/NGC");
    error("G1.5 X1", "1: error: G1.5 is not a code of RS274/NGC; G1 (linear move) exists");
    error("M200", "1: error: M200 is not a code of RS274/NGC");
}

TEST(NgcBlocks, ComputedCodesActWithModalSettings) {
    EXPECT_EQ(ngc_lua_of("G[#<_plane>/10]"), "code(\"G\", p._plane / 10.0)");
    EXPECT_EQ(ngc_lua_of("X1 G#1 M#2 G90 G20"),
              "do local w1, w2 = v[1], v[2] code(\"M\", w2) G20() code(\"G\", w1) G90() move{x=1} end");
    EXPECT_EQ(ngc_lua_of("G[1] G1 X1"), "code(\"G\", 1.0) G1{x=1}");
    EXPECT_EQ(ngc_lua_of("G[4] P1"),
              "1:6: error: P has no meaning in this block: no code of the block uses it\n");
    EXPECT_EQ(lua_of("G[1] X1"),
              "1:1: error: the number of a G code must be a constant; a computed number is not supported\n");
}

/// All values of a block are worked out, then its settings are made, then it acts.
TEST(NgcBlocks, AssignmentsTakeEffectTogetherBeforeBlock) {
    EXPECT_EQ(ngc_lua_of("#1=2 #2=#1"), "v[1], v[2] = 2.0, v[1]");
    EXPECT_EQ(ngc_lua_of("#1=2 X#1"), "do local w1 = v[1] v[1] = 2.0 move{x=w1} end")
        << "X sees the old value";
    EXPECT_EQ(ngc_lua_of("#1=[#1+1] G0 X5"), "v[1] = v[1] + 1.0 G0{x=5}") << "no word reads a parameter";
    EXPECT_EQ(ngc_lua_of("G38.2 X1 #1=#5061 #2=#1"), "v[1], v[2] = v[5061], v[1] G38_2{x=1}")
        << "values from before the block";
    EXPECT_EQ(ngc_lua_of("/M2 #1=2"), "if not skipped(1) then v[1] = 2.0 M2() end");
    EXPECT_EQ(ngc_lua_of("#1=1 #1=2"), "v[1] = 2.0") << "the last one holds";
    EXPECT_EQ(ngc_lua_of("#<a>=1 #<A >=#<a> #2=3"), "p.a, v[2] = p.a, 3.0");
    EXPECT_EQ(ngc_lua_of("/#1=2"), "if not skipped(1) then v[1] = 2.0 end");
    EXPECT_EQ(lua_of("#1=2 #2=#1"), "v[1] = 2.0 v[2] = v[1]") << "one by one in the 9/Series";
}

/// A word's value is that before the block, whatever acts before the word.
TEST(NgcBlocks, EvaluatesWordsBeforeFirstCall) {
    EXPECT_EQ(ngc_lua_of("G20 G0 Y#5420"), "do local w1 = v[5420] G20() G0{y=w1} end");
    EXPECT_EQ(ngc_lua_of("G0 Y#5420 X#<a>"), "G0{y=v[5420], x=p.a}") << "nothing acts before";
    EXPECT_EQ(ngc_lua_of("G20 G0 X1 Y[2+3]"), "G20() G0{x=1, y=2.0 + 3.0}") << "nothing to read";
    EXPECT_EQ(ngc_lua_of("F[1+2] X##2 Y-[2*exists[#<a>]] Z5"),
              "do local w1, w2 = v[v[2]], (-(2.0 * exists(\"a\"))) F(1.0 + 2.0) move{x=w1, y=w2, z=5} end");
    EXPECT_EQ(ngc_lua_of("/G91 X#1"), "if not skipped(1) then do local w1 = v[1] G91() move{x=w1} end end");
    EXPECT_EQ(lua_of("G20 G0 Y#5001"), "G20() G0{y=v[5001]}") << "each by itself in the 9/Series";
}

TEST(NgcBlocks, RejectsMoreThan50Assignments) {
    std::string max =
        "A#1 B#1 C#1 U#1 V#1 W#1 X#1 Y#1 Z#1 F#1 S#1 T#1 M3 $#1 G64 P#1 Q#1 G2 I#1 J#1 K#1 R#1 ";
    for (int i = 1; i <= 50; ++i) max += fmt::format("#[#[#{}]]=[#[#{}+1]+[#1*#2]] ", i + 300, i + 300);
    const Translated result = translated_ngc(max + "\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(compile_error(result.lua), std::nullopt);
    EXPECT_EQ(ngc_lua_of(max + "#1=2"), "1:1: error: a block sets at most 50 parameters\n");
    std::string deep = "X#1 Y#2";
    for (int i = 1; i <= 50; ++i)
        deep += fmt::format(" #[{0}]={1}#1{2}", i, std::string(45, '['), std::string(45, ']'));
    EXPECT_EQ(compile_error(translated_ngc(deep + "\n").lua), std::nullopt);
}

/// Two settings of variables that only the run can identify as one: the later one counts, whatever Lua's
/// order is.
TEST(NgcBlocks, LaterAssignmentWins) {
    for (const auto& [block, expected] :
         {std::pair{"#[1]=1 #1=2", 2.0}, std::pair{"#1=2 #[1]=1", 1.0}, std::pair{"#1=1 #[1]=2 #1=3", 3.0},
          std::pair{"#[#2]=5 #[#3]=6 #[1+0]=7", 7.0}, std::pair{"#1=5 #[#1+1]=#1", 0.0}}) {
        const std::string lua = ngc_lua_of(block);
        const std::string script = "local v = {[0] = 0, 0, 1, 1} " + lua + " return v[1]";
        EXPECT_EQ(run_number(script), expected) << block << ": " << lua;
    }
}

TEST(UnknownCodes, WarnOnceEachWithCount) {
    TranslateOptions options;
    options.unknown = UnknownCodePolicy::warn;
    const Translated result =
        translated_ngc("G777 X1\nM777\nG1 G777 X2\nG65\nG777\nM200 M201\nX1 M777 F5\n", options);
    ASSERT_TRUE(result.ok) << result.messages;
    const auto warning = [](const char* place, const char* code, int count) {
        return fmt::format(
            "{}: warning: {} is not a code of RS274/NGC; it is skipped, a G code with its complete block ({} "
            "in total)\n",
            place, code, count);
    };
    EXPECT_EQ(result.messages, warning("4:1", "G65", 1) + warning("1:1", "G777", 3) +
                                   warning("6:1", "M200", 1) + warning("6:6", "M201", 1) +
                                   warning("2:1", "M777", 2));
    EXPECT_EQ(result.code(1), "");
    EXPECT_EQ(result.code(2), "");
    EXPECT_EQ(result.code(3), "") << "what its words mean is not known";
    EXPECT_EQ(result.code(7), "F(5) move{x=1}") << "an M code goes alone";
    EXPECT_EQ(translated("G777\nG7\n", options).messages,
              "2:1: warning: G7 is not a code of Allen-Bradley 9/Series; it is skipped, a G code with its "
              "complete block (1 in total)\n1:1: warning: G777 is not a code of Allen-Bradley 9/Series; it "
              "is skipped, a G code with its complete block (1 in total)\n");
    EXPECT_TRUE(translated("G777 P5\n", options).ok) << "its word goes with it";
    EXPECT_FALSE(translated("G12\n", options).ok) << "a code that is there, but not done, stays an error";
}

TEST(UnknownCodes, DeferErrorInSubroutines) {
    const Translated result =
        translated_ngc("o1 sub\nG777 X1 P5\no2 if [#1]\nM428\no2 endif\nG1.5\no1 endsub\nX1\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(2), "unknown_code(\"G777\")") << "the whole block";
    EXPECT_EQ(result.code(4), "unknown_code(\"M428\")");
    EXPECT_EQ(result.code(6), "unknown_code(\"G1.5\")");
    EXPECT_EQ(result.messages,
              "6:1: warning: G1.5 is not a code of RS274/NGC; a call of the enclosing subroutine would end "
              "in an alarm (1 in total)\n2:1: warning: G777 is not a code of RS274/NGC; a call of the "
              "enclosing subroutine would end in an alarm (1 in total)\n4:1: warning: M428 is not a code of "
              "RS274/NGC; a call of the enclosing subroutine would end in an alarm (1 in total)\n");
    EXPECT_EQ(translated_ngc("o1 sub\no1 endsub\nG777\n").messages,
              "3:1: error: G777 is not a code of RS274/NGC\n");
    EXPECT_EQ(translated_ngc("o1 if [1]\nG777\no1 endif\n").messages,
              "2:1: error: G777 is not a code of RS274/NGC\n");
    TranslateOptions options;
    options.unknown = UnknownCodePolicy::warn;
    EXPECT_EQ(translated_ngc("o1 sub\nG777 X1\no1 endsub\n", options).code(2), "");
}

}  // namespace
}  // namespace gsim::codegen::ngc_blocks_test
