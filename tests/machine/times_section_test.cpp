// [times] of machine files.

#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::times_section_test {
namespace {

std::string machine_with(const std::string& tables) {
    return "[machine]\nname = \"m\"\n" + tables + "\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndh = {}\n";
}

std::string error_with(const std::string& times) {
    const auto machine = read_machine(machine_with("[times]\n" + times), "m.toml");
    return machine ? "no error" : machine.error().message;
}

TEST(TimesSection, ReadsNamesAndCodes) {
    const auto machine = read_machine(
        machine_with(
            "[times]\ntool_change_s = 8\ntool_table_s = 0.0625\ncoolant_on_s = 0.5\nspindle_start_s = "
            "2.5\nspindle_stop_s = 1.5\n"
            "process_on_s = 0.3\nprocess_off_s = 0.2\nbefore_first_move = false\nM100 = 4\nM8 = 0\n"),
        "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    const WordTimes& times = machine->times;
    EXPECT_EQ(times.tool_change_s, 8);
    EXPECT_EQ(times.tool_table_s, 0.0625);
    EXPECT_EQ(times.coolant_on_s, 0.5);
    EXPECT_EQ(times.coolant_off_s, 0);
    EXPECT_EQ(times.spindle_start_s, 2.5);
    EXPECT_EQ(times.spindle_stop_s, 1.5);
    EXPECT_EQ(times.process_on_s, 0.3);
    EXPECT_EQ(times.process_off_s, 0.2);
    EXPECT_FALSE(times.before_first_move);
    EXPECT_EQ(times.codes_s, (std::map<int, double>{{8, 0}, {100, 4}}));
    const auto repeated = read_machine(print_machine(*machine), "printed");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
}

TEST(TimesSection, WordsTakeNoTimeWithoutSection) {
    const auto machine = read_machine(machine_with(""), "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->times, WordTimes{});
    EXPECT_EQ(print_machine(*machine).find("[times]"), std::string::npos);
}

TEST(TimesSection, RejectsInvalidKeysAndValues) {
    EXPECT_EQ(error_with("tool_changes_s = 1"),
              "m.toml:4:1: unknown key 'tool_changes_s' in [times]; did you mean 'tool_change_s'?");
    EXPECT_EQ(error_with("M1000 = 1").substr(0, 33), "m.toml:4:1: unknown key 'M1000' i");
    EXPECT_NE(error_with("G4 = 1").find("unknown key 'G4'"), std::string::npos);
    EXPECT_NE(error_with("tool_change_s = -1").find("'tool_change_s' must be"), std::string::npos);
    EXPECT_NE(error_with("M6 = -1").find("'M6' must be"), std::string::npos);
    EXPECT_NE(error_with("M6 = inf").find("'M6' must be"), std::string::npos);
    EXPECT_NE(error_with("M6 = \"long\"").find("'M6' must be a number"), std::string::npos);
    EXPECT_NE(error_with("before_first_move = 1").find("true or false"), std::string::npos);
}

}  // namespace
}  // namespace gsim::machine::times_section_test
