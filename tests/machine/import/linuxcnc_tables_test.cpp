// LinuxCNC's files of parameters and tools as machine data.

#include "machine/import/linuxcnc_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::import::linuxcnc_tables_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct ImportedTable {
    machine::MachineData data;
    ImportNotes notes;
    std::string error;
};

ImportedTable parameters(const std::string& text, double unit_mm = 1, std::string_view axes = "XYZ") {
    ImportedTable taken;
    const auto done = import_parameters(text, "mill.var", unit_mm, axes, taken.data, taken.notes);
    if (!done) taken.error = done.error().message;
    return taken;
}

ImportedTable tools(const std::string& text, double unit_mm = 1, std::string_view axes = "XYZ") {
    ImportedTable taken;
    const auto done = import_tools(text, "mill.tbl", unit_mm, axes, taken.data, taken.notes);
    if (!done) taken.error = done.error().message;
    return taken;
}

TEST(LinuxcncParameters, ImportsWorkOffsetsPointsAndVariables) {
    const ImportedTable taken = parameters(
        "31\t2.5\n5161\t10\n5183\t-4\n5210\t1\n5211\t3\n5220\t2\n5241\t-20\n5243\t7\n5250\t45\n5061\t9\n", 1);
    EXPECT_EQ(taken.error, "");
    EXPECT_EQ(
        taken.data.offsets,
        (std::map<std::string, machine::AxisValues, std::less<>>{{"55", {{'X', -20}, {'Y', 0}, {'Z', 7}}}}));
    const auto& variables = taken.data.variables;
    EXPECT_EQ(variables.at(31), 2.5);
    EXPECT_NEAR(variables.at(5161), 10 / 25.4, 1e-12);
    EXPECT_NEAR(variables.at(5183), -4 / 25.4, 1e-12);
    EXPECT_EQ(variables.at(5210), 1);
    EXPECT_NEAR(variables.at(5211), 3 / 25.4, 1e-12);
    EXPECT_EQ(variables.at(5250), 45);
    EXPECT_EQ(variables.count(5061), 0U) << "the result of a probe is not kept";
    EXPECT_THAT(taken.notes.left_out, ElementsAre("#5220 = 2: runs begin in G54, not in that system"));
}

TEST(LinuxcncParameters, ReportsValuesOfMissingAxis) {
    EXPECT_THAT(parameters("5225 90\n").notes.left_out,
                ElementsAre("B of G54: the machine does not have this axis"));
    EXPECT_THAT(parameters("5225 0\n").notes.left_out, IsEmpty());
    EXPECT_EQ(parameters("5225 90\n5221 1\n", 25.4, "XYZB").data.offsets.at("54").at('B'), 90);
}

TEST(LinuxcncParameters, ReportsInvalidLineWithLocation) {
    EXPECT_EQ(parameters("5161 0\nX 5\n").error,
              "mill.var:2: 'X 5' must be the number of a parameter and its value");
}

TEST(LinuxcncTools, ImportsWordsOfTool) {
    const ImportedTable taken =
        tools("; mine\nT1 P1 D0.25 Z+2.5 X-0.5 I30 J-60 Q3 ;turning\n\nT12 P12 Z1\n", 25.4);
    EXPECT_EQ(taken.error, "");
    const machine::Tool& tool = taken.data.tools.at(1);
    EXPECT_NEAR(tool.length_mm, 63.5, 1e-12);
    EXPECT_NEAR(tool.diameter_mm, 6.35, 1e-12);
    EXPECT_NEAR(tool.offsets.at('X'), -12.7, 1e-12);
    EXPECT_EQ(tool.front_angle_deg, 30);
    EXPECT_EQ(tool.back_angle_deg, -60);
    EXPECT_EQ(tool.orientation, 3);
    EXPECT_EQ(taken.data.tools.size(), 2U);
    EXPECT_THAT(taken.notes.left_out, IsEmpty());
}

TEST(LinuxcncTools, ReportsIgnoredAndInvalidWords) {
    EXPECT_THAT(tools("T0 P0 Z1\nT1 P4 A5\n").notes.left_out,
                ElementsAre("T0: tool numbers start at 1", "A of tool 1: the machine does not have this axis",
                            "P4 of tool 1: magazine pockets"));
    EXPECT_EQ(tools("T1 P1 Z2 K5\n").error,
              "mill.tbl:1: 'K5' is not a word of a tool: T P D X Y Z A B C U V W I J Q, each with a number");
    EXPECT_EQ(tools("P1 Z2\n").error, "mill.tbl:1: a tool needs its number T");
    EXPECT_EQ(tools("T1 Q12\n").error, "mill.tbl:1: Q12 is not a valid orientation, which must be 0 to 9");
}

}  // namespace
}  // namespace gsim::import::linuxcnc_tables_test
