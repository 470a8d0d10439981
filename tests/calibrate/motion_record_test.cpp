#include "calibrate/times/motion_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/times/passage_times.h"
#include "calibrate/times/recorded_run.h"

namespace gsim::calibrate::motion_record_test {
namespace {

using testing::HasSubstr;

std::vector<MotionSample> read(const std::string& text, const RecordFormat& record_format = {}) {
    const auto samples = read_motion_record(text, record_format);
    EXPECT_TRUE(samples) << samples.error().message;
    return samples.value_or(std::vector<MotionSample>{});
}

void expect_sample(const MotionSample& sample, double t_s, double x, double y, double z) {
    EXPECT_NEAR(sample.t_s, t_s, 1e-6);
    EXPECT_EQ(sample.at_mm, Eigen::Vector3d(x, y, z));
}

TEST(MotionRecord, IsReadFromCsv) {
    const auto samples = read("y_mm,t_s,x_mm\r\n2,0.5,1\r\n3,0.75,-1e1\r\n");
    ASSERT_EQ(samples.size(), 2U);
    expect_sample(samples[0], 0.5, 1, 2, 0);
    expect_sample(samples[1], 0.75, -10, 3, 0);
    EXPECT_EQ(read("t\tx\n0\t1\n1\t2\n").size(), 2U);
}

TEST(MotionRecord, IsReadFromHalsampler) {
    const RecordFormat record_format{.period_s = 0.002, .columns = "x-z"};
    const auto plain = read("1.5 9 2.5 \n1.6 9 2.6 \n", record_format);
    ASSERT_EQ(plain.size(), 2U);
    expect_sample(plain[1], 0.002, 1.6, 0, 2.6);
    const auto numbered = read("10 1 9 2\noverrun\n13 2 9 3\n", record_format);
    ASSERT_EQ(numbered.size(), 2U);
    expect_sample(numbered[0], 0.020, 1, 0, 2);
    expect_sample(numbered[1], 0.026, 2, 0, 3);
    EXPECT_THAT(read_motion_record("1 2 3\n", {}).error().message, HasSubstr("--sample-period"));
    EXPECT_THAT(read_motion_record("1 2\n", record_format).error().message, HasSubstr("line 1: 2 columns"));
}

TEST(MotionRecord, IsReadFromGrblStatusReports) {
    const auto samples = read(
        "[12:00:00.000] > $$\n[12:00:00.100] "
        "<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:1.000,0.000,-2.000>\nok\n"
        "[12:00:00.350] <Run|WPos:4.000,1.000,2.500|FS:600,0>\n");
    ASSERT_EQ(samples.size(), 2U);
    expect_sample(samples[0], 43200.1, 0, 0, 0);
    expect_sample(samples[1], 43200.35, 5, 1, 0.5);
    EXPECT_EQ(read("0.5 <Run|MPos:1,2,3>\n0.7 <Run|MPos:1,2,4|Bf:15,128>\n").size(), 2U);
    EXPECT_THAT(read_motion_record("<Run|MPos:1,2,3>\n", {}).error().message, HasSubstr("line 1"));
}

TEST(MotionRecord, IsReadFromMtconnect) {
    const auto shdr = read(
        "2024-05-01T12:00:00.5Z|Xact|1.5|Yact|2|execution|ACTIVE\n2024-05-01T12:00:01Z|line|7\n"
        "2024-05-01T12:00:01.25Z|Xact|3|Zact|UNAVAILABLE\n");
    ASSERT_EQ(shdr.size(), 2U);
    EXPECT_NEAR(shdr[1].t_s - shdr[0].t_s, 0.75, 1e-6);
    EXPECT_EQ(shdr[1].at_mm, Eigen::Vector3d(3, 2, 0));
    const auto streams = read(
        "<?xml version=\"1.0\"?><MTConnectStreams><Samples>"
        "<Position dataItemId=\"x2\" name=\"Xabs\" subType=\"ACTUAL\" "
        "timestamp=\"2024-05-01T00:00:00Z\">1</Position>"
        "<Position dataItemId=\"x3\" name=\"Xcom\" subType=\"COMMANDED\" "
        "timestamp=\"2024-05-01T00:00:00Z\">9</Position>"
        "<Position dataItemId=\"y2\" name=\"Yabs\" subType=\"ACTUAL\" "
        "timestamp=\"2024-05-01T00:00:02Z\">4</Position>"
        "</Samples></MTConnectStreams>");
    ASSERT_EQ(streams.size(), 2U);
    EXPECT_EQ(streams[1].at_mm, Eigen::Vector3d(1, 4, 0));
    EXPECT_NEAR(streams[1].t_s - streams[0].t_s, 2, 1e-6);
}

TEST(MotionRecord, RejectsInvalidRecords) {
    EXPECT_EQ(read_motion_record(" \n", {}).error().message, "it is empty");
    EXPECT_THAT(read_motion_record("a,b\n1,2\n", {}).error().message,
                HasSubstr("line 1 must name the columns"));
    EXPECT_THAT(read_motion_record("t_s,x_mm\n1,soon\n", {}).error().message, HasSubstr("line 2"));
    EXPECT_THAT(read_motion_record("t_s,x_mm\n1,1\n", {}).error().message,
                HasSubstr("fewer than two samples"));
    EXPECT_FALSE(read_motion_record(std::string("\0\0<Pos:|\xff", 9), {}));
}

/// Returns samples from 0 to 10 mm along x in 1 s, a corner, 10 mm along y in 2 s. It stands still before and
/// after.
std::vector<MotionSample> corner() {
    std::vector<MotionSample> samples;
    for (int i = 0; i <= 50; ++i) {
        const double t = 0.1 * i - 1;
        samples.push_back({t, {std::clamp(10 * t, 0.0, 10.0), std::clamp(5 * (t - 1), 0.0, 10.0), 0}});
    }
    return samples;
}

TEST(PassageTimes, AreAtNearestPointOfRecording) {
    const auto samples = corner();
    const auto span = motion_span(samples);
    ASSERT_TRUE(span);
    EXPECT_NEAR(span->start_s, 0, 1e-9);
    EXPECT_NEAR(span->end_s, 3, 1e-9);
    const std::vector<Eigen::Vector3d> places{{2.5, 0, 0}, {9.98, 0.02, 0}, {500, 0, 0}, {10, 7.5, 0}};
    const auto passages = passage_times_s(samples, places);
    ASSERT_EQ(passages.size(), 4U);
    EXPECT_NEAR(passages[0].value_or(0), 0.25, 1e-9);
    EXPECT_NEAR(passages[1].value_or(0), 1.0, 0.01);
    EXPECT_FALSE(passages[2]);
    EXPECT_NEAR(passages[3].value_or(0), 2.5, 1e-9);
}

TEST(PassageTimes, DistinguishTwoPassesOfOnePosition) {
    const auto forth = corner();
    std::vector<MotionSample> samples = forth;
    for (auto sample = forth.rbegin(); sample != forth.rend(); ++sample)
        samples.push_back({8 - sample->t_s, sample->at_mm});
    const std::vector<Eigen::Vector3d> places{{5, 0, 0}, {10, 10, 0}, {5, 0, 0}};
    const auto passages = passage_times_s(samples, places);
    EXPECT_NEAR(passages[0].value_or(0), 0.5, 1e-9);
    EXPECT_NEAR(passages[2].value_or(0), 7.5, 1e-9);
}

TEST(Records, SetTimeOfRun) {
    RecordedRun run{"a.ngc", 0};
    ASSERT_TRUE(add_record("t_s,x_mm\n0,0\n1,0\n2,5\n3,9\n4,9\n", {}, run));
    EXPECT_NEAR(run.time_s, 2, 1e-9);
    EXPECT_EQ(run.samples.size(), 5U);
    EXPECT_FALSE(add_record("t_s,x_mm\n0,0\n1,0\n", {}, run)) << "nothing moves";
}

}  // namespace
}  // namespace gsim::calibrate::motion_record_test
