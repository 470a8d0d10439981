#include "machine/data/machine_data.h"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::machine_data_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::string error_of(const std::string& text) {
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const auto data = read_machine_data(text, "m.txt", axes);
    return data ? "no error" : data.error().message;
}

TEST(MachineData, ReadsAllSections) {
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const auto data = read_machine_data(
        "; the fixtures\n\nNCFILE\r\nOFFSET\n54 200.0001 200.0002 200\n59.1 1 2 3 90 -45 # turned\n"
        "505\t1 -2 +3 90 inch\n\nFIXED\n7 1 2 3 Metric\nALIAS\nWaterJetOn M08\nVARIABLE\n100 "
        "2.5\nENDFILE\n\n",
        "m.txt", axes);
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_THAT(data->offsets,
                ElementsAre(Pair("505", AxisValues{{'X', 25.4}, {'Y', -50.8}, {'Z', 3 * 25.4}, {'B', 90}}),
                            Pair("54", AxisValues{{'X', 200.0001}, {'Y', 200.0002}, {'Z', 200}}),
                            Pair("59.1", AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}, {'B', 90}, {'C', -45}})));
    EXPECT_THAT(data->fixed, ElementsAre(Pair(7, AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}})));
    EXPECT_THAT(data->aliases, ElementsAre(Pair("WaterJetOn", "M08")));
    EXPECT_THAT(data->variables, ElementsAre(Pair(100, 2.5)));
}

// As the thesis prints it, dots and all: three frames, all else at its default.
TEST(MachineData, ReadsExampleOfThesis) {
    const auto data = read_machine_data(
        "NCFILE\nOFFSET\n54\t200.0001\t200.0002\t200\n55\t255\t255\t255\n56\t100\t0\t300.001\n57\t0\t0\t0\n"
        "...\nFIXED\n1\t0\t0\t0\n2\t0\t0\t0\nENDFILE\n",
        "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_THAT(data->offsets,
                ElementsAre(Pair("54", AxisValues{{'X', 200.0001}, {'Y', 200.0002}, {'Z', 200}}),
                            Pair("55", AxisValues{{'X', 255}, {'Y', 255}, {'Z', 255}}),
                            Pair("56", AxisValues{{'X', 100}, {'Y', 0}, {'Z', 300.001}}),
                            Pair("57", AxisValues{{'X', 0}, {'Y', 0}, {'Z', 0}})));
    EXPECT_EQ(data->fixed.size(), 2U);
}

