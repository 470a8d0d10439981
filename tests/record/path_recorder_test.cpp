// What is recorded of a run, against the moves that the machine made.
#include "runtime/record/path_recorder.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/machine/machine_file.h"
#include "runtime/path/arc_shape.h"
#include "runtime/simulation/run_output.h"
#include "runtime/simulation/simulator.h"
#include "tests/simulation/random_program.h"

namespace gsim::record {
namespace {

using Eigen::Vector3d;
using path::CenterArc;
using path::MotionType;
using path::Point;
using simulation::ArcMove;
using simulation::AxisVector;
using simulation::LineMove;
using simulation::MoveKind;
using simulation::RecordedMove;
using simulation::Simulator;
using testing::ElementsAre;

machine::Machine sample(const std::string& name) {
    machine::Machine machine =
        machine::load_machine(fmt::format("{}/machines/{}.toml", GSIM_SAMPLES, name)).value();
    machine.controller = {};  // rest to rest: moves end where they are programmed
    return simulation::unlimited(std::move(machine));
}

class MovesMade : public simulation::RunOutput {
  public:
    using RunOutput::take;
    void take(const RecordedMove& move) override { moves.push_back(move); }
    std::vector<RecordedMove> moves;
};

struct RunOf {
    explicit RunOf(const machine::Machine& machine)
        : simulator(machine, {}), recorder(simulator.machine()), place(simulator.machine()) {
        simulator.add_output(made);
        simulator.set_observer(recorder);
    }
    std::vector<Point> points() {
        simulator.finish("p");
        const path::Program program = recorder.finish("p").value();
        std::vector<Point> points;
        for (const path::Target& target : program.paths[program.root].targets) {
            points.push_back(std::get<Point>(target));
        }
        return points;
    }
    AxisVector axes(std::initializer_list<double> values) const {
        AxisVector axes(static_cast<Eigen::Index>(values.size()));
        std::copy(values.begin(), values.end(), axes.begin());
        return axes;
    }
    void line(const AxisVector& target, double feed_mm_min = 600) {
        LineMove move;
        move.target = target;
        move.feed = {feed_mm_min, 360, {}};
        ASSERT_TRUE(simulator.move(move)) << simulator.alarm()->message;
    }

    Simulator simulator;
    MovesMade made;
    PathRecorder recorder;
    ToolPlace place;
};

double length_mm(const path::Vector& from, const Point& to) {
    if (to.motion != MotionType::circular)
        return (path::to_eigen(to.position_mm) - path::to_eigen(from)).norm();
    const path::ArcShape arc = path::arc_shape(from, to).value();
    return std::hypot(arc.radius_mm() * arc.turn_rad, arc.rise_mm);
}

AxisVector axes_of(const machine::Machine& machine, const rrs::JointPos& joints) {
    AxisVector axes(joints.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i) {
        axes[i] = machine::axis_value(machine.axes[static_cast<std::size_t>(i)], joints[i]);
    }
    return axes;
}

double distance_mm(const path::Vector& a, const Vector3d& b) {
    return (path::to_eigen(a) - b).norm();
}

TEST(PathRecorder, PassesTheEndsOfRandomMovesInTheirOrderBySameLengths) {
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        RunOf run(sample("af5"));
        run.line(run.axes({1, 2, 3, 4, 5}));
        simulation::make_random_moves(random, run.simulator, 60);
        const std::vector<Point> points = run.points();
        double recorded_mm = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            recorded_mm += length_mm(points[i - 1].position_mm, points[i]);
        }
        double made_mm =
            -run.made.moves.front().length_mm;  // of the first point, where it starts is not told
        auto point = points.begin();
        for (const RecordedMove& move : run.made.moves) {
            made_mm += move.length_mm;
            const Vector3d end = run.place.tip(axes_of(run.simulator.machine(), move.end));
            point = std::find_if(point, points.end(), [&](const Point& each) {
                return distance_mm(each.position_mm, end) < 1e-8;
            });
            ASSERT_NE(point, points.end());
        }
        EXPECT_NEAR(recorded_mm, made_mm, 1e-6 * made_mm);
    }
}

