#include "runtime/machine/machine_data.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/machine/machine_file.h"

namespace gsim::machine {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::string error_of(const std::string& text) {
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const auto data = read_machine_data(text, "m.txt", axes);
    return data ? "no error" : data.error();
}

TEST(MachineData, ReadsAllSections) {
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const auto data = read_machine_data(
        "; the fixtures\n\nNCFILE\r\nOFFSET\n54 200.0001 200.0002 200\n59.1 1 2 3 90 -45 # turned\n"
        "505\t1 -2 +3 90 inch\n\nFIXED\n7 1 2 3 Metric\nALIAS\nWaterJetOn M08\nVARIABLE\n100 "
        "2.5\nENDFILE\n\n",
        "m.txt", axes);
    ASSERT_TRUE(data) << data.error();
    EXPECT_THAT(data->offsets,
                ElementsAre(Pair("505", AxisValues{{'X', 25.4}, {'Y', -50.8}, {'Z', 3 * 25.4}, {'B', 90}}),
                            Pair("54", AxisValues{{'X', 200.0001}, {'Y', 200.0002}, {'Z', 200}}),
                            Pair("59.1", AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}, {'B', 90}, {'C', -45}})));
    EXPECT_THAT(data->fixed, ElementsAre(Pair(7, AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}})));
    EXPECT_THAT(data->aliases, ElementsAre(Pair("WaterJetOn", "M08")));
    EXPECT_THAT(data->variables, ElementsAre(Pair(100, 2.5)));
}

TEST(MachineData, WithoutAxesFurtherValuesAreOnlyChecked) {
    const auto data = read_machine_data("NCFILE\nOFFSET\n54 1 2 3 4 5 6\nENDFILE", "m.txt");
    ASSERT_TRUE(data) << data.error();
    EXPECT_THAT(data->offsets, ElementsAre(Pair("54", AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}})));
    EXPECT_FALSE(read_machine_data("NCFILE\nOFFSET\n54 1 2 3 4x\nENDFILE", "m.txt"));
}

TEST(MachineData, Frame) {
    EXPECT_EQ(error_of(""), "m.txt:1:1: the file does not begin with NCFILE");
    EXPECT_EQ(error_of("OFFSET\n"), "m.txt:1:1: the file does not begin with NCFILE");
    EXPECT_EQ(error_of("NCFILE\nOFFSET\n"), "m.txt:3:1: the file does not end with ENDFILE");
    EXPECT_EQ(error_of("NCFILE\nENDFILE\n54 1 2 3\n"), "m.txt:3:1: there is text behind ENDFILE");
    EXPECT_EQ(error_of("NCFILE\nNCFILE\n"), "m.txt:2:1: NCFILE may stand in the first line only");
    EXPECT_EQ(error_of("NCFILE x\n"), "m.txt:1:8: 'x' is one word too many");
}

TEST(MachineData, Tools) {
    const auto data = read_machine_data("NCFILE\nTOOL\n1 100 6\n22 1 0.25 inch\nENDFILE\n", "m.txt");
    ASSERT_TRUE(data) << data.error();
    ASSERT_EQ(data->tools.size(), 2U);
    EXPECT_EQ(data->tools.at(1).length_mm, 100);
    EXPECT_EQ(data->tools.at(1).diameter_mm, 6);
    EXPECT_DOUBLE_EQ(data->tools.at(22).length_mm, 25.4);
    EXPECT_DOUBLE_EQ(data->tools.at(22).diameter_mm, 6.35);
    EXPECT_EQ(error_of("NCFILE\nTOOL\n1 100\n"),
              "m.txt:3:1: a tool has its number, its length and its diameter");
    EXPECT_EQ(error_of("NCFILE\nTOOL\n1 1 1\n1 2 2\n"),
              "m.txt:4:1: the tool 1 is given twice; first in line 3");
}

TEST(MachineData, HomePositions) {
    const auto data = read_machine_data("NCFILE\nHOME\n2 1 2 3\n4 0 0 1 inch\nENDFILE\n", "m.txt");
    ASSERT_TRUE(data) << data.error();
    EXPECT_EQ(data->homes.at(2).at('Y'), 2);
    EXPECT_DOUBLE_EQ(data->homes.at(4).at('Z'), 25.4);
    EXPECT_EQ(error_of("NCFILE\nHOME\n1 1 2 3\n"),
              "m.txt:3:1: home positions are 2 to 4; the first one is in the machine file");
}

TEST(MachineData, Sections) {
    EXPECT_EQ(error_of("NCFILE\n OFSET\n"),
              "m.txt:2:2: 'OFSET' is no keyword; a section begins with OFFSET, FIXED, ALIAS, VARIABLE, TOOL "
              "or HOME; did you mean OFFSET?");
    EXPECT_EQ(
        error_of("NCFILE\n54 1 2 3\n"),
        "m.txt:2:1: '54' is no keyword; a section begins with OFFSET, FIXED, ALIAS, VARIABLE, TOOL or HOME");
    EXPECT_EQ(error_of("NCFILE\nFIXED\nOFFSET\nFIXED\n"),
              "m.txt:4:1: the section FIXED is given twice; first in line 2");
    EXPECT_EQ(error_of("NCFILE\nOFFSET\n...\n"),
              "m.txt:3:1: '...' stands for lines left out of a printed example; write them out");
}

TEST(MachineData, Offsets) {
    const auto error_of_line = [](const std::string& line) {
        return error_of("NCFILE\nOFFSET\n" + line + "\nENDFILE\n");
    };
    EXPECT_EQ(error_of_line("54"), "m.txt:3:1: 54 has no values");
    EXPECT_EQ(error_of_line("54 200.0001"), "m.txt:3:1: 54 needs values for X, Y and Z");
    EXPECT_EQ(error_of_line("54 1 2 inch"), "m.txt:3:1: 54 needs values for X, Y and Z");
    EXPECT_EQ(error_of_line("54 1 2 3,5"), "m.txt:3:8: '3,5' is not a number");
    EXPECT_EQ(error_of_line("54 1 2 nan"), "m.txt:3:8: 'nan' is not a number");
    EXPECT_EQ(error_of_line("54 1 2 1e12"), "m.txt:3:8: 1e12 is not between -1e9 and 1e9");
    EXPECT_EQ(error_of_line("54 1 2 3 4 5 6"),
              "m.txt:3:14: there are more values than axes; behind X, Y and Z this machine has 2");
    EXPECT_EQ(error_of_line("54 1 2 3\n54 1 2 3"), "m.txt:4:1: the frame 54 is given twice; first in line 3");
    for (const char* code : {"53", "60", "59.4", "054", "504", "600", "54.0", "-54", "5O5"}) {
        EXPECT_EQ(error_of_line(std::string(code) + " 1 2 3"),
                  "m.txt:3:1: '" + std::string(code) +
                      "' is no frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599");
    }
}

TEST(MachineData, OtherEntries) {
    EXPECT_EQ(error_of("NCFILE\nFIXED\n0 1 2 3\n"),
              "m.txt:3:1: '0' is not the number of a fixed point, 1 to 99999");
    EXPECT_EQ(error_of("NCFILE\nVARIABLE\n1 2 3\n"), "m.txt:3:5: '3' is one word too many");
    EXPECT_EQ(error_of("NCFILE\nALIAS\nJet M08\njet M09\n"),
              "m.txt:4:1: the alias jet is given twice; first in line 3");
}

TEST(MachineData, FileThatCannotBeRead) {
    EXPECT_EQ(load_machine_data("no/such.txt").error(),
              "cannot read 'no/such.txt': No such file or directory");
}

}  // namespace
}  // namespace gsim::machine
