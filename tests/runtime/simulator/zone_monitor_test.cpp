// Zones along random programs: the alarm is at the first instant at which the planned motion is not allowed.
#include "runtime/monitors/zone_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::zone_watch_test {
namespace {

using machine::ZoneKind;
using rrs::CornerRule;
using rrs::PlannerKind;

constexpr double kWall_mm = 1e-6;
constexpr int kMoves = 25;

class Collected final : public RunOutput {
  public:
    void on_segment(const motion::Segment& segment, const MoveInfo& /*info*/) override {
        if (segment.duration_s > 0) segments.push_back(segment);
    }

    rrs::JointPos at(double t_s) const {
        const auto behind =
            std::upper_bound(segments.begin(), segments.end(), t_s,
                             [](double t, const motion::Segment& segment) { return t < segment.start_s; });
        const motion::Segment& segment = *(behind == segments.begin() ? behind : std::prev(behind));
        return segment.position_at(t_s - segment.start_s);
    }
    double end_s() const { return segments.empty() ? 0 : segments.back().end_s(); }

    std::vector<motion::Segment> segments;
};

/// Returns the depth of a point within the walls, mm; negative: outside.
double depth_mm(const machine::Zone& zone, const rrs::JointPos& at) {
    double depth = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const auto& walls = zone.limits[static_cast<std::size_t>(i)];
        if (walls) depth = std::min({depth, at[i] - walls->min_mm, walls->max_mm - at[i]});
    }
    return depth;
}

/// Below 0: not allowed.
double allowance_mm(const machine::Zone& zone, const rrs::JointPos& at) {
    return zone.kind == ZoneKind::enter_forbidden ? -depth_mm(zone, at) : depth_mm(zone, at);
}

/// Returns a zone about a position that the motion passes, or about its start.
machine::Zone random_zone(std::mt19937& random, const Collected& run) {
    machine::Zone zone;
    zone.kind = random() % 2 == 0 ? ZoneKind::enter_forbidden : ZoneKind::leave_forbidden;
    const bool out = zone.kind == ZoneKind::enter_forbidden;
    const rrs::JointPos about = run.at(out ? between(random, 0.1, 1) * run.end_s() : 0);
    for (int i = 0; i < 3; ++i) {
        if (random() % 4 == 0 && i > 0) continue;
        zone.limits[static_cast<std::size_t>(i)] = {about[i] - around(random, out ? 3 : 30, 0.7),
                                                    about[i] + around(random, out ? 3 : 30, 0.7)};
    }
    return zone;
}

/// Returns the smallest allowance of samples between two instants.
double least_allowance_mm(const machine::Zone& zone, const Collected& run, double from_s, double to_s,
                          double step_s) {
    double min = std::numeric_limits<double>::infinity();
    for (double t_s = std::max(from_s, 0.0); t_s < to_s; t_s += step_s)
        min = std::min(min, allowance_mm(zone, run.at(t_s)));
    return min;
}

void expect_first(const machine::Zone& zone, const Collected& run, double hit_s) {
    EXPECT_GE(least_allowance_mm(zone, run, 0, hit_s, 1e-3), -kWall_mm);
    EXPECT_GE(least_allowance_mm(zone, run, hit_s - 0.1, hit_s, 1e-5), -kWall_mm);
    EXPECT_NEAR(allowance_mm(zone, run.at(hit_s)), 0, kWall_mm);
    const double soon_s = std::min(hit_s + 2e-4, run.end_s());
    EXPECT_LE(least_allowance_mm(zone, run, hit_s, soon_s, 1e-5), kWall_mm);
}

machine::Machine machine_with(std::mt19937& random, PlannerKind planner, CornerRule corner, bool jerk) {
    machine::Machine machine = random_machine(random, af5());
    machine.controller.planner = planner;
    machine.controller.corners.continuous = corner;
    machine.controller.ramps.limit_jerk = jerk;
    machine.controller.corners.blend_tolerance_mm = 0.5;
    if (planner == PlannerKind::linuxcnc) machine.controller.position_loop.servo_period_s = 0.001;
    return machine;
}

struct Case {
    PlannerKind planner;
    CornerRule corner;
    bool jerk;
};

class ZonesWithEachPlanner : public testing::TestWithParam<Case> {};