// The point of the circle after a share of an arc, by the definition of ArcMove.
AxisVector on_arc(const AxisVector& start, const ArcMove& move, int first, int second, double share) {
    const double x = start[first] - move.center_first_mm;
    const double y = start[second] - move.center_second_mm;
    const double angle = (move.kind == MoveKind::arc_ccw ? 1 : -1) * share * move.sweep_rad;
    AxisVector axes = start + share * (move.target - start);
    axes[first] = move.center_first_mm + x * std::cos(angle) - y * std::sin(angle);
    axes[second] = move.center_second_mm + x * std::sin(angle) + y * std::cos(angle);
    return axes;
}

// Where the work is turned, arcs of the axes lie anywhere in the work frame.
TEST(PathRecorder, ArcsUnderAnyPositionOfTheRotaryAxesAreExact) {
    constexpr std::array<std::array<int, 3>, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    std::mt19937 random(11);
    for (const char* name : {"af5", "mill-table-table", "mill-head-table", "gantry-offset-head"}) {
        for (int round = 0; round < 30; ++round) {
            RunOf run(sample(name));
            AxisVector start = run.simulator.position();
            for (Eigen::Index i = 0; i < start.size(); ++i) start[i] += simulation::between(random, -50, 50);
            run.line(start);
            ArcMove move;
            move.plane = static_cast<simulation::Plane>(round % 3);
            const auto [first, second, normal] = kAxes[static_cast<std::size_t>(round % 3)];
            move.kind = random() % 2 == 0 ? MoveKind::arc_cw : MoveKind::arc_ccw;
            move.sweep_rad = simulation::between(random, 0.1, 12);
            move.center_first_mm = start[first] + simulation::between(random, -40, 40);
            move.center_second_mm = start[second] + simulation::between(random, 1, 40);
            move.target = start;
            move.target[normal] += simulation::between(random, -20, 20);
            move.target = on_arc(start, move, first, second, 1);
            move.feed.linear_mm_min = 1000;
            ASSERT_TRUE(run.simulator.move(move));
            const std::vector<Point> points = run.points();
            const Point& arc = points.back();
            ASSERT_TRUE(std::holds_alternative<CenterArc>(arc.arc)) << name;
            const path::ArcShape shape = path::arc_shape(points[points.size() - 2].position_mm, arc).value();
            for (const double share : {0.1, 0.5, 0.8, 1.0}) {
                const Vector3d tip = run.place.tip(on_arc(start, move, first, second, share));
                EXPECT_LT((shape.at(share) - tip).norm(), 1e-6) << name << " " << share;
            }
        }
    }
}

// Time goes evenly with the axes' way, so that the time of the lines tells where the tip would be.
TEST(PathRecorder, WhereTurningMovesTheTipALineBecomesLinesInItsTime) {
    RunOf run(sample("gantry-offset-head"));
    const AxisVector start = run.simulator.position();
    AxisVector target = start;
    target[0] += 100;
    target[1] += 30;
    target[target.size() - 1] += 40;
    target[target.size() - 2] += 70;
    run.line(target, 600);
    const std::vector<Point> points = run.points();
    ASSERT_GT(points.size(), 20U);
    EXPECT_EQ(points[0].position_mm, run.place.position(start));
    double whole_s = 0;
    for (std::size_t i = 1; i < points.size(); ++i) whole_s += points[i].duration_s.value();
    EXPECT_NEAR(whole_s, std::hypot(100, 30) / 10, 1e-6);
    double time_s = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double middle_s = time_s + *points[i].duration_s / 2;
        time_s += *points[i].duration_s;
        const Vector3d middle =
            (path::to_eigen(points[i - 1].position_mm) + path::to_eigen(points[i].position_mm)) / 2;
        EXPECT_LT((middle - run.place.tip(start + middle_s / whole_s * (target - start))).norm(), 0.0006);
    }
    EXPECT_EQ(points.back().position_mm, run.place.position(target));
}

// Paths allow 0.01 mm, controllers 0.05 mm.
TEST(PathRecorder, AnArcWithRadiiThatDifferIsSplitUntilPathsTakeIt) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}));
    ArcMove move;
    move.kind = MoveKind::arc_ccw;
    move.sweep_rad = std::numbers::pi;
    move.target = run.axes({-10.04, 0, 0, 0, 0});
    move.feed.linear_mm_min = 1000;
    ASSERT_TRUE(run.simulator.move(move));
    const std::vector<Point> points = run.points();
    EXPECT_EQ(points.size(), 6U);
    EXPECT_EQ(points.back().position_mm, (path::Vector{-10.04, 0, 0}));
    EXPECT_NEAR(points[3].position_mm[0], 10.024 * std::cos(0.6 * std::numbers::pi), 1e-8);
}

