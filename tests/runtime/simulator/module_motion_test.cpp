#include "runtime/motion_sources/module_motion.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/rcs/rcs_machine.h"
#include "runtime/simulator/make_planner_setup.h"
#include "runtime/simulator/simulator.h"
#include "tests/build_files/build_files.h"
#include "tests/controller/test_module.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::module_motion_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double kStep_s = 0.001;

using rrs::HostProcess;

rrs::RcsModule module_of(HostProcess location, const std::string& path, const machine::Machine& machine) {
    const rcs::RcsMachine described(make_planner_setup(machine));
    if (location == HostProcess::separate_process)
        return rrs::start_rcs_process(tests::program_path("gsim-rcs-host"), path, described.get()).value();
    auto library = rrs::RcsLibrary::load(path, described.get());
    if (!library) throw std::runtime_error(library.error().message);
    return rrs::RcsModule::create(*library, described.get()).value();
}

// The small module has no limits but this one.
constexpr double kRapid_mm_s = 500;

machine::Machine fast_machine() {
    machine::Machine machine = af5();
    machine.path.max_rapid_mm_s = kRapid_mm_s;
    return machine;
}

rrs::RcsModule test_module(HostProcess location, const std::string& name) {
    return module_of(location, rrs::module_path(name), fast_machine());
}

LineMove line_to(double x, double y, MoveKind kind = MoveKind::linear, double feed_mm_min = 6000) {
    LineMove move;
    move.kind = kind;
    move.target = AxisVector::Zero(5);
    move.target[0] = x;
    move.target[1] = y;
    move.feed.linear_mm_min = feed_mm_min;
    return move;
}

class MoveList : public RunOutput {
  public:
    void on_move(const RecordedMove& move) override { moves.push_back(move); }
    std::vector<RecordedMove> moves;
};

class SmallModule : public testing::TestWithParam<HostProcess> {
  protected:
    SmallModule() : simulator(fast_machine(), {}, test_module(GetParam(), "small_module")) {
        simulator.add_output(list);
    }
    MoveList list;
    Simulator simulator;
};

// The module moves at the programmed speed from the first instant to the last.
TEST_P(SmallModule, MovesTakeTimeOfModule) {
    simulator.moves().enqueue(line_to(300, 400));  // 500 mm at 100 mm/s
    simulator.dwells().enqueue(2.5, {});
    simulator.moves().enqueue(line_to(300, 100, MoveKind::rapid));  // 300 mm at the machine's rapid speed
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::completed);
    const double rapid_s = 300 / kRapid_mm_s;
    EXPECT_NEAR(report.cycle_time_s, 5 + 2.5 + rapid_s, 1e-9);
    EXPECT_NEAR(report.times.feed_s, 5, 2 * kStep_s);
    EXPECT_NEAR(report.times.dwell_s, 2.5, 2 * kStep_s);
    EXPECT_NEAR(report.times.rapid_s, rapid_s, 2 * kStep_s);
    EXPECT_NEAR(report.distances.feed_mm, 500, 2 * kStep_s * kRapid_mm_s);
    EXPECT_NEAR(report.distances.feed_mm + report.distances.rapid_mm, 800, 1e-9);
    EXPECT_EQ(report.counts.moves, 3U);
    EXPECT_NEAR(report.bounds[1].max, 400, 1);
    EXPECT_EQ(report.slowest[0].limited_by, "unknown");
}

// The targets are more than the module's queue holds; the module does not report to which target a step
// belongs.
TEST_P(SmallModule, AssignsStepsToTheirMoves) {
    constexpr int kMoves = 50;
    for (int i = 1; i <= kMoves; ++i) ASSERT_TRUE(simulator.moves().enqueue(line_to(10.0 * i, 0)));
    simulator.finish("p");
    ASSERT_EQ(list.moves.size(), static_cast<std::size_t>(kMoves));
    for (int i = 0; i < kMoves; ++i) {
        const RecordedMove& move = list.moves[static_cast<std::size_t>(i)];
        EXPECT_EQ(move.info.target_id, i + 1);
        EXPECT_NEAR(move.start_s, 0.1 * i, kStep_s + 1e-9);
        EXPECT_NEAR(move.end_s, 0.1 * (i + 1), kStep_s + 1e-9);
    }
}

TEST_P(SmallModule, ReportsMissingServiceByName) {
    ArcMove arc;
    arc.target = AxisVector::Zero(5);
    arc.center_mm[0] = 10;
    arc.sweep_rad = 1;
    arc.feed.linear_mm_min = 600;
    EXPECT_FALSE(simulator.moves().enqueue(arc));
    EXPECT_EQ(simulator.outcome().alarm()->message,
              "small_module.so does not support the service SetNextArcTarget.");
}