TEST_P(ZonesWithEachPlanner, EndRunAtFirstForbiddenInstant) {
    int hits = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const machine::Machine machine =
            machine_with(random, GetParam().planner, GetParam().corner, GetParam().jerk);
        Collected run;
        Simulator free(machine, {});
        free.add_output(run);
        free.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        std::mt19937 moves(seed + 1000);
        make_random_moves(moves, free, kMoves);
        const Report full = free.finish("p");
        ASSERT_FALSE(run.segments.empty());
        machine::MachineData data;
        data.security_zones[3] = random_zone(random, run);
        const machine::Zone& zone = data.security_zones[3];
        if (allowance_mm(zone, run.at(0)) < kWall_mm) continue;

        Simulator monitored(machine, {.stop_at_first = true});
        monitored.program().zones().set_data(data);
        monitored.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        moves.seed(seed + 1000);
        make_random_moves(moves, monitored, kMoves);
        const Report report = monitored.finish("p");
        if (report.status == full.status && report.cycle_time_s == full.cycle_time_s) {
            EXPECT_GE(least_allowance_mm(zone, run, 0, run.end_s(), 1e-3), -kWall_mm);
            continue;
        }
        ++hits;
        EXPECT_EQ(report.status, RunStatus::alarm);
        expect_first(zone, run, report.cycle_time_s);
    }
    EXPECT_GT(hits, 15);
}

/// Expects entries where the tool passes from a permitted to a forbidden position, and no missing ones.
void expect_entries(const machine::Zone& zone, const Collected& run, const std::vector<Violation>& entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const double from_s = entries[i].t_s;
        EXPECT_NEAR(allowance_mm(zone, run.at(from_s)), 0, kWall_mm) << i;
        EXPECT_LE(least_allowance_mm(zone, run, from_s, std::min(from_s + 2e-4, run.end_s()), 1e-5),
                  kWall_mm);
    }
    std::size_t begun = 0;
    double allowed_s = 0;
    bool allowed = true;
    for (double t_s = 0; t_s < run.end_s(); t_s += 1e-3) {
        const double allowance = allowance_mm(zone, run.at(t_s));
        while (begun < entries.size() && entries[begun].t_s <= t_s) ++begun;
        if (allowance > kWall_mm) {
            allowed = true;
            allowed_s = t_s;
        } else if (allowance < -1e-3) {
            ASSERT_GT(begun, 0U) << t_s;
            if (allowed) {
                EXPECT_GE(entries[begun - 1].t_s, allowed_s) << t_s;
            }
            if (!allowed) {
                EXPECT_LE(entries[begun - 1].t_s, t_s) << t_s;
            }
            EXPECT_GE(entries[begun - 1].amount(), 0) << t_s;
            allowed = false;
        }
    }
}

TEST_P(ZonesWithEachPlanner, ListEachEntryWithoutChangingMotion) {
    std::size_t entries = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const machine::Machine machine =
            machine_with(random, GetParam().planner, GetParam().corner, GetParam().jerk);
        Collected run;
        Simulator free(machine, {});
        free.add_output(run);
        free.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        std::mt19937 moves(seed + 1000);
        make_random_moves(moves, free, kMoves);
        const Report full = free.finish("p");
        machine::MachineData data;
        data.security_zones[3] = random_zone(random, run);
        if (allowance_mm(data.security_zones[3], run.at(0)) < kWall_mm) continue;
        Simulator monitored(machine, {});
        monitored.program().zones().set_data(data);
        monitored.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        moves.seed(seed + 1000);
        make_random_moves(moves, monitored, kMoves);
        const Report report = monitored.finish("p");
        EXPECT_EQ(report.cycle_time_s, full.cycle_time_s);
        std::vector<Violation> of_zone;
        for (const Violation& violation : report.violations.list) {
            if (!violation.zone.empty()) of_zone.push_back(violation);
        }
        entries += of_zone.size();
        expect_entries(data.security_zones[3], run, of_zone);
    }
    EXPECT_GT(entries, 30U);
}

INSTANTIATE_TEST_SUITE_P(Planners, ZonesWithEachPlanner,
                         testing::Values(Case{PlannerKind::rest_to_rest, CornerRule::stop, false},
                                         Case{PlannerKind::rest_to_rest, CornerRule::stop, true},
                                         Case{PlannerKind::look_ahead, CornerRule::velocity_step, true},
                                         Case{PlannerKind::look_ahead, CornerRule::junction_deviation, false},
                                         Case{PlannerKind::look_ahead, CornerRule::parabolic_blend, false},
                                         Case{PlannerKind::look_ahead, CornerRule::smooth_blend, true},
                                         Case{PlannerKind::linuxcnc, CornerRule::stop, false}));

LineMove line_to(double x, double y, SourceLocation location = {}) {
    LineMove move;
    move.target = AxisVector::Zero(5);
    move.target[0] = x;
    move.target[1] = y;
    move.feed.linear_mm_min = 6000;
    move.location = location;
    return move;
}

machine::MachineData security_zone(double min_x, double max_x) {
    machine::MachineData data;
    data.security_zones[7].limits[0] = {min_x, max_x};
    data.security_zones[7].switch_number = 2;
    return data;
}

/// Returns a simulator that knows blocks ahead: segments come long after the moves.
Simulator& with_look_ahead(std::unique_ptr<Simulator>& simulator) {
    machine::Machine machine = af5();
    machine.controller.planner = PlannerKind::look_ahead;
    simulator = std::make_unique<Simulator>(machine, RunLimits{.stop_at_first = true});
    return *simulator;
}