TEST(PathRecorder, ActionsAndDwellsStandWhereTheyHappened) {
    RunOf run(sample("af5"));
    run.simulator.event("spindle_cw", "", {});
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.simulator.event("jet_on", "", {});
    run.simulator.event("message", "pierced?", {});
    run.simulator.dwell(0.5, {});
    run.simulator.dwell(0.25, {});
    run.simulator.event("digital_output", "P3 on", {});
    run.line(run.axes({20, 0, 0, 0, 0}));
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 5U);
    EXPECT_THAT(points[0].actions, ElementsAre("spindle_cw"));
    EXPECT_THAT(points[1].actions, ElementsAre("waterjet_on"));
    EXPECT_EQ(points[1].dwell_s, 0) << "a dwell comes before the actions of its point";
    EXPECT_EQ(points[2].dwell_s, 0.5);
    EXPECT_EQ(points[3].dwell_s, 0.25);
    EXPECT_THAT(points[3].actions, ElementsAre("digital_output P3 on"));
    EXPECT_EQ(points[3].position_mm, (path::Vector{10, 0, 0}));
}

TEST(PathRecorder, FeedsAndOrientationsAreGivenWhereTheyChange) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}), 600);
    run.line(run.axes({20, 0, 0, 0, 0}), 600);
    run.line(run.axes({20, 0, 0, 30, 0}), 600);
    LineMove timed;
    timed.target = run.axes({50, 0, 0, 30, 0});
    timed.feed.motion_s = 2;
    run.simulator.move(timed);
    run.line(run.axes({60, 0, 0, 30, 0}), 900);
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 5U);
    EXPECT_EQ(points[0].feed_mm_min, 600);
    EXPECT_EQ(points[0].orientation, path::Orientation(path::RotaryAxes{{'B', 0}, {'C', 0}}));
    EXPECT_FALSE(points[1].feed_mm_min || points[1].orientation);
    EXPECT_EQ(points[2].feed_deg_min, 360) << "rotary axes alone";
    EXPECT_EQ(points[2].orientation, path::Orientation(path::RotaryAxes{{'B', 30}, {'C', 0}}));
    EXPECT_EQ(points[3].duration_s, 2);
    EXPECT_FALSE(points[3].feed_mm_min);
    EXPECT_EQ(points[4].feed_mm_min, 900);
}

TEST(PathRecorder, AMachineWithoutXYZGivesPoses) {
    RunOf run(machine::load_machine(GSIM_SAMPLES "/machines/arm6.toml").value());
    AxisVector target = run.simulator.position();
    target[0] += 20;
    target[3] += 10;
    run.line(target);
    const std::vector<Point> points = run.points();
    EXPECT_TRUE(std::holds_alternative<path::RollPitchYaw>(points.back().orientation.value()));
    EXPECT_LT(distance_mm(points.back().position_mm, run.place.tip(target)), 1e-8);
}

TEST(PathRecorder, CornersAreThoseOfTheProgramThoughAControllerRoundsThem) {
    machine::Machine machine = sample("af5");
    for (machine::Axis& axis : machine.axes) axis.max_acceleration = 500;
    machine.controller.planner = rrs::PlannerKind::linuxcnc;
    RunOf run(machine);
    run.simulator.set_path_mode(rrs::PathMode::continuous, 0.5, 0);
    run.line(run.axes({10, 0, 0, 0, 0}), 6000);
    run.line(run.axes({10, 10, 0, 0, 0}), 6000);
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].position_mm, (path::Vector{10, 0, 0}));
}

TEST(PathRecorder, MotionByServicesIsRefused) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.recorder.service_motion();
    EXPECT_THAT(run.recorder.finish("p").error(), testing::HasSubstr("SetNextTarget"));
}

TEST(PathRecorder, NothingMakesNoPath) {
    const machine::Machine machine = sample("af5");
    PathRecorder recorder(machine);
    EXPECT_THAT(recorder.finish("p").error(), testing::HasSubstr("neither moves nor switches"));
}

}  // namespace
}  // namespace gsim::record