TEST(MachineData, ChecksAndDropsAdditionalValuesWithoutAxes) {
    const auto data = read_machine_data("NCFILE\nOFFSET\n54 1 2 3 4 5 6\nENDFILE", "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_THAT(data->offsets, ElementsAre(Pair("54", AxisValues{{'X', 1}, {'Y', 2}, {'Z', 3}})));
    EXPECT_FALSE(read_machine_data("NCFILE\nOFFSET\n54 1 2 3 4x\nENDFILE", "m.txt"));
}

TEST(MachineData, RejectsInvalidStartAndEndOfFile) {
    EXPECT_EQ(error_of(""), "m.txt:1:1: the file does not begin with NCFILE");
    EXPECT_EQ(error_of("OFFSET\n"), "m.txt:1:1: the file does not begin with NCFILE");
    EXPECT_EQ(error_of("NCFILE\nOFFSET\n"), "m.txt:3:1: the file does not end with ENDFILE");
    EXPECT_EQ(error_of("NCFILE\nENDFILE\n54 1 2 3\n"), "m.txt:3:1: text after ENDFILE is not allowed");
    EXPECT_EQ(error_of("NCFILE\nNCFILE\n"), "m.txt:2:1: NCFILE is only allowed in the first line");
    EXPECT_EQ(error_of("NCFILE x\n"), "m.txt:1:8: 'x' is an extra word");
}

TEST(MachineData, ReadsToolsAndRejectsDuplicates) {
    const auto data = read_machine_data("NCFILE\nTOOL\n1 100 6\n22 1 0.25 inch\nENDFILE\n", "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    ASSERT_EQ(data->tools.size(), 2U);
    EXPECT_EQ(data->tools.at(1).length_mm, 100);
    EXPECT_EQ(data->tools.at(1).diameter_mm, 6);
    EXPECT_DOUBLE_EQ(data->tools.at(22).length_mm, 25.4);
    EXPECT_DOUBLE_EQ(data->tools.at(22).diameter_mm, 6.35);
    EXPECT_EQ(error_of("NCFILE\nTOOL\n1 100\n"),
              "m.txt:3:1: a tool needs its number, its length and its diameter");
    EXPECT_EQ(error_of("NCFILE\nTOOL\n1 1 1\n1 2 2\n"),
              "m.txt:4:1: the tool 1 is given twice; first in line 3");
}

TEST(MachineData, ReadsAllToolValues) {
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const auto data = read_machine_data(
        "NCFILE\nTOOL\n1 2 1 length_wear=-0.5 DIAMETER_WEAR=.25 X=1 b=30 orientation=9 FRONT=10 BACK=20 jet "
        "inch\n"
        "2 0 0 Cutter\nENDFILE\n",
        "m.txt", axes);
    ASSERT_TRUE(data) << data.error().message;
    const Tool jet{.length_mm = 50.8,
                   .diameter_mm = 25.4,
                   .length_wear_mm = -12.7,
                   .diameter_wear_mm = 6.35,
                   .kind = ToolKind::jet,
                   .offsets = {{'X', 25.4}, {'B', 30}},
                   .front_angle_deg = 10,
                   .back_angle_deg = 20,
                   .orientation = 9};
    EXPECT_EQ(data->tools.at(1), jet);
    EXPECT_EQ(data->tools.at(2).kind, ToolKind::cutter);
    const auto error_of_line = [](const std::string& line) {
        return error_of(fmt::format("NCFILE\nTOOL\n{}\nENDFILE\n", line));
    };
    EXPECT_EQ(error_of_line("1 0 0 jet cutter"), "m.txt:3:11: 'cutter' is an extra word");
    EXPECT_EQ(error_of_line("1 0 0 length=3"), "m.txt:3:7: a tool has no value with the name 'LENGTH'");
    EXPECT_EQ(error_of_line("1 0 0 x=1 x=1"), "m.txt:3:11: 'x=1' is an extra word");
    EXPECT_EQ(error_of_line("1 0 0 x="), "m.txt:3:7: '' is not a number");
    EXPECT_EQ(error_of_line("1 0 0 orientation=10"),
              "m.txt:3:7: ORIENTATION must be an integer from 0 to 9, not '10'");
    EXPECT_EQ(error_of_line("1 0 inch 0"), "m.txt:3:10: '0' is too late: values come before other words");
    EXPECT_EQ(error_of_line("1 5e7 0 inch"), "m.txt:3:3: 5e7 must be between -1e9 and 1e9 mm");
}

TEST(MachineData, ReadsZones) {
    const auto data = read_machine_data(
        "NCFILE\nSECURITY\n1 100 200 300 400\n7 -1 1 - - 0 10 leave off switch=3 inch\n"
        "WORKING\n1 0 1800 0 2400 - -\nENDFILE\n",
        "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_THAT(
        data->security_zones,
        ElementsAre(Pair(1, Zone{.number = 1, .limits = {ZoneLimits{100, 200}, ZoneLimits{300, 400}, {}}}),
                    Pair(7, Zone{.number = 7,
                                 .kind = ZoneKind::leave_forbidden,
                                 .limits = {ZoneLimits{-25.4, 25.4}, {}, ZoneLimits{0, 254}},
                                 .active_at_start = false,
                                 .switch_number = 3})));
    EXPECT_EQ(data->working_zone,
              (Zone{.kind = ZoneKind::working, .limits = {ZoneLimits{0, 1800}, ZoneLimits{0, 2400}, {}}}));
}

TEST(MachineData, RejectsInvalidZones) {
    const auto error_of_line = [](const std::string& line) {
        return error_of(fmt::format("NCFILE\nSECURITY\n{}\nENDFILE\n", line));
    };
    EXPECT_EQ(error_of_line("1 200 100 0 1"),
              "m.txt:3:3: Xmin is 200 and Xmax is 100; min must be less than max");
    EXPECT_EQ(error_of_line("1 0 1 5 5"), "m.txt:3:7: Ymin is 5 and Ymax is 5; min must be less than max");
    EXPECT_EQ(error_of_line("1 0 1 - 5"),
              "m.txt:3:1: Ymin and Ymax must both be numbers, or both '-' (no limits)");
    EXPECT_EQ(error_of_line("1 0 1 0 1 0"),
              "m.txt:3:1: Zmin and Zmax must both be numbers, or both '-' (no limits)");
    EXPECT_EQ(error_of_line("1 - - - -"), "m.txt:3:1: a zone needs its two limits on at least one axis");
    EXPECT_EQ(error_of_line("1 0 1"),
              "m.txt:3:1: a zone needs its number and its limits: Xmin, Xmax, Ymin, Ymax, and optionally "
              "Zmin and Zmax");
    EXPECT_EQ(error_of_line("1 0 1 0 1 0 1 0"), "m.txt:3:15: '0' is an extra word");
    EXPECT_EQ(error_of("NCFILE\nWORKING\n2 0 1 0 1\n"),
              "m.txt:3:1: there is only one working zone; its number is 1");
}

TEST(MachineData, ReadsReferencePoints) {
    const auto data = read_machine_data("NCFILE\nREFERENCE\n1 1 2 3 inch\nENDFILE\n", "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_DOUBLE_EQ(data->references.at(1).at('Y'), 50.8);
}

TEST(MachineData, ReadsNamesOfPoints) {
    const auto data = read_machine_data(
        "NCFILE\nFIXED\n1 1 2 3 NAME=CLAMP1\n2 1 2 3\n30 1 2 3 name=Park_2 inch\nREFERENCE\n7 0 0 1 "
        "Name=clamp1\n"
        "ENDFILE\n",
        "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_THAT(data->fixed_names, ElementsAre(Pair(1, "CLAMP1"), Pair(30, "Park_2")));
    EXPECT_THAT(data->reference_names, ElementsAre(Pair(7, "clamp1")));
    EXPECT_DOUBLE_EQ(data->fixed.at(30).at('X'), 25.4);
}

TEST(MachineData, RejectsInvalidNamesOfPoints) {
    const auto error_of_line = [](const std::string& line) {
        return error_of(fmt::format("NCFILE\nFIXED\n{}\nENDFILE\n", line));
    };
    for (const char* name : {"", "3", "_A", "A-B", "A.B", "A=B", "\xc3\xa4"}) {
        EXPECT_EQ(
            error_of_line(fmt::format("1 0 0 0 NAME={}", name)),
            fmt::format("m.txt:3:9: '{}' is not a valid name: a letter first, then letters, digits and '_'",
                        name));
    }
    EXPECT_EQ(error_of_line("1 0 0 0 NAME=A NAME=B"), "m.txt:3:16: 'NAME=B' is an extra word");
    EXPECT_EQ(error_of_line("1 0 NAME=A 0"), "m.txt:3:12: '0' is too late: values come before other words");
    EXPECT_EQ(error_of_line("1 0 0 0 TITLE=A"),
              "m.txt:3:9: a fixed point has no value with the name 'TITLE'");
    EXPECT_EQ(error_of_line("1 0 0 0 NAME=Vise\n2 0 0 0 NAME=B\n3 9 9 9 NAME=VISE"),
              "m.txt:5:9: the name VISE of a fixed point is given twice; first in line 3");
    EXPECT_EQ(error_of("NCFILE\nOFFSET\n54 0 0 0 NAME=A\n"), "m.txt:3:10: 'NAME=A' is not a number");
    EXPECT_EQ(error_of("NCFILE\nHOME\n2 0 0 0 NAME=A\n"), "m.txt:3:9: 'NAME=A' is not a number");
}

TEST(MachineData, RejectsNulByte) {
    using std::string_literals::operator""s;
    EXPECT_EQ(error_of("NCFILE\nOFFSET\n# \0\nENDFILE\n"s),
              "m.txt:3:3: the file contains a NUL byte; it must be a text file");
}

TEST(MachineData, ReadsHomePositions) {
    const auto data = read_machine_data("NCFILE\nHOME\n2 1 2 3\n4 0 0 1 inch\nENDFILE\n", "m.txt");
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_EQ(data->homes.at(2).at('Y'), 2);
    EXPECT_DOUBLE_EQ(data->homes.at(4).at('Z'), 25.4);
    EXPECT_EQ(error_of("NCFILE\nHOME\n1 1 2 3\n"),
              "m.txt:3:1: home positions are 2 to 4; the first is in the machine file");
}

TEST(MachineData, RejectsInvalidSections) {
    const std::string sections =
        "a section begins with OFFSET, FIXED, REFERENCE, HOME, TOOL, VARIABLE, ALIAS, SECURITY or WORKING";
    EXPECT_EQ(error_of("NCFILE\n OFSET\n"),
              "m.txt:2:2: 'OFSET' is not a keyword; " + sections + "; did you mean OFFSET?");
    EXPECT_EQ(error_of("NCFILE\n54 1 2 3\n"), "m.txt:2:1: '54' is not a keyword; " + sections);
    EXPECT_EQ(error_of("NCFILE\nFIXED\nOFFSET\nFIXED\n"),
              "m.txt:4:1: the section FIXED is given twice; first in line 2");
    for (const char* dots : {"OFFSET\n....", "OFFSET\n... 599", "...\nOFFSET"}) {
        EXPECT_THAT(error_of(fmt::format("NCFILE\n{}\nENDFILE\n", dots)),
                    testing::EndsWith(":1: '...' marks omitted entries of a section: alone in its line, "
                                      "after the section's keyword"))
            << dots;
    }
}

TEST(MachineData, RejectsInvalidOffsets) {
    const auto error_of_line = [](const std::string& line) {
        return error_of("NCFILE\nOFFSET\n" + line + "\nENDFILE\n");
    };
    EXPECT_EQ(error_of_line("54"), "m.txt:3:1: 54 has no values");
    EXPECT_EQ(error_of_line("54 200.0001"), "m.txt:3:1: 54 needs values for X, Y and Z");
    EXPECT_EQ(error_of_line("54 1 2 inch"), "m.txt:3:1: 54 needs values for X, Y and Z");
    EXPECT_EQ(error_of_line("54 1 2 3,5"), "m.txt:3:8: '3,5' is not a number");
    EXPECT_EQ(error_of_line("54 1 2 nan"), "m.txt:3:8: 'nan' is not a number");
    EXPECT_EQ(error_of_line("54 1 2 1e12"), "m.txt:3:8: 1e12 must be between -1e9 and 1e9");
    EXPECT_EQ(error_of_line("54 1 2 3 4 5 6"),
              "m.txt:3:14: there are more values than axes; after X, Y and Z this machine has 2");
    EXPECT_EQ(error_of_line("54 1 2 3\n54 1 2 3"), "m.txt:4:1: the frame 54 is given twice; first in line 3");
    for (const char* code : {"53", "60", "59.4", "054", "504", "600", "54.0", "-54", "5O5"}) {
        EXPECT_EQ(error_of_line(std::string(code) + " 1 2 3"),
                  "m.txt:3:1: '" + std::string(code) +
                      "' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599");
    }
}

TEST(MachineData, RejectsOtherInvalidEntries) {
    EXPECT_EQ(error_of("NCFILE\nFIXED\n0 1 2 3\n"),
              "m.txt:3:1: '0' is not a valid number of a fixed point, 1 to 99999");
    EXPECT_EQ(error_of("NCFILE\nVARIABLE\n1 2 3\n"), "m.txt:3:5: '3' is an extra word");
    EXPECT_EQ(error_of("NCFILE\nALIAS\nJet M08\njet M09\n"),
              "m.txt:4:1: the alias jet is given twice; first in line 3");
}

TEST(MachineData, ReportsUnreadableFile) {
    EXPECT_EQ(load_machine_data("no/such.txt").error().message,
              "cannot read 'no/such.txt': No such file or directory");
}

}  // namespace
}  // namespace gsim::machine::machine_data_test
