#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::axis_group_test {
namespace {

using testing::HasSubstr;

const std::string kAxes =
    "[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndirection = \"x\"\n"
    "[[axis]]\nletter = \"Y\"\nkind = \"linear\"\ndirection = \"y\"\n"
    "[[axis]]\nletter = \"C\"\nkind = \"rotary\"\ncarries = \"work\"\ndirection = \"z\"\n";  // lines 4 to 16

Result<Machine> machine_with(const std::string& groups, const std::string& inverse = "numeric") {
    return read_machine("[machine]\nname = \"m\"\ninverse = \"" + inverse + "\"\n" + kAxes + groups,
                        "m.toml");
}

std::string error_of(const std::string& groups, const std::string& inverse = "numeric") {
    const auto machine = machine_with(groups, inverse);
    return machine ? "no error" : machine.error().message;
}

TEST(AxisGroup, IsReadAndPrintedBack) {
    const auto machine = machine_with(
        "[[group]]\nname = \"table\"\naxes = [\"C\"]\nmotion = \"coordinated\"\n"
        "[[group]]\nname = \"track\"\naxes = [\"X\"]\n");
    ASSERT_TRUE(machine) << machine.error().message;
    ASSERT_EQ(machine->groups.size(), 2U);
    EXPECT_EQ(machine->groups[0], (AxisGroup{"table", {2}, GroupMotion::coordinated}));
    EXPECT_EQ(machine->groups[1], (AxisGroup{"track", {0}, GroupMotion::synchronous}));
    const auto repeated = read_machine(print_machine(*machine), "printed");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
}

TEST(AxisGroup, RejectsInvalidGroupsWithSourceLocation) {
    const std::string table = "[[group]]\nname = \"table\"\naxes = [\"C\"]\n";  // lines 17 to 19
    EXPECT_EQ(error_of("[[group]]\nname = \"t\"\naxes = [\"B\"]\n"),
              "m.toml:19:9: 'axes' must contain axis letters of this machine: X Y C");
    EXPECT_EQ(error_of("[[group]]\nname = \"t\"\naxes = []\n"),
              "m.toml:19:8: 'axes' must be a list of axis letters, such as [\"C\"]");
    EXPECT_EQ(error_of("[[group]]\nname = \"t\"\naxes = [\"X\", \"X\"]\n"),
              "m.toml:19:14: axis X is given twice");
    EXPECT_THAT(error_of("[[group]]\nname = \"t\"\naxes = [\"X\", \"C\"]\n"),
                HasSubstr("some of these axes carry the tool and some the work"));
    EXPECT_EQ(error_of(table + "[[group]]\nname = \"other\"\naxes = [\"C\"]\n"),
              "m.toml:22:9: axis C is already in the group 'table'; it may be in only one group");
    EXPECT_EQ(error_of(table + "[[group]]\nname = \"table\"\naxes = [\"X\"]\n"),
              "m.toml:21:8: two groups have the name 'table'; names must be unique");
    EXPECT_EQ(error_of("[[group]]\nname = \"roll\"\naxes = [\"C\"]\n"),
              "m.toml:18:8: 'roll' is a component of a pose; a group needs another name");
    EXPECT_THAT(error_of("[[group]]\nname = \"a b\"\naxes = [\"C\"]\n"), HasSubstr("letters, digits and _"));
    EXPECT_THAT(error_of(table + "motion = \"coupled\"\n"),
                HasSubstr("\"synchronous\", \"coordinated\" or \"independent\""));
    EXPECT_THAT(error_of(table + "motoin = \"coordinated\"\n"), HasSubstr("did you mean 'motion'?"));
    EXPECT_THAT(error_of("[[group]]\nname = \"t\"\n"), HasSubstr("[[group]] lacks the key 'axes'"));
    EXPECT_THAT(error_of(table + "motion = \"coordinated\"\n", "none"),
                HasSubstr("needs 'inverse = \"numeric\"'"));
    EXPECT_THAT(error_of(table + "[[group]]\nname = \"all\"\naxes = [\"X\", \"Y\"]\n"),
                HasSubstr("all axes are in groups"));
    EXPECT_EQ(error_of(table, "none"), "no error");
}

}  // namespace
}  // namespace gsim::machine::axis_group_test
