// [process] and [checks] of machine files.

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::process_section_test {
namespace {

std::string machine_with(const std::string& tables) {
    return "[machine]\nname = \"m\"\n" + tables + "\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndh = {}\n";
}

std::string error_with(const std::string& tables) {
    const auto machine = read_machine(machine_with(tables), "m.toml");
    return machine ? "no error" : machine.error().message;
}

std::string error_of_process(const std::string& on, const std::string& off = "[\"M9\"]") {
    return error_with("[process]\nkind = \"jet\"\non = " + on + "\noff = " + off);
}

TEST(ProcessSection, ReadsWordsAndChecks) {
    const auto machine =
        read_machine(machine_with("[process]\nkind = \"plasma\"\non = [\"M08\", \"m62 p0\"]\n"
                                  "off = [\"M9\"]\n[checks]\nend_with_process_on = false\n"),
                     "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    ASSERT_TRUE(machine->process);
    const Process& process = *machine->process;
    EXPECT_EQ(process.kind, ProcessKind::plasma);
    ASSERT_EQ(process.on.size(), 2U);
    EXPECT_EQ(process.on[0].text(), "M8");
    EXPECT_EQ(process.on[1].text(), "M62 P0");
    EXPECT_FALSE(process.checks.end_with_process_on);
    EXPECT_TRUE(process.checks.rapid_with_process_on);
    EXPECT_EQ(process.checks.dwell_s, 5);
    const auto repeated = read_machine(print_machine(*machine), "printed");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
}

TEST(ProcessSection, SpindleHasNoDwellLimit) {
    const auto machine = read_machine(
        machine_with("[process]\nkind = \"spindle\"\non = [\"M3\"]\noff = [\"M5\"]\n"), "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->process->checks.dwell_s, std::numeric_limits<double>::infinity());
    EXPECT_EQ(*read_machine(print_machine(*machine), "printed"), *machine);
}

TEST(ProcessSection, RejectsInvalidProcessAndChecks) {
    EXPECT_EQ(error_of_process("[\"G1\"]"),
              "m.toml:5:6: 'on' contains \"G1\", which is not an M code, such as \"M8\", or an M code with "
              "its required words, such as \"M62 P0\"");
    EXPECT_EQ(error_of_process("[\"M62 0\"]").substr(0, 34), "m.toml:5:6: 'on' contains \"M62 0\",");
    EXPECT_EQ(error_of_process("[\"M8.1\"]").substr(0, 33), "m.toml:5:6: 'on' contains \"M8.1\",");
    EXPECT_EQ(error_of_process("[]"), "m.toml:5:6: 'on' must be a list of M codes, such as [\"M8\"]");
    EXPECT_EQ(error_of_process("[8]"), "m.toml:5:6: 'on' must be a list of M codes, such as [\"M8\"]");
    EXPECT_EQ(error_of_process("[\"M9\"]", "[\"M5\", \"M9\"]"),
              "m.toml:6:7: M9 is both in 'on' and in 'off'");
    EXPECT_EQ(error_with("[process]\nkind = \"fire\""),
              "m.toml:4:8: 'kind' must be \"jet\", \"plasma\", \"laser\" or \"spindle\"");
    EXPECT_EQ(error_with("[process]\nkind = \"jet\"\non = [\"M8\"]"),
              "m.toml:3:1: [process] lacks the key 'off'");
    EXPECT_EQ(error_with("[checks]\ndwell_s = 3"),
              "m.toml:3:1: [checks] checks the machine's process, but there is no [process] that defines it");
    EXPECT_EQ(error_with("[process]\nkind = \"jet\"\non = [\"M8\"]\noff = [\"M9\"]\n[checks]\nrapid = false"),
              "m.toml:8:1: unknown key 'rapid' in [checks]; known keys: rapid_with_process_on, "
              "dwell_with_process_on, end_with_process_on, feed_with_process_off, dwell_s");
}

}  // namespace
}  // namespace gsim::machine::process_section_test