TEST(ZoneMonitor, AlarmNamesMovingBlockNotReadBlock) {
    std::unique_ptr<Simulator> owner;
    Simulator& simulator = with_look_ahead(owner);
    simulator.program().zones().set_data(security_zone(100, 200));
    simulator.program().files().add("part.nc");
    simulator.moves().enqueue(line_to(50, 0, {0, 1}));
    simulator.program().calls().enter("O2", {0, 2});
    simulator.moves().enqueue(line_to(150, 0, {0, 10}));
    simulator.program().calls().leave();
    simulator.events().add("message", "later", {0, 3}, EventTiming::in_passing);
    simulator.moves().enqueue(line_to(300, 0, {0, 4}));
    simulator.outcome().fail(text::DiagnosticKind::script, "the program has a fault of its own", {0, 5});
    const Report report = simulator.finish("p");
    ASSERT_TRUE(report.alarm);
    EXPECT_EQ(report.alarm->location.line, 10U);
    ASSERT_EQ(report.alarm->calls.size(), 1U);
    EXPECT_EQ(report.alarm->calls[0].program, "O2");
    EXPECT_NE(report.alarm->message.find("enters security zone 7 on axis X, at X100.0000"), std::string::npos)
        << report.alarm->message;
    EXPECT_EQ(report.alarm->axis, 'X');
    EXPECT_NEAR(report.alarm->value.value(), 100, 1e-9);
    EXPECT_EQ(report.alarm->limit.value(), 100);
    EXPECT_TRUE(report.events.empty());
    EXPECT_NEAR(report.distances.feed_mm, 100, 1e-9);
    EXPECT_NEAR(report.bounds[0].max, 100, 1e-9);
}

TEST(ZoneMonitor, SwitchesApplyFromNextTarget) {
    for (const bool on_behind : {true, false}) {
        std::unique_ptr<Simulator> owner;
        Simulator& simulator = with_look_ahead(owner);
        simulator.program().zones().set_data(security_zone(100, 200));
        EXPECT_FALSE(simulator.program().zones().switch_zones(1, false));
        EXPECT_TRUE(simulator.program().zones().switch_zones(2, false));
        simulator.moves().enqueue(line_to(300, 0, {0, 1}));
        EXPECT_TRUE(simulator.program().zones().switch_zones(2, on_behind));
        simulator.moves().enqueue(line_to(150, 0, {0, 2}));
        const Report report = simulator.finish("p");
        ASSERT_EQ(report.alarm.has_value(), on_behind);
        if (!on_behind) continue;
        EXPECT_EQ(report.alarm->location.line, 2U);
        EXPECT_NEAR(report.alarm->value.value(), 200, 1e-9);
    }
}

TEST(ZoneMonitor, AppliesToolOffsetOfEachMove) {
    Simulator simulator(af5(), {.stop_at_first = true});
    simulator.program().zones().set_data(security_zone(100, 200));
    simulator.moves().enqueue(line_to(90, 0, {0, 1}));
    simulator.program().tool().set({30, 0, 0});
    simulator.moves().enqueue(line_to(125, 0, {0, 2}));
    simulator.moves().enqueue(line_to(140, 0, {0, 3}));
    const Report report = simulator.finish("p");
    ASSERT_TRUE(report.alarm);
    EXPECT_EQ(report.alarm->location.line, 3U);
    EXPECT_NEAR(report.alarm->value.value(), 100, 1e-9);
    EXPECT_NEAR(report.bounds[0].max, 130, 1e-9);
}

TEST(ZoneMonitor, EndsRunIfToolIsInZoneAtActivation) {
    Simulator simulator(af5(), {.stop_at_first = true});
    simulator.program().zones().set_data(security_zone(100, 200));
    simulator.program().zones().switch_zones(2, false);
    simulator.moves().enqueue(line_to(150, 0, {0, 1}));
    const double stands_s = simulator.clock().time_s();
    simulator.program().zones().switch_zones(2, true);
    simulator.moves().enqueue(line_to(250, 0, {0, 2}));
    const Report report = simulator.finish("p");
    ASSERT_TRUE(report.alarm);
    EXPECT_EQ(report.alarm->location.line, 2U);
    EXPECT_NE(report.alarm->message.find("is not outside security zone 7"), std::string::npos);
    EXPECT_EQ(report.cycle_time_s, stands_s);
}

TEST(ZoneMonitor, WarnsAboutWallsOnMissingAxis) {
    machine::Machine machine = af5();
    for (machine::Axis& axis : machine.axes) axis.letter = axis.letter == 'X' ? 'U' : axis.letter;
    Simulator simulator(machine, {});
    simulator.program().zones().set_data(security_zone(100, 200));
    const Report report = simulator.finish("p");
    ASSERT_EQ(report.messages.warnings.size(), 1U);
    EXPECT_NE(report.messages.warnings[0].find("no linear axis X"), std::string::npos);
}

}  // namespace
}  // namespace gsim::simulation::zone_watch_test
