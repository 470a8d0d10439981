// Rotary axes: the same orientation with less turning, within the axes' ranges.
#include "toolpath/rotary/rotary_plan.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path::rotary_plan_test {
namespace {

machine::Machine built_in() {
    return machine::read_machine(machine::built_in_machine_toml(), "m").value();
}

Point turned(double x, double b, double c, MotionType motion = MotionType::linear) {
    Point point;
    point.motion = motion;
    point.position_mm = {x, 100, 100};
    point.orientation = RotaryAxes{{'B', b}, {'C', c}};
    point.feed_mm_min = 1000;
    return point;
}

struct Planned {
    machine::Machine machine = built_in();
    Program program;
    tl::expected<std::vector<RotarySchedule>, TargetError> turns = tl::unexpected(TargetError{});

    explicit Planned(std::vector<Target> targets, RotaryOptions options = {}) {
        program = {"n", {{"root", std::move(targets)}}, 0};
        plan(options);
    }
    explicit Planned(Program given) : program(std::move(given)) { plan({}); }
    void plan(RotaryOptions options) {
        const MachineSpace space = MachineSpace::make(machine).value();
        const States states(program);
        turns = plan_rotary(program, space, states, options);
    }
    double b(std::size_t target) const { return turns.value()[0].at(target)[0]; }
    const std::vector<RotarySchedule::Unwinding>& unwindings() const { return turns.value()[0].unwindings; }
};

TEST(RotaryPlan, AvoidsUnnecessaryFullTurns) {
    const Planned planned({turned(0, 170, 10), turned(1, -170, 10), turned(2, -150, 10), turned(3, 180, 10)});
    EXPECT_TRUE(planned.unwindings().empty());
    for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(std::abs(planned.b(i) - planned.b(i - 1)), 60) << i;
}

TEST(RotaryPlan, LiteralOptionKeepsGivenValues) {
    const Planned planned({turned(0, 170, 10), turned(1, -170, 10), turned(2, 190, 10)},
                          {.is_literal = true});
    EXPECT_EQ(planned.b(1), -170);
    EXPECT_EQ(planned.b(2), 190);
}

// Five turns in steps of 30 deg within -360..360: some stops are needed, and no more than that.
TEST(RotaryPlan, UnwindsAsRarelyAsPossible) {
    std::vector<Target> targets;
    for (int i = 0; i <= 60; ++i) targets.emplace_back(turned(i, 30 * i, 20));
    const Planned planned(std::move(targets));
    EXPECT_EQ(planned.unwindings().size(), 2U) << "720 deg at a time: 1800 deg are three pieces";
    double at = planned.b(0);
    std::size_t next = 0;
    for (std::size_t i = 0; i <= 60; ++i) {
        EXPECT_LE(std::abs(planned.b(i)), 360);
        EXPECT_NEAR(std::remainder(planned.b(i) - 30.0 * static_cast<double>(i), 360), 0, 1e-9);
        EXPECT_NEAR(std::abs(planned.b(i) - at), i == 0 ? 0 : 30, 1e-9) << i;
        at = planned.b(i);
        if (next < planned.unwindings().size() && planned.unwindings()[next].target == i) {
            at = planned.unwindings()[next++].to[0];
            EXPECT_NEAR(std::remainder(at - planned.b(i), 360), 0, 1e-9);
        }
    }
}

TEST(RotaryPlan, UnwindsWhileJetIsOffIfSufficient) {
    std::vector<Target> targets;
    for (int i = 0; i <= 33; ++i) {
        Point point = turned(i, 30 * i, 20);
        if (i == 0 || i == 21) point.actions = {"waterjet_on"};
        if (i == 20) point.actions = {"waterjet_off"};
        targets.emplace_back(point);
    }
    const Planned planned(std::move(targets));
    for (const RotarySchedule::Unwinding& each : planned.unwindings()) EXPECT_EQ(each.target, 20U);
}

TEST(RotaryPlan, TurnsJetOffWhileUnwinding) {
    struct Log : MoveSink {
        bool jet = false;
        int turns = 0;
        AxisValues before = AxisValues::Zero(5);
        void move(const AxisMove& move) override {
            if (move.axes.head(3) == before.head(3) && move.rapid && turns >= 0) {
                EXPECT_FALSE(jet);
                ++turns;
            }
            before = move.axes;
        }
        void dwell(double) override {}
        void acceleration(double) override {}
        void action(const std::string& name) override { jet = name == "waterjet_on"; }
        void call(const SubPath&) override {}
        void note(const TargetId&, std::string_view) override {}
    };
    std::vector<Target> targets;
    for (int i = 0; i <= 60; ++i) targets.emplace_back(turned(i, 30 * i, 20));
    std::get<Point>(targets[0]).actions = {"waterjet_on"};
    const Planned planned(std::move(targets));
    const MachineSpace space = MachineSpace::make(planned.machine).value();
    const States states(planned.program);
    Log log;
    ASSERT_TRUE(AxisMoves(planned.program, space, states, *planned.turns, {}).run(0, log));
    EXPECT_EQ(log.turns, 2);
    EXPECT_TRUE(log.jet) << "on again behind each";
}

// Orientation by the tool's axis: the machine's forward kinematics point in the direction of the path.
TEST(RotaryPlan, ReachesToolAxesWithoutUnwinding) {
    const machine::Machine machine = built_in();
    std::vector<Target> targets;
    for (int i = 0; i <= 72; ++i) {
        const double angle = i * 10 * std::numbers::pi / 180;
        Point point = turned(i, 0, 0);
        point.orientation = ToolAxis{{std::cos(angle), std::sin(angle), 2}};
        targets.emplace_back(point);
    }
    const Planned planned(std::move(targets));
    ASSERT_TRUE(planned.turns) << planned.turns.error().message;
    const auto kinematics = machine::make_kinematics(machine);
    const MachineSpace space = MachineSpace::make(machine).value();
    for (std::size_t i = 0; i <= 72; ++i) {
        const auto& point = std::get<Point>(planned.program.paths[0].targets[i]);
        const AxisValues axes =
            space.axes(Eigen::Vector3d(point.position_mm.data()), planned.turns.value()[0].at(i));
        rrs::JointPos joints(axes.size());
        for (Eigen::Index k = 0; k < axes.size(); ++k) {
            joints[k] = machine::joint_value(machine.axes[static_cast<std::size_t>(k)], axes[k]);
        }
        const rrs::CartPos pose = kinematics->forward(joints);
        const Eigen::Vector3d expected_value =
            Eigen::Vector3d(std::get<ToolAxis>(*point.orientation).direction.data()).normalized();
        EXPECT_LT((pose.linear().col(2) - expected_value).norm(), 1e-9) << i;
        EXPECT_LT((pose.translation() - Eigen::Vector3d(point.position_mm.data())).norm(), 1e-9) << i;
        EXPECT_FALSE(space.find_axis_range_error(axes));
    }
    EXPECT_TRUE(planned.unwindings().empty()) << "two turns fit into -360..360";
}

void expect_fault(const Planned& planned, std::size_t target, const std::string& part) {
    ASSERT_FALSE(planned.turns);
    EXPECT_EQ(planned.turns.error().where.target, target) << planned.turns.error().message;
    EXPECT_NE(planned.turns.error().message.find(part), std::string::npos) << planned.turns.error().message;
}

TEST(RotaryPlan, ErrorsNameTarget) {
    Point bare = turned(0, 0, 0);
    bare.orientation.reset();
    expect_fault(Planned({bare}), 0, "needs an orientation");
    expect_fault(Planned({turned(0, 0, 0), turned(1, 0, 95)}), 1, "out of reach");
    Point wrong = turned(0, 0, 0);
    wrong.orientation = RotaryAxes{{'A', 1}};
    expect_fault(Planned({wrong}), 0, "no rotary axis A");
    Point below = turned(0, 0, 0);
    below.orientation = ToolAxis{{0.1, 0, -1}};
    expect_fault(Planned({below}), 0, "");
}

TEST(RotaryPlan, RejectsDifferentInheritedOrientations) {
    Point bare = turned(5, 0, 0);
    bare.orientation.reset();
    Program program{
        "n",
        {{"root", {turned(0, 10, 0), SubPath{1, 1}, turned(0, 20, 0), SubPath{1, 1}}}, {"sub", {bare}}},
        0};
    expect_fault(Planned(program), 0, "the uses of the sub-path have different ones");
    std::get<Point>(program.paths[0].targets[2]).orientation = RotaryAxes{{'B', 10}, {'C', 0}};
    EXPECT_TRUE(Planned(program).turns);
}

}  // namespace
}  // namespace gsim::path::rotary_plan_test