TEST_P(SmallModule, WarnsAboutMissingPathModes) {
    simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0, 0);
    simulator.moves().enqueue(line_to(10, 0));
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::completed);
    EXPECT_THAT(report.messages.warnings,
                testing::Contains(HasSubstr("does not support path modes (G61, G64)")));
}

INSTANTIATE_TEST_SUITE_P(Places, SmallModule, rrs::both_places(), rrs::place_name);

class ControllerModules : public testing::TestWithParam<HostProcess> {
  protected:
    static rrs::RcsModule test_module(const std::string& name) {
        return module_motion_test::test_module(GetParam(), name);
    }
};

INSTANTIATE_TEST_SUITE_P(Places, ControllerModules, rrs::both_places(), rrs::place_name);

std::string to_alarm(rrs::RcsModule module, RunLimits limits = {}) {
    Simulator simulator(fast_machine(), limits, std::move(module));
    simulator.moves().enqueue(line_to(10, 0));
    simulator.finish("p");
    return simulator.outcome().alarm() ? simulator.outcome().alarm()->message : "";
}

TEST_P(ControllerModules, ReportErrorsWithModuleAndService) {
    EXPECT_THAT(
        to_alarm(test_module("nan_answer")),
        StartsWith("The controller module nan_answer.so responded to GetNextStep with the value nan"));
    EXPECT_THAT(to_alarm(test_module("backwards")),
                HasSubstr("GetNextStep with a time that decreases by 0.001 s"));
    EXPECT_EQ(
        to_alarm(test_module("jump")),
        "The controller module jump.so responded to GetNextStep with a jump: a joint moved in no time.");
    EXPECT_THAT(to_alarm(test_module("never_arrives")),
                StartsWith("The controller module never_arrives.so has not moved for 600"));
    EXPECT_EQ(to_alarm(test_module("small_module")), "");
}

// Motion before the crash is in the report, and the alarm is at the block that was read last.
TEST(ModuleProcess, CrashKeepsMotionBeforeIt) {
    Simulator simulator(fast_machine(), {}, test_module(HostProcess::separate_process, "crashes"));
    MoveList list;
    simulator.add_output(list);
    constexpr int kStepsBefore = 50;  // of hostile_module.c
    bool continues = true;
    for (std::uint32_t line = 1; line <= 50 && continues; ++line) {
        LineMove move = line_to(line, 0);  // 1 mm at 100 mm/s
        move.location.line = line;
        continues = simulator.moves().enqueue(move);
    }
    EXPECT_FALSE(continues);
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::alarm);
    EXPECT_EQ(report.alarm->message, "The controller module crashes.so crashed in GetNextStep (signal 11).");
    EXPECT_EQ(report.alarm->location.line, 14U) << "five moves are made, and eight wait";
    EXPECT_NEAR(report.cycle_time_s, kStepsBefore * kStep_s, 1e-9);
    EXPECT_NEAR(report.bounds[0].max, 5, 1e-9);
    EXPECT_GE(list.moves.size(), 5U);
}

TEST(ModuleProcess, CpuTimeOfModuleCountsForRun) {
    os::CpuLimit cpu(0.5);
    Simulator simulator(fast_machine(), {.cpu = &cpu},
                        test_module(HostProcess::separate_process, "spends_time"));
    bool continues = true;
    for (int i = 1; i <= 1000 && continues; ++i)
        continues = simulator.outcome().count_block({}) && simulator.moves().enqueue(line_to(i, 0));
    EXPECT_FALSE(continues);
    EXPECT_THAT(simulator.finish("p").alarm->message, HasSubstr("of processor time is reached"));
}

// Its targets lie within the ranges; halfway X is 10 m farther.
TEST_P(ControllerModules, StepPastRangeIsViolation) {
    Simulator simulator(fast_machine(), {}, test_module("overshoots"));
    LineMove move = line_to(10, 0);
    move.location.line = 7;
    EXPECT_TRUE(simulator.moves().enqueue(move));
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::violations);
    ASSERT_EQ(report.violations.list.size(), 1U);
    const Violation& violation = report.violations.list.front();
    EXPECT_EQ(violation.axis, 'X');
    EXPECT_EQ(violation.location.line, 7U);
    EXPECT_NEAR(violation.value, report.bounds[0].max, 1e-9) << "the farthest";
    EXPECT_GT(violation.value, 9000);
    EXPECT_EQ(violation.limit, fast_machine().axes[0].max);
    EXPECT_THAT(violation.message, HasSubstr("by a step of the controller module"));
    EXPECT_GT(violation.t_s, 0);
    EXPECT_LT(violation.t_s, report.cycle_time_s);
}

TEST_P(ControllerModules, StepPastRangeIsAlarmWithStopAtFirst) {
    Simulator simulator(fast_machine(), {.stop_at_first = true}, test_module("overshoots"));
    bool continues = true;
    for (int i = 1; i <= 50 && continues; ++i) continues = simulator.moves().enqueue(line_to(10.0 * i, 0));
    EXPECT_FALSE(continues) << "as soon as it is known";
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::alarm);
    EXPECT_EQ(report.alarm->kind, text::DiagnosticKind::axis_limit);
    EXPECT_EQ(report.alarm->axis, 'X');
}

