// Limits of a run, and warnings about controller keys without effect.
#include "runtime/simulator/simulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::simulator_test {
namespace {

using rrs::PlannerKind;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class SimulatorWithPlanner : public testing::TestWithParam<PlannerKind> {
  protected:
    static machine::Machine machine() {
        machine::Machine machine = af5();
        machine.controller.planner = GetParam();
        return machine;
    }
    static LineMove line(double x, double feed_mm_min) {
        LineMove move;
        move.target = AxisVector::Zero(5);
        move.target[0] = x;
        move.feed.linear_mm_min = feed_mm_min;
        return move;
    }
};

TEST_P(SimulatorWithPlanner, PendingMovesCountAgainstTimeLimit) {
    Simulator simulator(machine(), {.max_time_s = 60});
    simulator.moves().enqueue(line(100, 6000));
    EXPECT_FALSE(simulator.outcome().alarm());
    simulator.moves().enqueue(line(200, 60));
    const Report report = simulator.finish("p");
    EXPECT_EQ(report.status, RunStatus::stopped);
    ASSERT_TRUE(report.alarm);
    EXPECT_THAT(report.alarm->message, HasSubstr("60 s of machine time"));
}

TEST_P(SimulatorWithPlanner, KeepsFirstAlarm) {
    Simulator simulator(machine(), {});
    const motion::PlanError past_range{.status = rrs::Status::RRS_JOINT_LIMIT,
                                       .message = "past its range",
                                       .joint = 1,
                                       .value = 9,
                                       .limit = 8};
    EXPECT_FALSE(simulator.outcome().fail(text::DiagnosticKind::feed, "no feed", {}));
    EXPECT_FALSE(simulator.outcome().fail(past_range, {}));
    ASSERT_TRUE(simulator.outcome().alarm());
    EXPECT_EQ(simulator.outcome().alarm()->message, "no feed");
    EXPECT_FALSE(simulator.outcome().alarm()->axis) << "that of the second error";
    EXPECT_FALSE(simulator.outcome().alarm()->limit);
}

TEST_P(SimulatorWithPlanner, CompletesRunWithinTimeLimit) {
    Simulator simulator(machine(), {.max_time_s = 60});
    simulator.moves().enqueue(line(100, 6000));
    EXPECT_EQ(simulator.finish("p").status, RunStatus::completed);
}

TEST_P(SimulatorWithPlanner, WarnsAboutJerkLimitWithoutEffect) {
    machine::Machine with = machine();
    with.controller.ramps.limit_jerk = true;
    Simulator without_jerks(with, {});
    const bool straight = GetParam() == PlannerKind::linuxcnc || GetParam() == PlannerKind::klipper;
    EXPECT_THAT(without_jerks.finish("p").messages.warnings,
                Contains(HasSubstr(straight ? "limit_jerk has no effect: the planner"
                                            : "limit_jerk has no effect: no axis")));
    for (machine::Axis& axis : with.axes) axis.max_jerk = 1000;
    Simulator with_jerks(with, {});
    EXPECT_EQ(with_jerks.finish("p").messages.warnings.size(), straight ? 1U : 0U);
    Simulator plain(machine(), {});
    EXPECT_THAT(plain.finish("p").messages.warnings, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Planners, SimulatorWithPlanner,
                         testing::Values(PlannerKind::rest_to_rest, PlannerKind::look_ahead,
                                         PlannerKind::linuxcnc, PlannerKind::klipper));

}  // namespace
}  // namespace gsim::simulation::simulator_test
