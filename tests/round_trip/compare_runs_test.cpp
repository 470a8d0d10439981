// Permitted differences of two runs, and others.
#include "tests/round_trip/compare_runs.h"

#include <gtest/gtest.h>

namespace gsim::round_trip::compare_runs_test {
namespace {

MadeMove to(const std::string& kind, double x, double y) {
    return {kind, {{'X', x}, {'Y', y}}, {}, {}, 0, 1};
}

MadeMove arc(double x, double y, double center_x) {
    MadeMove move = to("arc_cw", x, y);
    move.center = {{'X', center_x}, {'Y', 0}};
    move.plane = "xy";
    move.turns = 1;
    return move;
}

RunRecord run(std::vector<MadeMove> moves) {
    return {std::move(moves), {}, 0};
}

TEST(CompareRuns, AcceptsPositionsWithinOneMicrometre) {
    const RunRecord first = run({to("rapid", 1, 2), to("linear", 3, 4)});
    EXPECT_EQ(compare_positions(first, run({to("rapid", 1.0009, 2), to("linear", 3, 4)})), "");
    EXPECT_NE(compare_positions(first, run({to("rapid", 1.0011, 2), to("linear", 3, 4)})), "");
    EXPECT_NE(compare_positions(first, run({to("linear", 1, 2), to("linear", 3, 4)})), "") << "no rapid";
    EXPECT_NE(compare_positions(first, run({to("rapid", 1, 2)})), "") << "a move is missing";
    EXPECT_NE(compare_positions(first, run({to("rapid", 1, 2), to("linear", 3, 4), to("linear", 5, 4)})), "");
}

TEST(CompareRuns, AcceptsMissingTinyMove) {
    const RunRecord first = run({to("rapid", 1, 2), to("linear", 1.0004, 2), to("linear", 3, 4)});
    EXPECT_EQ(compare_positions(first, run({to("rapid", 1, 2), to("linear", 3, 4)})), "");
}

TEST(CompareRuns, AcceptsArcInParts) {
    const RunRecord first = run({to("rapid", 0, 0), arc(10, 0, 5)});
    EXPECT_EQ(compare_positions(first, run({to("rapid", 0, 0), arc(5, 5, 5), arc(10, 0, 5)})), "");
    EXPECT_EQ(compare_positions(first, run({to("rapid", 0, 0), to("linear", 5, 5), to("linear", 10, 0)})),
              "");
    EXPECT_NE(compare_positions(first, run({to("rapid", 0, 0), arc(5, 5, 5.1), arc(10, 0, 5)})), "");
    EXPECT_NE(compare_positions(first, run({to("rapid", 0, 0), to("linear", 5, 4), to("linear", 10, 0)})),
              "");
    EXPECT_NE(compare_positions(first, run({to("rapid", 0, 0), to("linear", 5, 5)})), "");
}

TEST(CompareRuns, ReportsDifferentTimesAndEvents) {
    RunRecord first, second;
    first.time_s = 100;
    second.time_s = 100.09;
    EXPECT_EQ(compare_times(first, second), "");
    second.time_s = 100.11;
    EXPECT_EQ(compare_times(first, second), "100.0000 s, found 100.1100 s (+0.11 %)");
    first.events = {{1, "jet_on", ""}, {2, "message", "hello"}, {3, "digital_output", "P3 on"}};
    second.events = {{1, "flood_on", ""}, {3, "digital_output", "P3 on"}};
    EXPECT_EQ(compare_events(first, second, {"message hello"}), "") << "M8 in either dialect";
    EXPECT_EQ(compare_events(first, second, {}), "event 2: message hello, found digital_output P3 on");
    second.events[1].t_s = 3.1;
    EXPECT_EQ(compare_events(first, second, {"message hello"}),
              "event 2, digital_output P3 on: at 3.0000 s, found at 3.1000 s");
}

RunRecord switches(const std::vector<std::string>& kinds) {
    RunRecord run_record;
    for (const std::string& kind : kinds) run_record.events.push_back({1, kind, ""});
    return run_record;
}

TEST(CompareRuns, AcceptsTwoOverrideSwitchesForOne) {
    RunRecord two;
    two.events = {{1, "override", "feed enabled"}, {1, "override", "speed enabled"}};
    EXPECT_EQ(compare_events(switches({"overrides_on"}), two, {}), "");
    EXPECT_NE(compare_events(switches({"overrides_off"}), two, {}), "");
}

// LinuxCNC's M6 stops the spindle: only its stop and its start, both, may be added to the change.
TEST(CompareRuns, AcceptsSpindleStopAndRestartAtToolChange) {
    const RunRecord on = switches({"spindle_ccw", "tool_change", "flood_on"});
    EXPECT_EQ(compare_events(on, switches({"spindle_ccw", "tool_change", "flood_on"}), {}), "");
    EXPECT_EQ(compare_events(
                  on, switches({"spindle_ccw", "spindle_off", "tool_change", "spindle_ccw", "flood_on"}), {}),
              "");
    EXPECT_EQ(compare_events(on, switches({"spindle_ccw", "spindle_off", "tool_change", "flood_on"}), {}),
              "event 4: spindle_ccw, found M8");
    EXPECT_EQ(compare_events(
                  on, switches({"spindle_ccw", "spindle_off", "tool_change", "spindle_cw", "flood_on"}), {}),
              "event 4: spindle_ccw, found spindle_cw");
    EXPECT_EQ(compare_events(on, switches({"spindle_ccw", "tool_change", "spindle_ccw", "flood_on"}), {}),
              "event 3: M8, found spindle_ccw");
    const RunRecord off = switches({"spindle_ccw", "spindle_off", "flood_on", "tool_change"});
    EXPECT_EQ(
        compare_events(
            off, switches({"spindle_ccw", "spindle_off", "flood_on", "spindle_off", "tool_change"}), {}),
        "event 4: tool_change, found spindle_off");
}

}  // namespace
}  // namespace gsim::round_trip::compare_runs_test
