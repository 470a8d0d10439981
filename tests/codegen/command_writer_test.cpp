// Programs of one command a line (Klipper) and the Lua that becomes of them.

#include <string>

#include <gtest/gtest.h>

#include "codegen/lua/command_line.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::command_writer_test {
namespace {

Translated klipper(std::string_view text) {
    TranslateOptions options;
    options.dialect = &grammar::dialect_klipper();
    return translated(text, options);
}

std::string lua_of_line(std::string_view line) {
    const Translated result = klipper(line);
    return result.ok ? result.code(1) : result.messages;
}

TEST(CommandLine, SplitsIntoCommandAndParameters) {
    const CommandLine line = command_line("  g1X10 Y-5.5 ; go\r");
    EXPECT_EQ(line.command, "G1");
    ASSERT_EQ(line.parameters.size(), 2u);
    EXPECT_EQ(line.parameters[0].key, "X");
    EXPECT_EQ(line.parameters[0].value, "10");
    EXPECT_EQ(line.parameters[1].key, "Y");
    EXPECT_EQ(line.parameters[1].value, "-5.5");
    EXPECT_EQ(line.parameters[1].column, 9u);
    EXPECT_EQ(line.remark, "go");
}

TEST(CommandLine, SkipsLineNumberBeforeCommand) {
    EXPECT_EQ(command_line("N10 G1 X5").command, "G1");
    EXPECT_EQ(command_line("N10").command, "N10");
    EXPECT_EQ(command_line("").command, "");
    EXPECT_EQ(command_line(" ; only this").command, "");
    EXPECT_EQ(command_line("%").command, "%");
    EXPECT_EQ(command_line("(a remark)").command, "(A");
}

TEST(CommandLine, SplitsNamedParametersAtBlanks) {
    std::vector<Parameter> parameters;
    const std::string text = "SET_VELOCITY_LIMIT accel=500  VELOCITY=\"20\" # so";
    ASSERT_TRUE(named_parameters(command_line(text), parameters));
    ASSERT_EQ(parameters.size(), 2u);
    EXPECT_EQ(parameters[0].key, "ACCEL");
    EXPECT_EQ(parameters[0].value, "500");
    EXPECT_EQ(parameters[1].value, "20");
    EXPECT_FALSE(named_parameters(command_line("SET_VELOCITY_LIMIT ACCEL"), parameters));
}

TEST(CommandWriter, WritesOneCallPerLine) {
    EXPECT_EQ(lua_of_line("G1 X10 Y+5 F600"), "G1{x=10, y=5, f=600}");
    EXPECT_EQ(lua_of_line("g0x.5e-1"), "G0{x=.5, e=-1}");
    EXPECT_EQ(lua_of_line("M400"), "M400()");
    EXPECT_EQ(lua_of_line("SET_VELOCITY_LIMIT ACCEL=500 MINIMUM_CRUISE_RATIO=0"),
              "SET_VELOCITY_LIMIT{accel=500, minimum_cruise_ratio=0}");
    EXPECT_EQ(lua_of_line("SAVE_GCODE_STATE NAME=before"), "SAVE_GCODE_STATE{name=\"before\"}");
}

TEST(CommandWriter, WritesLineNToLuaLineNPlus1) {
    const Translated result = klipper("G21\n\n; so\nG1 X1\nG1 X2");
    EXPECT_EQ(result.code(1), "G21()");
    EXPECT_EQ(result.code(2), "");
    EXPECT_EQ(result.code(4), "G1{x=1}");
    EXPECT_EQ(result.code(5), "G1{x=2}");
    EXPECT_EQ(result.code(6), "end)");
    EXPECT_EQ(result.lua.substr(0, 66),
              "local _ENV = require \"gsim.klipper\" program(nil, function() -- fro");
    EXPECT_EQ(result.messages, "");
}

// Klipper reads on past these; a warning reports each once.
TEST(CommandWriter, WarnsOnceWithCountAboutIgnoredWords) {
    const Translated result = klipper("G21 G90 G94\nM6\nX40\nM6\nG4 S2\nG01 X5\nG28\n");
    EXPECT_TRUE(result.ok);
    EXPECT_EQ(result.code(1), "G21()");
    EXPECT_EQ(result.code(2), "");
    EXPECT_EQ(result.code(3), "");
    EXPECT_EQ(result.code(5), "G4()");
    EXPECT_EQ(result.messages,
              "1:5: warning: Klipper reads one command per line: G90 after G21 has no effect (1 in total)\n"
              "1:9: warning: Klipper reads one command per line: G94 after G21 has no effect (1 in total)\n"
              "2:1: warning: M6 is not a motion or dwell command of Klipper: no effect (2 in total)\n"
              "3:1: warning: X40 is not a motion or dwell command of Klipper: no effect (1 in total)\n"
              "5:4: warning: Klipper does not read S of G4: no effect (1 in total)\n"
              "6:1: warning: G01 is not a motion or dwell command of Klipper: no effect (1 in total)\n"
              "7:1: warning: G28 (homing) is not simulated: no effect (1 in total)\n");
}

TEST(CommandWriter, UsesLastOfRepeatedParameter) {
    const Translated result = klipper("G1 X5 X7\n");
    EXPECT_EQ(result.code(1), "G1{x=7}");
    EXPECT_EQ(result.messages,
              "1:7: warning: X is given twice after G1: the last one is used (1 in total)\n");
}

TEST(CommandWriter, RejectsMalformedParameters) {
    EXPECT_TRUE(lua_of_line("G1 X10 (a remark)")
                    .starts_with("1:4: error: '10 (' after X is not a number, which ends the program\n"));
    EXPECT_EQ(lua_of_line("G1 Y"), "1:4: error: '' after Y is not a number, which ends the program\n");
    EXPECT_EQ(lua_of_line("SET_VELOCITY_LIMIT ACCEL"),
              "1:1: error: SET_VELOCITY_LIMIT requires its parameters as NAME=VALUE\n");
}

TEST(CommandWriter, RejectsTooLongLine) {
    const Translated result = klipper("G1 X1" + std::string(100'000, ' ') + "\nG1 X2\n");
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.messages, "1:1: error: the line has more than 65536 bytes\n");
}

}  // namespace
}  // namespace gsim::codegen::command_writer_test
