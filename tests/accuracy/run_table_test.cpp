#include "tests/accuracy/run_table.h"

#include <gtest/gtest.h>

#include "tests/conformance/scratch_folder.h"

namespace gsim::accuracy::run_table_test {
namespace {

std::string machine_name(const TableRow& row) {
    return "box-" + row.at("machine");
}

std::string error_kind(const TableRow& row) {
    return row.at("kind");
}

std::string error_message(const TableRow& row) {
    return row.contains("flag") ? row.at("flag") : std::string();
}

constexpr RunTable kRuns{machine_name, error_kind, error_message};
constexpr Controller kBox{
    .name = "box", .time_key = "time_s", .note_key = "note", .tools = 3, .runs = &kRuns};

TEST(RunTable, ReadsRowsByColumnNames) {
    const auto rows = read_rows("name\ttime_s\tnote\r\na\t1\t\r\n\nb\t2\n");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].at("name"), "a");
    EXPECT_EQ(rows[0].at("time_s"), "1");
    EXPECT_EQ(rows[1].at("name"), "b");
    EXPECT_FALSE(rows[1].contains("note"));
    EXPECT_TRUE(read_rows("").empty());
}

TEST(RunTable, ListsRunsOfExistingPrograms) {
    const conformance::ScratchFolder folder;
    folder.write("b.ngc", "G1 X1 F10\n");
    folder.write("a.ngc", "G1 X1 F10\n");
    const auto rows = read_rows(
        "name\tmachine\tkind\ttime_s\tpause_s\tinputs\tflag\n"
        "b\tone\tfast\t3.5\t0.5\t1:0x92\n"
        "b\ttwo\tslow\t4\t0\t\tit fell over\n"
        "gone\tone\tfast\t1\t0\n"
        "a\tone\tfast\t2\t0\t1:0x21\n");
    const auto runs = listed_runs(folder.path(), rows, kBox);
    ASSERT_TRUE(runs) << runs.error().message;
    ASSERT_EQ(runs->size(), 3U);
    EXPECT_EQ((*runs)[0].name, "a fast");
    EXPECT_EQ((*runs)[0].cycle_time_s, 2);
    EXPECT_FALSE((*runs)[0].counted);
    EXPECT_EQ((*runs)[0].note, "'0x21' is none that turns an override");
    EXPECT_EQ((*runs)[1].name, "b fast");
    EXPECT_EQ((*runs)[1].cycle_time_s, 3);
    EXPECT_EQ((*runs)[1].machine_file, "box-one.toml");
    EXPECT_EQ((*runs)[1].tools, 3);
    EXPECT_NE((*runs)[1].overrides.find("feed_percent = 90.0"), std::string::npos);
    EXPECT_TRUE((*runs)[1].counted);
    EXPECT_FALSE((*runs)[2].counted);
    EXPECT_EQ((*runs)[2].note, "it fell over");
}

TEST(RunTable, NamesProgramWithoutTime) {
    const conformance::ScratchFolder folder;
    folder.write("a.ngc", "G1 X1 F10\n");
    const auto runs =
        listed_runs(folder.path(), read_rows("name\tmachine\tkind\ttime_s\na\tone\tx\tsoon\n"), kBox);
    ASSERT_FALSE(runs);
    EXPECT_EQ(runs.error().message, "a: 'soon' is no time");
}

TEST(RunTable, NamesMachinesWithDashes) {
    EXPECT_EQ(machine_of_grblhal({{"machine", "router_jd0"}}), "grblhal-router-jd0");
    TableRow row{{"machine", "gantry"}, {"planner_type", "0"}, {"jerk", "0"}};
    EXPECT_EQ(machine_of_linuxcnc_2_10(row), "linuxcnc-2.10-gantry-pt0");
    row["planner_type"] = "1";
    row["jerk"] = "20000";
    EXPECT_EQ(machine_of_linuxcnc_2_10(row), "linuxcnc-2.10-gantry-pt1-j20000");
    row["jerk"] = "1000000000";
    EXPECT_EQ(machine_of_linuxcnc_2_10(row), "linuxcnc-2.10-gantry-pt1-jdef");
    EXPECT_EQ(planner_of_linuxcnc_2_10(row), "pt1-jdef");
}

TEST(RunTable, ReturnsOnlyErrorFlagsOfRecordedCommit) {
    EXPECT_EQ(fault_of_linuxcnc_2_10({{"flag", "trapezoidal_fallback,spindle_or_coolant"}}),
              "trapezoidal_fallback");
    EXPECT_EQ(fault_of_linuxcnc_2_10({{"flag", "acc_step"}}), "acc_step");
    EXPECT_EQ(fault_of_linuxcnc_2_10({{"flag", "dwell"}}), "");
    EXPECT_EQ(fault_of_linuxcnc_2_10({}), "");
}

}  // namespace
}  // namespace gsim::accuracy::run_table_test
