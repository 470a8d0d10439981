// O-words of RS274/NGC as control structures of Lua, and one error for wrong nesting.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::oword_flow_test {
namespace {

/// Returns the consecutive Lua lines, without the first and the last line of the script.
std::string body(const std::string& gcode) {
    const Translated result = translated_ngc(gcode);
    if (!result.ok) return result.messages;
    EXPECT_EQ(compile_error(result.lua), std::nullopt) << result.lua;
    std::string out;
    const auto lines = static_cast<std::size_t>(std::count(gcode.begin(), gcode.end(), '\n'));
    for (std::size_t line = 1; line <= lines; ++line) out += result.code(line) + "\n";
    return out;
}

TEST(OWordFlow, SubroutinesBecomeLuaFunctions) {
    EXPECT_EQ(body("o100 sub\nG0 X#1\no100 endsub\no100 call [1+2] [#5]\n"),
              "sub(100, function()\nG0{x=v[1]}\nend)\nprogram(nil, function() call(100, 1.0 + 2.0, v[5])\n");
    EXPECT_EQ(body("X1\no100 call\nM2\no100 sub\nG0 X#1\no100 endsub\n"),
              "move{x=1}\ncall(100)\nM2()\nend) sub(100, function()\nG0{x=v[1]}\nend)\n");
    EXPECT_EQ(body("X1\no1 sub\no1 endsub\n(rest)\nX2\no2 sub\no2 endsub\n(MSG,a)\n"),
              "move{x=1}\nend) sub(1, function()\nend)\n\nmore(function() move{x=2}\n"
              "end) sub(2, function()\nend)\nmore(function() MSG(\"a\")\n");
    EXPECT_EQ(body("o<A b> sub\no<ab> return [#1]\no<ab> endsub [2]\nO0100 call\n"),
              "sub(\"ab\", function()\ndo return result(v[1]) end\ndo return result(2.0) end end)\n"
              "program(nil, function() call(100)\n");
    EXPECT_EQ(body("o1 sub\no2 if [#1]\no1 return\no2 endif\no1 endsub\n"),
              "sub(1, function()\nif truth(v[1]) then\ndo return end\nend\nend)\n");
    EXPECT_EQ(translated_ngc("o1 sub\no1 endsub\no01 sub\no1 endsub\n").messages,
              "3:1: error: the subroutine o1 is defined twice in this file, first in line 1\n");
}

TEST(OWordFlow, CallsTakeComputedAndNamedTargets) {
    EXPECT_EQ(body("o[#1+1] call [2]\no#<a> call\n"), "call(v[1] + 1.0, 2.0)\ncall(p.a)\n");
    EXPECT_EQ(body("o1234567890 call\n"), "call(\"1234567890\")\n") << "too long for a number";
    EXPECT_EQ(body("o<100> call\no<1.5> call\n"), "call(100)\ncall(\"1.5\")\n");
}

TEST(OWordFlow, ConditionsBecomeLuaIf) {
    EXPECT_EQ(
        body("o1 if [#1 GT 2]\nX1\no1 elseif [#1 EQ 2]\nX2\no1 else\nX3\no1 endif\n"),
        "if v[1] > 2.0 then\nmove{x=1}\nelseif equal(v[1], 2.0) then\nmove{x=2}\nelse\nmove{x=3}\nend\n");
    EXPECT_EQ(body("o01 if [#1]\no1 endif\n"), "if truth(v[1]) then\nend\n") << "zeros before a number";
    EXPECT_EQ(body("o1 if [#1 AND #2]\no1 endif\n"), "if truth(AND(v[1], v[2])) then\nend\n");
    EXPECT_EQ(body("o1 if [#1 NE 1 AND #2 LT 3]\no1 endif\n"),
              "if (not equal(v[1], 1.0)) and (v[2] < 3.0) then\nend\n");
}

TEST(OWordFlow, LoopsBecomeLuaLoops) {
    EXPECT_EQ(body("o1 while [#1 LT 5]\nX1\no1 endwhile\n"), "while v[1] < 5.0 do\nmove{x=1}\nend\n");
    EXPECT_EQ(body("o1 do\nX1\no1 while [#1 LT 5]\n"), "repeat\nmove{x=1}\nuntil not (v[1] < 5.0)\n");
    EXPECT_EQ(body("o1 repeat [#1]\nX1\no1 endrepeat\n"), "for _ = 1, times(v[1]) do\nmove{x=1}\nend\n");
    EXPECT_EQ(body("o1 do\no2 do\no2 while [1]\no1 while [#1]\n"),
              "repeat\nrepeat\nuntil not (truth(1.0))\nuntil not (truth(v[1]))\n");
    EXPECT_EQ(body("o1 do\no2 while [1]\no2 endwhile\no1 while [0]\n"),
              "repeat\nwhile truth(1.0) do\nend\nuntil not (truth(0.0))\n");
}

TEST(OWordFlow, TranslatesBreakAndContinue) {
    EXPECT_EQ(
        body("o1 while [1]\no2 if [#1]\no1 break\no2 else\no1 continue\no2 endif\no1 endwhile\n"),
        "while truth(1.0) do\nif truth(v[1]) then\nbreak\nelse\ngoto continue_1\nend\n::continue_1:: end\n");
    EXPECT_EQ(body("o1 do\no1 continue\no1 break\no1 while [#1]\n"),
              "repeat\ngoto continue_1\nbreak\n::continue_1:: until not (truth(v[1]))\n");
    EXPECT_EQ(body("o1 repeat [2]\no1 break\no1 continue\no1 endrepeat\n"),
              "for _ = 1, times(2.0) do\nbreak\ngoto continue_1\n::continue_1:: end\n");
}

TEST(OWordFlow, BreakAndContinueLeaveNestedLoops) {
    EXPECT_EQ(body("o1 while [1]\no2 repeat [3]\no3 if [#1]\no1 break\no3 endif\no1 continue\no2 endrepeat\n"
                   "o1 endwhile\nX1\n"),
              "while truth(1.0) do\nfor _ = 1, times(3.0) do\nif truth(v[1]) then\ngoto break_1\nend\n"
              "goto continue_1\nend\n::continue_1:: end ::break_1::\nmove{x=1}\n");
    EXPECT_EQ(body("o1 do\no2 do\no1 break\no2 while [1]\no1 while [1]\n"),
              "repeat\nrepeat\ngoto break_1\nuntil not (truth(1.0))\nuntil not (truth(1.0)) ::break_1::\n");
    // The same name again, and in a subroutine: labels must not meet.
    const std::string loop = "o1 while [1]\no2 while [1]\no1 break\no1 continue\no2 endwhile\no1 endwhile\n";
    EXPECT_EQ(compile_error(translated_ngc(loop + loop + "o9 sub\n" + loop + "o9 endsub\n" + loop).lua),
              std::nullopt);
}

std::string messages(const std::string& gcode) {
    const Translated result = translated_ngc(gcode);
    EXPECT_FALSE(result.ok) << gcode;
    return result.messages;
}

TEST(OWordFlow, WrongNestingReportsOneError) {
    EXPECT_EQ(messages("o1 endif\no2 endwhile\no3 endsub\n"), "1:1: error: o1 endif has no beginning\n");
    EXPECT_EQ(messages("o1 if [1]\no2 while [1]\no1 endif\no2 endwhile\n"),
              "3:1: error: o1 endif does not close o2 while, which is open since line 2\n");
    EXPECT_EQ(messages("o1 if [1]\no2 endif\no1 endif\n"),
              "2:1: error: o2 endif does not close o1 if, which is open since line 1\n");
    EXPECT_EQ(messages("o1 if [1]\nX1\n"), "1:1: error: o1 if is not closed\n");
    EXPECT_EQ(messages("o1 do\no2 if [1]\no1 while [0]\no2 endif\n"),
              "3:1: error: o1 while does not close o2 if, which is open since line 2\n");
    EXPECT_EQ(messages("o1 sub\no2 sub\no2 endsub\no1 endsub\n"),
              "2:1: error: a subroutine must not begin inside another one or inside a control structure\n");
    EXPECT_EQ(messages("o1 if [1]\no2 sub\no2 endsub\no1 endif\n"),
              "2:1: error: a subroutine must not begin inside another one or inside a control structure\n");
    EXPECT_EQ(messages("o1 else\n"), "1:1: error: there is no open o1 if for this word\n");
    EXPECT_EQ(messages("o1 if [1]\no2 else\no1 endif\n"),
              "2:1: error: there is no open o2 if for this word\n");
    EXPECT_EQ(messages("o1 if [1]\no1 else\no1 elseif [1]\no1 endif\n"),
              "3:1: error: only endif may follow else\n");
    EXPECT_EQ(messages("o1 if [1]\no1 else\no1 else\no1 endif\n"),
              "3:1: error: only endif may follow else\n");
    EXPECT_EQ(messages("o1 return\n"), "1:1: error: return must be inside a subroutine\n");
    EXPECT_EQ(messages("o1 break\n"), "1:1: error: there is no loop o1 around this block\n");
    EXPECT_EQ(messages("o1 if [1]\no1 continue\no1 endif\n"),
              "2:1: error: there is no loop o1 around this block\n");
    EXPECT_EQ(messages("o1 while [1]\no2 sub\no1 break\no2 endsub\no1 endwhile\n"),
              "2:1: error: a subroutine must not begin inside another one or inside a control structure\n");
}

TEST(OWordFlow, BlockErrorCausesNoSecondError) {
    EXPECT_EQ(messages("o1 if [1 +]\no1 endif\n"), "1:11: error: ']' is not allowed here\n");
    EXPECT_EQ(messages("o1 if\nX1\no1 endif\n"),
              "1:4: error: this keyword must be followed by its condition in brackets\n");
    EXPECT_EQ(messages("o1 while [1]\nX1 X2\no1 endwhile\n"), "2:4: error: X is given twice in the block\n");
    EXPECT_EQ(messages("o1 sub\no1 endsub [1] [2]\n"),
              "2:4: error: this keyword must be followed by at most one value\n");
    EXPECT_EQ(messages("o1 if [1]\no1\no2 endif\n"),
              "1:1: error: o1 if is not closed\n3:1: error: o2 endif has no beginning\n")
        << "a new program begins anew";
}

TEST(OWordFlow, RejectsBlockDeleteBeforeStructure) {
    const std::string message =
        "block delete '/' must not precede a program or a control structure: its end would be lost";
    for (const char* keyword : {"sub", "endsub", "if [1]", "else", "elseif [1]", "endif", "while [1]",
                                "endwhile", "do", "repeat [1]", "endrepeat"}) {
        const std::string text = messages(fmt::format("/o1 {}\n", keyword));
        EXPECT_NE(text.find(message), std::string::npos) << keyword << ": " << text;
    }
    EXPECT_EQ(body("/o1 call [2]\n"), "if not skipped(1) then call(1, 2.0) end\n");
    EXPECT_EQ(body("o1 sub\n/o1 return [2]\no1 endsub\n"),
              "sub(1, function()\nif not skipped(1) then do return result(2.0) end end\nend)\n");
    EXPECT_EQ(
        body("o1 while [1]\n/o1 break\n/o1 continue\no1 endwhile\n"),
        "while truth(1.0) do\nif not skipped(1) then break end\nif not skipped(1) then goto continue_1 end\n"
        "::continue_1:: end\n");
}

TEST(OWordFlow, TranslatesNumberedPrograms) {
    EXPECT_EQ(body("o1\nM98 P2 L3\nM2\no0002\nX1\nM99\n"),
              "program(1, function()\nM98{p=2, l=3}\nM2()\nend) program(2, function()\nmove{x=1}\n"
              "do return (M99()) end\n");
    EXPECT_EQ(translated_ngc("o1\nM2\no01\n").messages,
              "3:1: warning: the program O1 is defined twice in this file; M98 P1 calls the first one after "
              "the main program\n");
    EXPECT_EQ(translated_ngc("o1\nM2\no<01>\n").messages, "") << "a name";
}

TEST(OWordFlow, IgnoresTextAfterEndOfMainProgram) {
    EXPECT_EQ(body("M2\nnot read @\no1 sub\nX1\no1 endsub\n"),
              "M2()\n\nend) sub(1, function()\nmove{x=1}\nend)\n");
    EXPECT_EQ(body("/M2\nX1\n"), "if not skipped(1) then M2() end\nmove{x=1}\n") << "may be left out";
    EXPECT_EQ(body("o1 if [#1]\nM2\no1 endif\nX1\n"), "if truth(v[1]) then\nM2()\nend\nmove{x=1}\n");
    EXPECT_EQ(body("o1 sub\nM30\no1 endsub\nX1\n"),
              "sub(1, function()\nM30()\nend)\nprogram(nil, function() move{x=1}\n");
}

struct Kind {
    const char* open;
    const char* close;
};

/// `depth` structures of a kind around a block, in a subroutine.
std::string nested(const Kind& kind, int depth, const std::string& block) {
    std::string gcode = "o9999 sub\n";
    for (int i = 0; i < depth; ++i) gcode += fmt::format("o{} {}\n", i, kind.open);
    gcode += block + "\n";
    for (int i = depth - 1; i >= 0; --i) gcode += fmt::format("o{} {}\n", i, kind.close);
    return gcode + "o9999 endsub\n";
}

std::string repeated(const std::string& fragment, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += fragment;
    return text;
}

/// Nesting that Lua could not read, or with more variables than it holds, must be our error.
TEST(OWordFlow, DeepNestingCompilesOrIsReported) {
    std::string settings;
    for (int i = 0; i < 50; ++i) settings += fmt::format("#[#{}+1]=#{} ", 1000 + i, 2000 + i);
    const std::string blocks[] = {
        "X1",
        "/1 #1=[" + repeated("1 NE [", 40) + "1" + repeated("]", 40) + "]",
        "#1=[" + repeated("2**[1 EQ [", 25) + "1" + repeated("]]", 25) + "]",
        "X[" + repeated("SIN[1+2*", 30) + "#1" + repeated("]", 30) + "]",
        "X" + repeated("#", 140) + "1",
        settings,
        "X[1+[2/#3]] " + settings.substr(0, settings.find("#[#1025")),
        settings.substr(0, 300) + "#1=[" + repeated("1 NE [", 30) + "1" + repeated("]", 30) + "]",
        "(DEBUG," + repeated("#1#<a>", 25) + ")",
        "o7777 call " + repeated("[1 NE [2**[#1/[#2]]]]", 30)};
    int accepted = 0;
    int reported = 0;
    for (const Kind kind : {Kind{"if [1 NE 2]", "endif"}, Kind{"while [1]", "endwhile"},
                            Kind{"repeat [2]", "endrepeat"}, Kind{"do", "while [0]"}}) {
        for (int depth = 1; depth < 130; depth += depth < 70 || depth > 82 ? 5 : 1) {
            for (const std::string& block : blocks) {
                const Translated result = translated_ngc(nested(kind, depth, block));
                ++(result.ok ? accepted : reported);
                if (!result.ok) continue;
                ASSERT_EQ(compile_error(result.lua), std::nullopt) << depth << " " << kind.open << "\n"
                                                                   << block;
            }
        }
    }
    EXPECT_GT(accepted, 200);
    EXPECT_GT(reported, 200);
    const Kind repeat{"repeat [2]", "endrepeat"};
    EXPECT_TRUE(translated_ngc(nested(repeat, 15, "X1")).ok);
    EXPECT_EQ(translated_ngc(nested(repeat, 16, "X1")).messages,
              "17:1: error: O-words are nested too deep for Lua\n");
    EXPECT_TRUE(translated_ngc(nested({"if [1]", "endif"}, 77, "X1")).ok);
}

TEST(OWordFlow, RejectsLoopTooLongForLua) {
    std::string loop = "o1 while [#1]\n";
    for (int i = 0; i < 650000; ++i) loop += "X1Y2Z3B4\n";
    EXPECT_EQ(messages(loop + "o1 endwhile\n"),
              "1:1: error: o1 while up to line 650002 is too long for Lua; move its body to a subroutine\n");
}

}  // namespace
}  // namespace gsim::codegen::oword_flow_test