// This module has no ranges and moves anywhere.
TEST_P(ControllerModules, TargetPastRangeIsFoundIfModuleIgnoresRanges) {
    const double excess_mm = fast_machine().axes[0].max + 10;
    Simulator stops(fast_machine(), {.stop_at_first = true}, test_module("small_module"));
    EXPECT_FALSE(stops.moves().enqueue(line_to(excess_mm, 0)));
    EXPECT_EQ(stops.finish("p").status, RunStatus::alarm);
    Simulator continues(fast_machine(), {}, test_module("small_module"));
    EXPECT_TRUE(continues.moves().enqueue(line_to(excess_mm, 0)));
    const Report report = continues.finish("p");
    EXPECT_EQ(report.status, RunStatus::violations);
    EXPECT_EQ(report.violations.count, 1U) << "the target says it, so that its steps need not";
}

TEST_P(ControllerModules, RapidsNeedServiceSetRapid) {
    Simulator simulator(fast_machine(), {}, test_module("no_rapid"));
    EXPECT_TRUE(simulator.moves().enqueue(line_to(10, 0)));
    EXPECT_FALSE(simulator.moves().enqueue(line_to(0, 0, MoveKind::rapid)));
    EXPECT_EQ(simulator.outcome().alarm()->message, "no_rapid.so does not support the service SetRapid.");
}

TEST_P(ControllerModules, MachineTimeLimitHolds) {
    Simulator simulator(fast_machine(), {.max_time_s = 3}, test_module("small_module"));
    simulator.moves().enqueue(line_to(500, 0));
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::stopped);
    EXPECT_NEAR(report.cycle_time_s, 3, 0.1);
}

// Our own planner, in process and as a module, under each kind of controller.
class DefaultModule : public testing::TestWithParam<std::tuple<rrs::PlannerKind, HostProcess>> {};

void put_program(Simulator& simulator) {
    simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0.05, 0);
    for (int i = 1; i <= 200; ++i)
        ASSERT_TRUE(
            simulator.moves().enqueue(line_to(200 + 100 * std::cos(0.1 * i), 200 + 100 * std::sin(0.1 * i))));
    simulator.dwells().enqueue(0.5, {});
    simulator.moves().enqueue(line_to(0, 0, MoveKind::rapid));
    ArcMove arc;
    arc.kind = MoveKind::arc_cw;
    arc.target = AxisVector::Zero(5);
    arc.target[0] = 200;
    arc.center_mm[0] = 100;
    arc.sweep_rad = std::numbers::pi;
    arc.feed.linear_mm_min = 6000;
    simulator.moves().enqueue(arc);
    simulator.events().add("m", "08", {});
}

TEST_P(DefaultModule, ReportMatchesInProcessPlannerWithinSteps) {
    machine::Machine machine = af5();
    const auto& [kind, location] = GetParam();
    machine.controller.planner = kind;
    machine.controller.standstill.dwell_s = 0.01;
    Simulator in_process(machine, {});
    Simulator stepped(machine, {}, module_of(location, tests::default_module_path(), machine));
    put_program(in_process);
    put_program(stepped);
    const Report exact = in_process.finish("p");
    const Report is_sampled = stepped.finish("p");
    ASSERT_EQ(is_sampled.status, RunStatus::completed) << is_sampled.alarm->message;
    EXPECT_NEAR(is_sampled.cycle_time_s, exact.cycle_time_s, 1e-6);
    EXPECT_NEAR(is_sampled.times.feed_s, exact.times.feed_s, 5 * kStep_s);
    EXPECT_NEAR(is_sampled.times.rapid_s, exact.times.rapid_s, 5 * kStep_s);
    EXPECT_NEAR(is_sampled.times.dwell_s, exact.times.dwell_s, 5 * kStep_s);
    EXPECT_NEAR(is_sampled.distances.feed_mm, exact.distances.feed_mm, 0.5);
    EXPECT_EQ(is_sampled.counts.moves, exact.counts.moves);
    EXPECT_NEAR(is_sampled.events[0].t_s, exact.events[0].t_s, 1e-6);
    for (std::size_t axis = 0; axis < exact.bounds.size(); ++axis)
        EXPECT_NEAR(is_sampled.bounds[axis].max, exact.bounds[axis].max, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DefaultModule,
                         testing::Combine(testing::Values(rrs::PlannerKind::rest_to_rest,
                                                          rrs::PlannerKind::look_ahead,
                                                          rrs::PlannerKind::linuxcnc),
                                          rrs::both_places()));

}  // namespace
}  // namespace gsim::simulation::module_motion_test
