// Runs that go on past ranges of axes and into zones, and what they list.

#include <cmath>

#include "tests/lua_lib/run.h"

namespace gsim::script::violations_test {
namespace {

using simulation::RunStatus;
using simulation::Violation;

Conditions continues(Conditions setup = {}) {
    setup.limits.stop_at_first = false;
    return setup;
}

Conditions with_x_range(double min, double max) {
    Conditions setup = continues();
    setup.machine.axes[0].min = min;
    setup.machine.axes[0].max = max;
    return setup;
}

Conditions with_zone(machine::ZoneKind kind, double min_mm, double max_mm) {
    Conditions setup = continues();
    machine::Zone zone;
    zone.kind = kind;
    zone.active_at_start = true;
    zone.limits[0] = machine::ZoneLimits{min_mm, max_mm};
    setup.options.data.security_zones[1] = zone;
    return setup;
}

struct Wanted {
    std::uint32_t line;
    char axis;
    double value, limit;
};

void expect_list(const Outcome& run, const std::vector<Wanted>& expected_value) {
    ASSERT_EQ(run.report.violations.list.size(), expected_value.size());
    EXPECT_EQ(run.report.violations.count, expected_value.size());
    for (std::size_t i = 0; i < expected_value.size(); ++i) {
        const Violation& violation = run.report.violations.list[i];
        EXPECT_EQ(violation.location.line, expected_value[i].line) << i;
        EXPECT_EQ(violation.axis, expected_value[i].axis) << i;
        EXPECT_NEAR(violation.value, expected_value[i].value, 1e-9) << i;
        EXPECT_NEAR(violation.limit, expected_value[i].limit, 1e-9) << i;
    }
}

TEST(Violations, AllAreListedAndRunContinues) {
    const char* program = "G0 X10 Y10\nG1 X-5 Y-2 F6000\nG1 X20\nG1 Y2500\nG1 Y100 B-400\nG1 B0\nM30\n";
    const Outcome run = script::run(program, continues());
    EXPECT_EQ(run.report.status, RunStatus::violations);
    EXPECT_FALSE(run.report.alarm);
    expect_list(
        run,
        {{2, 'X', -5, 0}, {2, 'Y', -2, 0}, {3, 'Y', -2, 0}, {4, 'Y', 2500, 2438.4}, {5, 'B', -400, -360}});
    ASSERT_TRUE(run.report.violations.valid_until_s());
    EXPECT_EQ(*run.report.violations.valid_until_s(), run.moves[0].end_s);
    EXPECT_EQ(run.report.violations.list[0].message, "axis X moves to -5 mm, 5 mm past its limit of 0 mm");
    EXPECT_EQ(run.report.violations.list[4].message,
              "axis B moves to -400 deg, 40 deg past its limit of -360 deg");
    // The time is that of the same machine with wider ranges.
    Conditions wide = continues();
    for (machine::Axis& axis : wide.machine.axes) axis.min = -1e4, axis.max = 1e4;
    const Outcome free = script::run(program, wide);
    EXPECT_TRUE(free.completed());
    EXPECT_EQ(run.report.cycle_time_s, free.report.cycle_time_s);
}

TEST(Violations, ArcCountsByFarthestPoint) {
    const Outcome run = script::run("G0 X10 Y100\nG3 X10 Y60 I0 J-20 F6000\nG0 X30\nM30\n", continues());
    expect_list(run, {{2, 'X', -10, 0}});  // about X10 Y80, radius 20
    EXPECT_EQ(run.moves[1].info.out_of_range, 1U);
    EXPECT_EQ(run.moves[2].info.out_of_range, 0U);
}

TEST(Violations, MoveBackIntoRangeIsNone) {
    const Outcome run = script::run("G1 X-5 F6000\nG1 X-3\nG2 X5 Y8 I4 J4\nG1 X8\nM30\n", continues());
    expect_list(run, {{1, 'X', -5, 0}, {2, 'X', -3, 0}, {3, 'X', 1 - std::sqrt(32.0), 0}});
    const Outcome back = script::run("G1 X-5 F6000\nG1 X10\nM30\n", continues());
    expect_list(back, {{1, 'X', -5, 0}});
}

TEST(Violations, LimitsListButCountsAll) {
    const Outcome run = run_lua("F(60000) for i = 1, 600 do G1{x=-1} G1{x=-2} end", continues());
    EXPECT_EQ(run.report.violations.list.size(), 1000U);
    EXPECT_EQ(run.report.violations.count, 1200U);
}

TEST(Violations, StopAtFirstEndsRun) {
    const Outcome run = script::run("G0 X10\nG1 X-5 F6000\nG1 X-6\n");
    expect_alarm(run, 2, {"axis X would move to -5 mm, past its limit of 0 mm"});
    EXPECT_TRUE(run.report.violations.list.empty());
    EXPECT_EQ(run.moves.size(), 1U);
}

TEST(Violations, UnrecoverableErrorStillStopsRun) {
    const Outcome run = script::run("G1 X-5 F6000\nG2 X10 Y10 I50 J3\nG1 X-6\n", continues());
    expect_alarm(run, 2, {"the arc is impossible"});
    expect_list(run, {{1, 'X', -5, 0}});
    expect_alarm(run_lua("F(600) G1{x=-5}\nlocal status\nstatus = rrs.SetNextTarget({-7, 0, 0, 0, 0})\n"
                         "error(\"status \" .. status)",
                         continues()),
                 4, {"status -7"});
}

TEST(Violations, ReportCallsAndWorkOffset) {
    const Outcome run = script::run("O1\nG55\nM98 P2\nM30\nO2\nG0 X-5\nM99\n", continues());
    ASSERT_EQ(run.report.violations.list.size(), 1U);
    const Violation& violation = run.report.violations.list[0];
    EXPECT_EQ(violation.offset, "G55");
    ASSERT_EQ(violation.calls.size(), 1U);
    EXPECT_EQ(violation.calls[0].program, "O2");
    EXPECT_EQ(violation.calls[0].location.line, 3U);
}

// The list has one entry for each time that the tool enters, with the depth of entry.
TEST(Violations, EachEntryIntoForbiddenZoneIsListed) {
    const Outcome run = script::run("G1 X110 F6000\nG1 X140\nG1 X90\nG1 X300\nG1 X250\nM30\n",
                                    with_zone(machine::ZoneKind::enter_forbidden, 100, 200));
    EXPECT_EQ(run.report.status, RunStatus::violations);
    expect_list(run, {{1, 'X', 140, 100}, {4, 'X', 200, 100}});
    // 10 mm before the end of the move, as it slows down.
    const double ramp_s = 100 / kAcceleration_mm_s2;
    EXPECT_NEAR(run.report.violations.list[0].t_s, 1.1 + ramp_s - std::sqrt(20 / kAcceleration_mm_s2), 1e-9);
    EXPECT_EQ(run.report.violations.list[0].zone, "security zone 1");
    EXPECT_EQ(
        run.report.violations.list[0].message,
        "the tool enters security zone 1: it moves 40 mm past the limit at X 100 mm, and must stay outside");
    EXPECT_EQ(run.moves.size(), 5U);
}

TEST(Violations, MoveLeavingZoneAndReturningIsListed) {
    // A circle about X150, radius 60, in a zone from X100 on: it leaves it and comes back in one move.
    const Outcome run = script::run("G0 X150 Y160\nG0 X210 Y100\nG3 I-60 F6000\nM30\n",
                                    with_zone(machine::ZoneKind::leave_forbidden, 100, 300));
    ASSERT_EQ(run.report.violations.list.size(), 2U);
    expect_list(run, {{1, 'X', 0, 100}, {3, 'X', 90, 100}});
    EXPECT_EQ(run.report.violations.list[0].message,
              "the tool is not inside security zone 1 when that becomes active: it moves 100 mm past the "
              "limit at X 100 mm, and must stay inside");
}

TEST(Violations, SuggestShiftsIntoRange) {
    const Outcome run = script::run("G54\nG0 X-12.5 Y10\nG55\nG0 Y2440 X10\nM30\n", continues());
    const auto& shifts = run.report.violations.shifts;
    ASSERT_EQ(shifts.size(), 2U);
    EXPECT_EQ(shifts[0].offset, "G54");
    EXPECT_EQ(shifts[0].shift_mm, 12.5);
    EXPECT_EQ(shifts[1].offset, "G55");
    EXPECT_EQ(shifts[1].axis, 'Y');
    EXPECT_NEAR(shifts[1].shift_mm, -1.6, 1e-12);
    EXPECT_TRUE(run.report.violations.suggested_fix.empty());
    EXPECT_TRUE(script::run("G0 X-1\nG0 X20\nM30\n", with_x_range(0, 10)).report.violations.shifts.empty());
    EXPECT_TRUE(script::run("G0 B-400\nM30\n", continues()).report.violations.shifts.empty());
}

TEST(Violations, AreListedWithLookAheadController) {
    Conditions setup = continues();
    setup.machine.controller.planner = rrs::PlannerKind::look_ahead;
    const Outcome run = script::run("G1 X10 F6000\nG1 X-5\nG1 Y50\nG1 X20\nG1 Y-3\nM30\n", setup);
    expect_list(run, {{2, 'X', -5, 0}, {3, 'X', -5, 0}, {5, 'Y', -3, 0}});
    EXPECT_GT(*run.report.violations.valid_until_s(), 0);
}

}  // namespace
}  // namespace gsim::script::violations_test
