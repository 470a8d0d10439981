// 9/Series: statements that print, alarms with a message, and returns to a block (M99 P).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::macro_statements_test {
namespace {

TEST(Dprnt, WritesFormatAndValues) {
    EXPECT_EQ(lua_of("POPEN"), "POPEN()");
    EXPECT_EQ(lua_of("PCLOS"), "PCLOS()");
    EXPECT_EQ(lua_of("DPRNT[X#100[53]Y#2[40]]"), "DPRNT(\"X%.3fY%.0f\", v[100], v[2])");
    EXPECT_EQ(lua_of("DPRNT[HELLO*WORLD (*)]"), "DPRNT(\"HELLO WORLD ( )\")") << "* is a blank";
    EXPECT_EQ(lua_of("DPRNT[]"), "DPRNT(\"\")");
    EXPECT_EQ(lua_of("DPRNT[100%d \"quoted\" \\n]"), "DPRNT(\"100%%d \\\"quoted\\\" \\\\n\")");
    EXPECT_EQ(lua_of("dprnt [a[1]b]"), "DPRNT(\"a[1]b\")");
    EXPECT_EQ(lua_of("DPRNT[A] (b])"), "DPRNT(\"A\")");
    EXPECT_EQ(lua_of("/2 DPRNT[A]"), "if not skipped(2) then DPRNT(\"A\") end");
    EXPECT_EQ(lua_of("X1;DPRNT[A];PCLOS"), "move{x=1} DPRNT(\"A\") PCLOS()");
    const std::string message =
        "1:1: error: DPRNT requires the digits before and after the decimal point in brackets after a "
        "variable, as in #100[53]\n";
    for (const char* text : {"DPRNT[#1]", "DPRNT[#]", "DPRNT[#1[5]]", "DPRNT[#1[533]]", "DPRNT[#1[5.3]]",
                             "DPRNT[#123456[53]]", "DPRNT[##1[53]]", "DPRNT[A#1 [53]]"})
        EXPECT_EQ(lua_of(text), message) << text;
    std::string many;
    for (int i = 0; i < 66; ++i) many += "#1[53]";
    EXPECT_EQ(compile_error(translated("DPRNT[" + many + "]\n").lua), std::nullopt) << "as many as fit";
}

TEST(Messages, PrecedeAlarmsAndStops) {
    EXPECT_EQ(lua_of("#3000=1(TOOL BROKEN)"), "message(\"TOOL BROKEN\") v[3000] = 1.0");
    EXPECT_EQ(lua_of("#3006=1 (say \"go\")"), "message(\"say \\\"go\\\"\") v[3006] = 1.0");
    EXPECT_EQ(lua_of("#3000=1"), "v[3000] = 1.0");
    EXPECT_EQ(lua_of("#1=1 (note)"), "v[1] = 1.0");
    EXPECT_EQ(lua_of("#1=2 #3000=1 (a)(b)"), "message(\"a\") v[1] = 2.0 v[3000] = 1.0");
    EXPECT_EQ(lua_of("IF[#1 GT 5]THEN #3000=7 (TOO BIG)"),
              "if v[1] > 5.0 then message(\"TOO BIG\") v[3000] = 7.0 end");
    EXPECT_EQ(lua_of("/#3000=1 (a)"), "if not skipped(1) then message(\"a\") v[3000] = 1.0 end");
    EXPECT_EQ(ngc_lua_of("#3000=1 (a)"), "v[3000] = 1.0") << "not in RS274/NGC";
}

std::string code_of(const std::string& gcode, std::size_t line, const TranslateOptions& options = {}) {
    const Translated result = translated(gcode, options);
    if (!result.ok) return result.messages;
    EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
    return result.code(line);
}

TEST(ReturnToBlock, IsJumpInMainProgram) {
    EXPECT_EQ(code_of("N10 X1\nM99 P10\n", 1), "::N10:: move{x=1}");
    EXPECT_EQ(code_of("N10 X1\nM99 P10\nM30\n", 2), "goto N10");
    EXPECT_EQ(code_of("O1\nN10 X1\n/M99 P0010 X5\nM30\n", 3),
              "if not skipped(1) then move{x=5} goto N10 end");
    EXPECT_EQ(code_of("N10 X1\nIF[#1]THEN M99 P10\n", 2), "if truth(v[1]) then goto N10 end");
    EXPECT_EQ(code_of("N10 X1\nM99 P#1\n", 2), "jump = goto_target(v[1]) goto computed");
    EXPECT_EQ(code_of("N10 X1\nM99\n", 2), "do return (M99()) end");
    EXPECT_EQ(code_of("N10\nWHILE[#1]DO1\nM99P10\nEND1\n", 3), "goto N10");
    for (const char* text :
         {"M 99 P10", "M\t99P10", "M+99 P10", "m0099p10", "M99.0 P10", "P10 M99", "M9 M099 P10"})
        EXPECT_NE(code_of(fmt::format("N10 X1\n{}\n", text), 2).find("goto N10"), std::string::npos) << text;
}

TEST(ReturnToBlock, ChecksLastPassAtEndOfMainProgram) {
    const std::string pass = "if last_pass(10) then return end goto N10";
    EXPECT_EQ(code_of("N10 X1\nM99 P10\n", 2), pass);
    EXPECT_EQ(code_of("N10 X1\nGOTO 10\n\n(end)\n%\n", 2), pass);
    EXPECT_EQ(code_of("N10 X1\nM99 P10\nO2\nM99\n", 2), pass) << "other programs follow";
    EXPECT_EQ(code_of("M30\nO2\nN10 X1\nGOTO 10\n", 4), "goto N10") << "of a subprogram";
    EXPECT_EQ(code_of("GOTO 10\nX1\nN10\n", 1), "goto N10") << "forward";
}

TEST(ReturnToBlock, WorksThroughAlias) {
    TranslateOptions options;
    ASSERT_FALSE(options.aliases.add("GoBack", "M099"));
    EXPECT_EQ(code_of("N10 X1\nGoBack P10\nM30\n", 2, options), "goto N10");
}

TEST(ReturnToBlock, LeavesSubprogramAndJumpsInCaller) {
    const Translated result = translated("O1\nN5 M98 P2\nG65 P2 A1\nX1\nN7 M2\nO2\nM99 P7\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
    EXPECT_EQ(result.code(2), "::N5:: jump = M98({p=2}, true) if jump then goto computed end");
    EXPECT_EQ(result.code(3), "jump = G65({p=2, a=1}, true) if jump then goto computed end");
    EXPECT_EQ(result.code(6),
              "do return end ::computed:: if jump == 5 then goto N5 end if jump == 7 then goto N7 end "
              "no_target(jump) "
              "end) program(2, function()");
    EXPECT_EQ(result.code(7), "do return (M99{p=7}) end");
}

/// The words GOTO and M99 are searched for in parts of the file: they must be found across the border of two.
TEST(JumpScan, FindsJumpAcrossBufferBoundary) {
    for (const std::string& jump :
         {std::string("GOTO5"), std::string("M99P5"), std::string("M 0 9 9P5"), std::string("goto 5")}) {
        const std::string text = jump == "M 0 9 9P5" ? "M 099 P5" : jump;
        for (std::size_t at = 16370; at < 16390; ++at) {
            // The text before the jump holds none of its letters.
            std::string gcode = "N5 X1\n";
            while (gcode.size() < at) gcode += gcode.size() % 60 == 59 && gcode.size() + 1 < at ? '\n' : ' ';
            gcode += text + "\n";
            const Translated result = translated(gcode);
            ASSERT_TRUE(result.ok) << text << " at " << at << ": " << result.messages;
        }
    }
}

TEST(JumpScan, FindsJumpAtEndOfFirstBuffer) {
    std::string gcode = "N5 X1\n";
    while (gcode.size() < 16383) gcode += gcode.size() < 16380 ? "X1\n" : " ";
    EXPECT_TRUE(translated(gcode + "GOTO5\n").ok) << "G is the last letter of the first piece";
    EXPECT_TRUE(translated(gcode.substr(0, 16382) + "GOTO5\n").ok);
}

}  // namespace
}  // namespace gsim::codegen::macro_statements_test
