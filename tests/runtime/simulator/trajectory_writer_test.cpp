#include "runtime/outputs/trajectory_writer.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/runtime/simulator/string_stream.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::trajectory_writer_test {
namespace {

constexpr double kNoEnd_s = std::numeric_limits<double>::infinity();

struct Table {
    std::string header;
    std::vector<std::vector<double>> rows;
};

Table parse(const std::string& text) {
    Table table;
    const std::size_t header_end = text.find('\n');
    table.header = text.substr(0, header_end);
    const char* at = text.c_str() + header_end + 1;
    while (*at != '\0') {
        std::vector<double>& row = table.rows.emplace_back();
        do {
            char* end = nullptr;
            row.push_back(std::strtod(at, &end));
            at = end + 1;
        } while (at[-1] == ',');
    }
    return table;
}

MoveInfo on_line_hook(std::uint32_t line) {
    return {.location = {0, line}};
}

TEST(TrajectoryWriter, SamplesCompleteRunAndEndTime) {
    const machine::Machine machine = af5();
    StringStream stream;
    TrajectoryWriter writer(stream.out(), machine, 0.4, kNoEnd_s);
    const double quarter = std::numbers::pi / 2;
    writer.begin(joints(0, 0));
    writer.on_segment(line(1, 0, joints(0, 0), joints(100, 0)), on_line_hook(7));  // 0 .. 2.5
    writer.on_segment(line(2, 2.5, joints(100, 0), joints(100, 100, 0, quarter)),
                      on_line_hook(8));  // 2.5 .. 5
    writer.end(5);
    const Table table = parse(stream.text());
    EXPECT_EQ(table.header, "t_s,line,x_mm,y_mm,z_mm,b_deg,c_deg,speed_mm_s");
    ASSERT_EQ(table.rows.size(), 14u);
    for (std::size_t k = 0; k < 13; ++k) {
        EXPECT_NEAR(table.rows[k][0], 0.4 * static_cast<double>(k), 1e-12);
        EXPECT_EQ(table.rows[k][1], k < 7 ? 7 : 8) << k;
    }
    EXPECT_EQ(table.rows[13], (std::vector<double>{5, 8, 100, 100, 0, 90, 0, 0}));
    // 0.4 s into a ramp of 100 mm/s2: 8 mm, 40 mm/s; then 12.5 mm of ramp and 50 mm/s.
    EXPECT_NEAR(table.rows[1][2], 8, 1e-9);
    EXPECT_NEAR(table.rows[1][7], 40, 1e-9);
    EXPECT_NEAR(table.rows[3][2], 12.5 + 0.7 * 50, 1e-9);
    EXPECT_NEAR(table.rows[3][7], 50, 1e-9);
    // In the middle of the second line both have moved half of the distance.
    const std::vector<double>& row = table.rows[9];  // 3.6 s, 1.1 s into the line
    EXPECT_NEAR(row[3], 12.5 + 0.6 * 50, 1e-9);
    EXPECT_NEAR(row[5], 0.9 * row[3], 1e-6);
}

TEST(TrajectoryWriter, TimesAreExactMultiplesForManySegments) {
    const machine::Machine machine = af5();
    StringStream stream;
    TrajectoryWriter writer(stream.out(), machine, 0.01, kNoEnd_s);
    writer.begin(joints(0, 0));
    double start_s = 0;
    for (int i = 0; i < 5000; ++i) {
        writer.on_segment(standstill(i, start_s, joints(0, 0), 0.1), on_line_hook(1));
        start_s += 0.1;
    }
    writer.end(start_s);
    const Table table = parse(stream.text());
    ASSERT_EQ(table.rows.size(), 50001u);
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        ASSERT_NEAR(table.rows[k][0], static_cast<double>(k) / 100, 1e-9);
    }
}

TEST(TrajectoryWriter, SamplesLongMoveOnlyUpToTimeLimit) {
    const machine::Machine machine = af5();
    StringStream stream;
    TrajectoryWriter writer(stream.out(), machine, 1, 3);
    writer.begin(joints(0, 0));
    writer.on_segment(standstill(1, 0, joints(0, 0), 1e12), on_line_hook(1));
    writer.on_segment(standstill(2, 1e12, joints(0, 0), 1e12), on_line_hook(2));
    writer.end(2e12);
    const Table table = parse(stream.text());
    ASSERT_EQ(table.rows.size(), 5U);
    EXPECT_EQ(table.rows[3][0], 3);
    EXPECT_EQ(table.rows[4][0], 2e12);
}

TEST(TrajectoryWriter, WritesOneRowForEmptyRun) {
    const machine::Machine machine = af5();
    StringStream stream;
    TrajectoryWriter writer(stream.out(), machine, 0.01, kNoEnd_s);
    writer.begin(joints(1, 2));
    writer.end(0);
    EXPECT_EQ(stream.text(), "t_s,line,x_mm,y_mm,z_mm,b_deg,c_deg,speed_mm_s\n0,0,1,2,0,0,0,0\n");
}

TEST(TrajectoryWriter, RejectsInvalidStep) {
    const machine::Machine machine = af5();
    StringStream stream;
    for (const double step_s : {0.0, -1.0, 1e-7, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(TrajectoryWriter(stream.out(), machine, step_s, kNoEnd_s), std::invalid_argument);
    }
}

TEST(TrajectoryWriter, TruncatesTooManySamples) {
    const machine::Machine machine = af5();
    for (const std::uint64_t max : {4U, 5U}) {
        StringStream stream;
        TrajectoryWriter writer(stream.out(), machine, 0.25, kNoEnd_s, max);
        motion::Segment segment;
        segment.duration_s = 1.2;  // samples at 0, 0.25, 0.5, 0.75 and 1
        segment.start = segment.end = joints(0, 0);
        writer.begin(joints(0, 0));
        writer.on_segment(segment, on_line_hook(1));
        writer.end(1.2);
        EXPECT_EQ(writer.is_truncated(), max == 4);
        EXPECT_EQ(parse(stream.text()).rows.size(), max + 1) << "and the last instant";
    }
}

}  // namespace
}  // namespace gsim::simulation::trajectory_writer_test
