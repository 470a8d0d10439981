#include "calibrate/times/recorded_run.h"

#include <gtest/gtest.h>

namespace gsim::calibrate::recorded_run_test {
namespace {

TEST(RecordedRuns, AreReadWithProgramAndTime) {
    const auto runs =
        read_recorded_runs("time_s, program ,who\r\n 1.5,a.nc,me\r\n\n2e1,\"/b/c.nc\",you\n", "shop");
    ASSERT_TRUE(runs) << runs.error().message;
    ASSERT_EQ(runs->size(), 2U);
    EXPECT_EQ((*runs)[0].program, "shop/a.nc");
    EXPECT_EQ((*runs)[0].time_s, 1.5);
    EXPECT_EQ((*runs)[1].program, "/b/c.nc");
    EXPECT_EQ((*runs)[1].time_s, 20);
}

TEST(RecordedRuns, AcceptTableOfNamesAndCycleTimes) {
    const auto runs = read_recorded_runs("name\tmachine\tcycle_time_s\nx\trouter\t3\n", "");
    ASSERT_TRUE(runs) << runs.error().message;
    ASSERT_EQ(runs->size(), 1U);
    EXPECT_EQ((*runs)[0].program, "x.ngc");
}

TEST(RecordedRuns, AcceptFilesOfPositions) {
    const auto runs =
        read_recorded_runs("program,record,time_s\na.nc,a.csv,\nb.nc,,2\nc.nc,/c.log,3\n", "shop");
    ASSERT_TRUE(runs) << runs.error().message;
    ASSERT_EQ(runs->size(), 3U);
    EXPECT_EQ((*runs)[0].record, "shop/a.csv");
    EXPECT_EQ((*runs)[0].time_s, 0);
    EXPECT_EQ((*runs)[1].record, "");
    EXPECT_EQ((*runs)[2].record, "/c.log");
    EXPECT_EQ((*runs)[2].time_s, 3);
    EXPECT_FALSE(read_recorded_runs("program,record\na.nc,\n", ""));
}

TEST(RecordedRuns, ReportLineOfMissingValue) {
    EXPECT_EQ(read_recorded_runs("", "").error().message, "it is empty");
    EXPECT_EQ(read_recorded_runs("a,b\n", "").error().message,
              "line 1: it must name the columns, including 'program' and 'time_s' (or 'record')");
    EXPECT_EQ(read_recorded_runs("program,time_s\na.nc\n", "").error().message,
              "line 2: a column is missing");
    EXPECT_EQ(read_recorded_runs("name,cycle_time_s\na,1\n,2\n", "").error().message,
              "line 3: the name of the program is missing");
    for (const char* time : {"soon", "", "0", "-1", "nan", "1e999", "1 s"}) {
        EXPECT_EQ(read_recorded_runs(std::string("program,time_s\na.nc,") + time + "\n", "").error().message,
                  std::string("line 2: '") + time + "' must be a time greater than 0 s");
    }
}

}  // namespace
}  // namespace gsim::calibrate::recorded_run_test
