#include <algorithm>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/report/report.h"

namespace gsim::simulation::report_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

Report sample() {
    Report report;
    report.source.program = "part.nc";
    report.source.machine = "gantry";
    report.source.controller = "grbl-1.1";
    report.source.files = {"part.nc"};
    report.cycle_time_s = 3725.5;
    report.times.rapid_s = 931.375;
    report.times.feed_s = 2794.125;
    report.distances.rapid_mm = 100;
    report.distances.feed_mm = 200;
    report.distances.process_on_mm = 150;
    report.bounds = {{.letter = 'X', .min = 0, .max = 50, .limit_min = 0, .limit_max = 100},
                     {.letter = 'Y',
                      .min = -1,
                      .max = 2,
                      .limit_min = -std::numeric_limits<double>::infinity(),
                      .limit_max = 10}};
    report.events = {{1.5, {0, 3}, "jet_on", ""}};
    report.slowest = {{{0, 9}, MoveKind::arc_cw, 3.5, 20, "rotary B acceleration"}};
    return report;
}

TEST(ReportText, PrintsResult) {
    const std::string text = to_text(sample());
    EXPECT_THAT(text, HasSubstr("controller  grbl-1.1\n"));
    EXPECT_THAT(text, HasSubstr("status      completed\n"));
    EXPECT_THAT(text, HasSubstr("cycle time  3725.500 s  (1:02:06)\n"));
    EXPECT_THAT(text, HasSubstr("rapid            931.375    25.0 %         100.000\n"));
    EXPECT_THAT(text, HasSubstr(" jet on                                    150.000\n"));
    EXPECT_THAT(text, HasSubstr("[=============...........]  50.0 %\n"));
    EXPECT_THAT(text, HasSubstr("none"));
    EXPECT_THAT(text, HasSubstr("part.nc:9"));
    EXPECT_THAT(text, HasSubstr("arc_cw         3.500        20.000  rotary B acceleration\n"));
    EXPECT_THAT(text, HasSubstr("jet_on"));
    EXPECT_THAT(text, Not(HasSubstr("warning")));
    EXPECT_THAT(text, Not(HasSubstr("time by cause")));
}

TEST(ReportText, PrintsTimeByCause) {
    Report report = sample();
    report.explanation = Explanation{{{"feed", 2794.125}, {"dwell", 931.375}}, 2980.4};
    EXPECT_THAT(to_text(report),
                HasSubstr("time by cause               time (s)     share\nfeed                        "
                          "2794.125    75.0 %\ndwell                        931.375    25.0 %\nlower bound  "
                          "2980.400 s  (the program takes 1.25 times this)\n"));
    report.explanation = Explanation{};
    EXPECT_THAT(to_text(report), HasSubstr("lower bound  0.000 s\n"));
}

TEST(ReportText, PrintsAlarm) {
    Report report = sample();
    report.status = RunStatus::alarm;
    report.alarm =
        Alarm{.message = "X is beyond its limit", .location = {0, 4}, .axis = 'X', .value = 1, .limit = 0};
    EXPECT_THAT(to_text(report), HasSubstr("  at        part.nc:4\n  because   X is beyond its limit\n"));
}

TEST(ReportText, LimitsLineLengthAndEscapesControlCharacters) {
    Report report = sample();
    const std::string long_name(300, 'n');
    report.source.program = long_name;
    report.source.machine = long_name;
    report.source.files = {long_name + "\x1b[31m"};
    report.alarm =
        Alarm{.message = long_name + " " + long_name, .location = {0, 4}, .value = {}, .limit = {}};
    report.messages.warnings.assign(30, "a warning of many words " + long_name + "\x1b[31m");
    report.events.assign(30, {1e6, {0, 1000000}, long_name, long_name});
    report.slowest.assign(10, {{0, 1000000}, MoveKind::thread, 1e7, 1e9, "rotary B acceleration"});
    report.explanation = Explanation{{{"rotary B acceleration", 1e7}}, 1e7};
    report.bounds[0].max = 1e9;
    report.bounds[0].min = -1e9;
    std::istringstream lines(to_text(report));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100u) << line;
        EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= 0x20 && c < 0x7f; }))
            << line;
    }
}

TEST(ReportText, PrintsEmptyReport) {
    EXPECT_THAT(to_text(Report{}), HasSubstr("cycle time  0.000 s  (0:00:00)\n"));
}

}  // namespace
}  // namespace gsim::simulation::report_text_test
