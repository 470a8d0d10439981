// Estimators of others, against what their rules come to by hand.
#include "tests/accuracy/estimators.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::accuracy::estimators_test {
namespace {

machine::Machine router() {
    return machine::load_machine(tests::source_path("samples/machines/grbl-router.toml"))
        .value();  // 100 mm/s, 1000 mm/s2
}

std::vector<ProgrammedMove> read_moves(const std::string& lines) {
    std::istringstream in(lines);
    return read_programmed_moves(in, router()).value();
}

std::string line(double x, double y, double feed, const std::string& kind = "linear") {
    std::ostringstream text;
    text << R"({"kind":")" << kind << R"(","to":{"X":)" << x << R"(,"Y":)" << y << R"(,"Z":0},"feed":)";
    if (kind == "rapid") {
        text << "null";
    } else {
        text << feed;
    }
    text << "}\n";
    return text.str();
}

TEST(ProgrammedMoves, HaveLengthsAndAxisLimits) {
    const auto moves = read_moves(line(30, 40, 6000) + line(30, 0, 600));
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_DOUBLE_EQ(moves[0].length, 50);
    EXPECT_DOUBLE_EQ(moves[0].feed_s, 100);
    EXPECT_DOUBLE_EQ(moves[0].speed_limit, 100 / 0.8);
    EXPECT_DOUBLE_EQ(moves[0].acceleration, 1000 / 0.8);
    EXPECT_DOUBLE_EQ(moves[1].enters.y(), -1);
}

TEST(ProgrammedMoves, FollowArcs) {
    const auto moves = read_moves(
        line(10, 0, 600) + R"({"kind":"arc_ccw","to":{"X":0,"Y":10,"Z":0},"center":{"X":0,"Y":0,"Z":0},)"
                           R"("normal":{"X":0,"Y":0,"Z":1},"turns":1,"feed":600})"
                           "\n");
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_NEAR(moves[1].length, 5 * std::numbers::pi, 1e-9);
    EXPECT_DOUBLE_EQ(moves[1].radius_mm, 10);
    EXPECT_NEAR(moves[1].enters.y(), 1, 1e-12);
    EXPECT_NEAR(moves[1].leaves.x(), -1, 1e-12);
}

TEST(ProgrammedMoves, ReportInvalidLine) {
    std::istringstream in("{\"kind\":\"linear\"}\n");
    const auto moves = read_programmed_moves(in, router());
    ASSERT_FALSE(moves);
    EXPECT_EQ(moves.error().message.find("line 1"), 0U);
}

TEST(Estimators, DivideLengthByFeed) {
    const auto moves = read_moves(line(100, 0, 0, "rapid") + line(100, 50, 600) +
                                  R"({"kind":"dwell","start_s":1,"end_s":1.5})"
                                  "\n");
    EXPECT_NEAR(length_over_feed_s(moves), 1 + 5 + 0.5, 1e-9);
    EXPECT_NEAR(camotics_s(moves), 100 / (10'000 / 60.0) + 5 + 0.5, 1e-9);
}

TEST(Estimators, TrapezoidEstimatorStopsOnlyAtCorners) {
    // 100 mm at 100 mm/s and 1000 mm/s2 take L/v + v/a.
    EXPECT_NEAR(linuxcnc_parse_s(read_moves(line(100, 0, 6000))), 1.1, 1e-9);
    EXPECT_NEAR(linuxcnc_parse_s(read_moves(line(100, 0, 6000) + line(100, 100, 6000))), 2.2, 1e-9);
    EXPECT_NEAR(linuxcnc_parse_s(read_moves(line(100, 0, 6000) + line(200, 0, 6000))), 2.1, 1e-9);
}

TEST(Estimators, TrapezoidEstimatorLooksAhead32Moves) {
    // Many short lines in a row: the max speed is that from which 31 of them suffice to stop.
    std::string lines;
    for (int i = 1; i <= 2000; ++i) lines += line(0.01 * i, 0, 6000);
    const double speed = std::sqrt(2 * 1000 * 0.01 * 32);
    EXPECT_NEAR(linuxcnc_parse_s(read_moves(lines)), 20 / speed + speed / 1000, 0.01);
}

}  // namespace
}  // namespace gsim::accuracy::estimators_test
