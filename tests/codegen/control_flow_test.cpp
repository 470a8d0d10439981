// Loops, jumps and programs: their Lua, and their errors, word for word.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::control_flow_test {
namespace {

std::string messages(const std::string& gcode) {
    const Translated result = translated(gcode);
    EXPECT_EQ(result.ok, result.messages.find("error") == std::string::npos);
    return result.messages;
}

TEST(Loops, BecomeLuaLoops) {
    const Translated result =
        translated("WHILE[#1 LT 5]DO1\nWHILE[#2]DO2\n#1=#1+1\nEND2\nEND1\nWHILE[1 EQ 1]DO1\nEND1\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(1), "while v[1] < 5.0 do");
    EXPECT_EQ(result.code(2), "while truth(v[2]) do");
    EXPECT_EQ(result.code(4), "end");
}

TEST(Loops, RejectsUnmatchedWhileAndEnd) {
    EXPECT_EQ(messages("X1\nWHILE[1]DO2\nX1\n"), "2:11: error: WHILE has no END 2\n");
    EXPECT_EQ(messages("WHILE[1]DO2\nO2\nEND2\n"),
              "1:11: error: WHILE has no END 2\n3:4: error: END 2 has no WHILE\n");
    EXPECT_EQ(messages("END1\n"), "1:4: error: END 1 has no WHILE\n");
    EXPECT_EQ(messages("WHILE[1]DO1\nWHILE[1]DO2\nEND1\nEND2\nEND1\n"),
              "3:4: error: END 1 closes DO 2, which is open since line 2\n");
    EXPECT_EQ(messages("WHILE[1]DO1\nWHILE[1]DO1\nEND1\n"),
              "2:11: error: DO 1 is already open since line 1; nested loops must have different numbers\n");
}

TEST(Jumps, OnlyTargetsGetLabels) {
    const Translated result = translated("N1 X1\nN02 X2\nIF[#1 EQ 5]GOTO002\nGOTO2\nN3 X3\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(1), "move{x=1}");
    EXPECT_EQ(result.code(2), "::N2:: move{x=2}");
    EXPECT_EQ(result.code(3), "if v[1] == 5.0 then goto N2 end");
    EXPECT_EQ(result.code(4), "goto N2");
    EXPECT_EQ(result.code(5), "move{x=3}");
}

TEST(Jumps, ComputedJumpReachesAnyBlockOutsideLoops) {
    const Translated result = translated("N1 X1\nGOTO#1\nWHILE[1]DO1\nN2 X2\nEND1\nN3 M2\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_TRUE(
        result.lua.starts_with("local _ENV = require \"gsim\" program(nil, function() local jump -- "))
        << result.lua;
    EXPECT_EQ(result.code(2), "jump = goto_target(v[1]) goto computed");
    EXPECT_EQ(result.code(5), "end");
    EXPECT_EQ(result.code(7),
              "do return end ::computed:: if jump == 1 then goto N1 end if jump == 3 then goto N3 end "
              "no_target(jump) end)");
    EXPECT_EQ(compile_error(result.lua), std::nullopt);
}

TEST(Jumps, ComputedJumpInLoopReachesBlocksOfLoop) {
    const Translated result =
        translated("WHILE[1]DO1\nN1 X1\nWHILE[2]DO2\nGOTO#1\nN2 X2\nEND2\nEND1\nN3 M2\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(4), "jump = goto_target(v[1]) goto computed1");
    EXPECT_EQ(result.code(6),
              "goto pass1 ::computed1:: if jump == 2 then goto N2 end goto computed0 ::pass1:: end");
    EXPECT_EQ(result.code(7),
              "goto pass0 ::computed0:: if jump == 1 then goto N1 end goto computed ::pass0:: end");
    EXPECT_EQ(compile_error(result.lua), std::nullopt);
}

TEST(Jumps, RejectsInvalidTargets) {
    EXPECT_EQ(messages("GOTO5\n"), "1:5: error: GOTO 5: N5 does not exist in this program\n");
    EXPECT_EQ(messages("O1\nGOTO5\nO2\nN5\n"), "2:5: error: GOTO 5: N5 does not exist in this program\n");
    EXPECT_EQ(messages("GOTO6\nWHILE[1]DO1\nN6\nEND1\n"),
              "1:5: error: GOTO 6 jumps into a WHILE loop from outside\n");
    EXPECT_EQ(messages("WHILE[1]DO1\nGOTO6\nEND1\nWHILE[1]DO1\nN6\nEND1\n"),
              "2:5: error: GOTO 6 jumps into a WHILE loop from outside\n");
    EXPECT_EQ(messages("N7\nGOTO7\nN7\n"),
              "3:1: error: N7 is defined twice in this program, and a GOTO jumps to it\n");
    EXPECT_EQ(messages("GOTO5.5\n"), "1:5: error: the target of a jump must be a block number, not 5.5\n");
    EXPECT_EQ(messages("GOTO1234567890\n"),
              "1:5: error: the target of a jump must be a block number, not 1234567890\n");
    EXPECT_EQ(messages("N7\nN7\n"), "") << "without a GOTO it does not matter";
}

TEST(Jumps, AcceptsJumpsWithinAndOutOfLoop) {
    const Translated result =
        translated("WHILE[1]DO1\nN1 IF[#1]GOTO2\nGOTO1\nWHILE[1]DO2\nGOTO1\nEND2\nEND1\nN2\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(compile_error(result.lua), std::nullopt);
}

TEST(Jumps, BlockErrorCausesNoSecondError) {
    EXPECT_EQ(messages("GOTO5\nN5 @\n"), "2:4: error: unexpected character '@'\n") << "N5 is there";
    EXPECT_EQ(messages("O1\nGOTO5\nN5\nO2 @\nGOTO6\nN6\n"), "4:4: error: unexpected character '@'\n");
    EXPECT_EQ(messages("GOTO5\nN5 X1 X2\n"), "2:7: error: X is given twice in the block\n");
}

TEST(Jumps, RejectsMoreThan32000JumpsOrTargets) {
    std::string gcode = "GOTO#1\n";
    for (int i = 1; i <= 32000; ++i) gcode += fmt::format("N{}\n", i);
    const Translated max = translated(gcode);
    EXPECT_TRUE(max.ok) << max.messages;
    EXPECT_EQ(compile_error(max.lua), std::nullopt);
    EXPECT_EQ(messages(gcode + "N32001\nN32002\n"),
              "32002:1: error: the program has more than 32000 blocks that a GOTO may target, which exceeds "
              "the limit of one Lua function\n");
    std::string jumps;
    for (int i = 0; i < 32001; ++i) jumps += "GOTO1\n";
    EXPECT_EQ(messages(jumps + "N1\n"),
              "32001:5: error: the program has more than 32000 GOTOs, which exceeds the limit of one Lua "
              "function\n");
}

TEST(Jumps, RejectsJumpTooFarForLua) {
    std::string far = "O1\nWHILE[#1]DO1\n";
    for (int i = 0; i < 650000; ++i) far += "X1Y2Z3B4\n";
    EXPECT_EQ(messages(far + "END1\n"),
              "2:12: error: the loop up to line 650003 is too long for Lua; move its body to a subprogram\n");
    far.replace(far.find("WHILE"), 12, "GOTO5");
    EXPECT_EQ(messages(far + "N5\n"),
              "2:5: error: GOTO 5 jumps too far for Lua; move the skipped blocks to a subprogram\n");
}

TEST(Programs, ReportsDuplicateNamesAndUnknownCalls) {
    EXPECT_EQ(messages("O1\nM2\nO0001\n"), "3:2: error: the program O0001 is defined twice in this file\n");
    EXPECT_EQ(messages("OPART\nOPART\n"), "2:1: error: the program OPART is defined twice in this file\n");
    EXPECT_EQ(
        messages("M98 P7\nM98 P0007\nM98 P8\nO8\nM99\n"),
        "1:5: warning: program O7 is not in this file; it is searched for next to it when it is called\n");
    const Translated result = translated("(head)\nN5\nO01\nX1\nO2\n");
    EXPECT_EQ(result.code(0).substr(0, 27), "local _ENV = require \"gsim\"");
    EXPECT_EQ(result.lua.find("nil"), std::string::npos) << "comments alone are no program";
    EXPECT_EQ(result.code(3), "program(1, function()");
    EXPECT_EQ(result.code(5), "end) program(2, function()");
}

TEST(Errors, TranslationStopsAfterMaxErrors) {
    TranslateOptions options;
    options.source_name = "t";
    options.max_errors = 2;
    const TextTranslation result = translate_text("@\n@\n@\nGOTO5\n", options);
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.diagnostics,
              "t:1:1: error: unexpected character '@'\n  @\n  ^\n"
              "t:2:1: error: unexpected character '@'\n  @\n  ^\n"
              "t: note: stopped after 2 errors\n");
}

}  // namespace
}  // namespace gsim::codegen::control_flow_test
