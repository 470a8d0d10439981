#include "codegen/lua/expression_writer.h"

#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::expression_writer_test {
namespace {

/// The Lua of an expression.
std::string lua(const std::string& expression) {
    const std::string code = lua_of("#9=" + expression);
    const std::string start = "v[9] = ";
    return code.starts_with(start) ? code.substr(start.size()) : code;
}

TEST(Expressions, NumbersAreFloats) {
    EXPECT_EQ(lua("5"), "5.0");
    EXPECT_EQ(lua("5."), "5.");
    EXPECT_EQ(lua(".5"), ".5");
    EXPECT_EQ(lua("007"), "007.0");
    EXPECT_EQ(lua("123456789012345678901234"), "123456789012345678901234.0") << "no integer, so no overflow";
}

TEST(Expressions, MinusSignsCannotStartLuaComment) {
    EXPECT_EQ(lua("-5"), "(-5.0)");
    EXPECT_EQ(lua("2--5"), "2.0 - (-5.0)");
    EXPECT_EQ(lua("2-[-[-5]]"), "2.0 - (-(-5.0))");
    EXPECT_EQ(lua_of("X-[-5]"), "move{x=(-(-5.0))}");
    EXPECT_EQ(lua_of("X-#1"), "move{x=(-v[1])}");
}

TEST(Expressions, WritesBracketsOnlyIfNeeded) {
    EXPECT_EQ(lua("[1+2]*3"), "(1.0 + 2.0) * 3.0");
    EXPECT_EQ(lua("[1*2]+3"), "1.0 * 2.0 + 3.0");
    EXPECT_EQ(lua("1-[2-3]"), "1.0 - (2.0 - 3.0)");
    EXPECT_EQ(lua("[1-2]-3"), "1.0 - 2.0 - 3.0");
    EXPECT_EQ(lua("8/[4/2]"), "div(8.0, 4.0 / 2.0)");
    EXPECT_EQ(lua("6*[4/2]"), "6.0 * (4.0 / 2.0)");
    EXPECT_EQ(lua("-[1+2]"), "(-(1.0 + 2.0))");
}

TEST(Expressions, ChecksDivisorIfItMayBeZero) {
    EXPECT_EQ(lua("1/2"), "1.0 / 2.0");
    EXPECT_EQ(lua("1/0"), "div(1.0, 0.0)");
    EXPECT_EQ(lua("1/0.00"), "div(1.0, 0.00)");
    EXPECT_EQ(lua("1/#2*3"), "div(1.0, v[2]) * 3.0");
}

TEST(Expressions, WritesVariablesAndFunctions) {
    EXPECT_EQ(lua("#5"), "v[5]");
    EXPECT_EQ(lua("##5"), "v[v[5]]");
    EXPECT_EQ(lua("#[#1+2]"), "v[v[1] + 2.0]");
    EXPECT_EQ(lua("SQRT[#1]+RND[2]"), "SQRT(v[1]) + ROUND(2.0)");
    EXPECT_EQ(lua("ATAN[#1]/[2]"), "ATAN(v[1], 2.0)");
    EXPECT_EQ(lua("ATAN[#1]/2"), "ATAN(v[1]) / 2.0");
    EXPECT_EQ(lua("5 MOD 3 XOR #1"), "XOR(MOD(5.0, 3.0), v[1])");
    EXPECT_EQ(lua_of("#[#1]=#2 #3=4"), "v[v[1]] = v[2] v[3] = 4.0");
}

TEST(Expressions, ConvertsBetweenConditionsAndNumbers) {
    EXPECT_EQ(lua("[#1 EQ 5]+1"), "number(v[1] == 5.0) + 1.0");
    EXPECT_EQ(lua_of("IF[#1 NE #0]THEN X1"), "if v[1] ~= v[0] then move{x=1} end");
    EXPECT_EQ(lua_of("IF[#1]THEN X1"), "if truth(v[1]) then move{x=1} end");
    EXPECT_EQ(lua_of("IF[[#1 GT 1] AND [#2 LE 3]]THEN X1"),
              "if (v[1] > 1.0) and (v[2] <= 3.0) then move{x=1} end");
    EXPECT_EQ(lua_of("IF[[#1 GE 1] OR [#2 LT 3]]THEN X1"),
              "if (v[1] >= 1.0) or (v[2] < 3.0) then move{x=1} end");
    EXPECT_EQ(lua_of("IF[[#1 GE 1] XOR [#2 LT 3]]THEN X1"),
              "if (v[1] >= 1.0) ~= (v[2] < 3.0) then move{x=1} end");
    EXPECT_EQ(lua_of("IF[[#1 GE 1] AND 2]THEN X1"),
              "if truth(AND(number(v[1] >= 1.0), 2.0)) then move{x=1} end");
}

std::string repeated(std::string before, std::string_view fragment, int count) {
    std::string text = std::move(before);
    for (int i = 0; i < count; ++i) text += fragment;
    return text;
}

/// Lua reads some 200 levels of nesting; beyond, the message must be ours. Up to there, Lua must compile it.
TEST(Nesting, DeepExpressionsCompileOrAreReported) {
    int reported = 0;
    for (int depth = 1; depth < 100; ++depth) {
        const std::string close = repeated("", "]", depth) + "\n";
        for (const std::string& text :
             {repeated("X", "-", 9 * depth) + "#1\n", repeated("X", "#", 9 * depth) + "1\n",
              repeated("#1=", "[1+", depth) + "1" + close,
              repeated("#1=", "[1+2*[1/-", depth / 2) + "1" + repeated("", "]]", depth / 2) + "\n",
              repeated("#1=1", " MOD 2", 4 * depth) + "\n", repeated("#1=1", "/#2", 4 * depth) + "\n",
              repeated("#1=", "[1 EQ ", depth) + "1" + close,
              repeated("#1=", "SIN[1+2*", depth) + "1" + close,
              repeated("IF[[1 EQ 1]", " OR [1 EQ 2]", 3 * depth) + "]THEN X1\n"}) {
            const Translated result = translated(
                "O1\nWHILE[1]DO1\nWHILE[1]DO2\nWHILE[1]DO3\n/1 IF[1]THEN X1\n" + text + "END3\nEND2\nEND1\n");
            if (result.ok) {
                ASSERT_EQ(compile_error(result.lua), std::nullopt) << text;
            } else {
                ++reported;
                ASSERT_NE(
                    result.messages.find("nested too deep for Lua; assign a part of it to a variable first"),
                    std::string::npos)
                    << result.messages;
            }
        }
    }
    EXPECT_GT(reported, 0);
    EXPECT_TRUE(translated(repeated("#1=1", "+2*3-4", 300) + "\n").ok) << "long is not deep";
    EXPECT_TRUE(translated(repeated("#1=", "SIN[", 99) + "1" + repeated("", "]", 99) + "\n").ok);
}

}  // namespace
}  // namespace gsim::codegen::expression_writer_test
