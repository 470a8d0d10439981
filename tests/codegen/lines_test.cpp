// Properties of any program: its lines, the same Lua twice, and Lua that compiles.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/random_program.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::lines_test {
namespace {

std::ptrdiff_t lines(std::string_view text) {
    const bool open_end = !text.empty() && text.back() != '\n';
    return std::count(text.begin(), text.end(), '\n') + (open_end ? 1 : 0);
}

void expect_promises(const std::string& gcode, bool annotate) {
    TranslateOptions options;
    options.annotate = annotate;
    const Translated first = translated(gcode, options);
    const Translated second = translated(gcode, options);
    ASSERT_EQ(first.messages, second.messages) << gcode;
    ASSERT_EQ(first.lua, second.lua) << gcode;
    ASSERT_TRUE(first.ok) << first.messages << gcode;
    ASSERT_EQ(lines(first.lua), lines(gcode) + 2) << gcode << "\n" << first.lua;
    ASSERT_EQ(compile_error(first.lua), std::nullopt) << gcode << "\n" << first.lua;
    const ScriptOrigin origin = script_origin(first.lua);
    ASSERT_TRUE(origin.unedited) << gcode;
}

TEST(RandomPrograms, TranslateLineByLineToValidLua) {
    std::mt19937 random(7);
    for (int i = 0; i < 400; ++i) {
        const std::string gcode = random_program(random, {});
        ASSERT_NO_FATAL_FAILURE(expect_promises(gcode, i % 2 == 1)) << "program " << i;
    }
}

TEST(RandomPrograms, ErrorGivesMessageAndNoLua) {
    std::mt19937 random(8);
    for (int i = 0; i < 200; ++i) {
        const std::string gcode = random_program(random, {.errors = true});
        const Translated result = translated(gcode);
        ASSERT_EQ(result.ok, result.messages.find("error: ") == std::string::npos) << gcode;
        ASSERT_EQ(result.lua.empty(), !result.ok) << gcode;
        ASSERT_EQ(result.messages.find("gave up"), std::string::npos) << gcode;
    }
}

/// Each block marks itself by the value of X; its Lua must be one line further down.
TEST(Lines, EveryBlockIsOneLineLowerInLua) {
    const std::string gcode = "%\nO1\n\n(first)\nX5\r\n\r\nX7;Y7\n/X8\n%\nO2 X10\nX11";
    const Translated result = translated(gcode);
    ASSERT_TRUE(result.ok) << result.messages;
    for (const int line : {5, 7, 8, 10, 11})
        EXPECT_NE(result.code(static_cast<std::size_t>(line)).find(fmt::format("x={}", line)),
                  std::string::npos)
            << "line " << line << "\n"
            << result.lua;
    EXPECT_EQ(result.code(7), "move{x=7} move{y=7}") << "two blocks of one line stay in one line";
    EXPECT_EQ(result.code(12), "end)") << "the last line";
}

TEST(Lines, ShortestProgramsCompile) {
    for (const std::string gcode :
         {"", "\n", "%", "%\n%", "X1", ";", "O1", "(c)", "\r", "\r\n", "N5", ";;\n;"})
        expect_promises(gcode, false);
}

TEST(Lines, JumpsReturnsAndLoopsCompile) {
    for (const std::string gcode :
         {"#1=1\n#2=2\n", "GOTO1\nN1\n", "N1\nIF[1]GOTO1\nM99\nX1\n", "M99;M99\n", "M99 X1\nGOTO 3;N3\n",
          "N1 GOTO#1\n", "WHILE[1]DO1;END1;WHILE[1]DO1;END1", "O1;O2;O3", "O1\nGOTO#1\nO2\nN1GOTO1\n"})
        expect_promises(gcode, false);
}

}  // namespace
}  // namespace gsim::codegen::lines_test
