// Recording of a run, compared with the moves that the machine made.
#include "runtime/record/path_recorder.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "runtime/outputs/run_output.h"
#include "runtime/simulator/simulator.h"
#include "tests/build_files/build_files.h"
#include "tests/runtime/simulator/random_program.h"
#include "toolpath/model/arc_shape.h"

namespace gsim::record::path_recorder_test {
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
        machine::load_machine(tests::source_path("samples/machines/") + name + ".toml").value();
    machine.controller = {};  // no blending: moves end at their targets
    return simulation::unlimited(std::move(machine));
}

class MovesMade : public simulation::RunOutput {
  public:
    void on_move(const RecordedMove& move) override { moves.push_back(move); }
    std::vector<RecordedMove> moves;
};

struct RunOf {
    explicit RunOf(const machine::Machine& machine)
        : simulator(machine, {}), recorder(simulator.machine()), location(simulator.machine()) {
        simulator.add_output(recorded_moves);
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
        ASSERT_TRUE(simulator.moves().enqueue(move)) << simulator.outcome().alarm()->message;
    }

    Simulator simulator;
    MovesMade recorded_moves;
    PathRecorder recorder;
    ToolPosition location;
};

double length_mm(const path::Vector& from, const Point& to) {
    if (to.motion != MotionType::circular)
        return (path::to_eigen(to.position_mm) - path::to_eigen(from)).norm();
    const path::ArcShape arc = path::arc_shape(from, to).value();
    return std::hypot(arc.radius_mm() * arc.turn_rad, arc.rise_mm);
}

AxisVector solve_axes(const machine::Machine& machine, const rrs::JointPos& joints) {
    AxisVector axes(joints.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i) {
        axes[i] = machine::axis_value(machine.axes[static_cast<std::size_t>(i)], joints[i]);
    }
    return axes;
}

double distance_mm(const path::Vector& a, const Vector3d& b) {
    return (path::to_eigen(a) - b).norm();
}

TEST(PathRecorder, RandomMovesKeepEndsAndLengths) {
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
        double made_mm = 0;
        auto point = points.begin();
        for (const RecordedMove& move : run.recorded_moves.moves) {
            made_mm += move.length_mm;
            const Vector3d end = run.location.tcp(solve_axes(run.simulator.machine(), move.end));
            point = std::find_if(point, points.end(), [&](const Point& each) {
                return distance_mm(each.position_mm, end) < 1e-8;
            });
            ASSERT_NE(point, points.end());
        }
        EXPECT_NEAR(recorded_mm, made_mm, 1e-6 * made_mm);
    }
}

// The point of the helix after a share of an arc, by the definition of ArcMove: Rodrigues' formula.
AxisVector is_on_arc(const AxisVector& start, const ArcMove& move, double rise_mm, double share) {
    const double angle = (move.kind == MoveKind::arc_ccw ? 1 : -1) * share * move.sweep_rad;
    const Vector3d from = start.head<3>() - move.center_mm;
    const Vector3d turned = std::cos(angle) * from + std::sin(angle) * move.normal.cross(from) +
                            (1 - std::cos(angle)) * move.normal.dot(from) * move.normal;
    AxisVector axes = start;
    axes.head<3>() = move.center_mm + turned + share * rise_mm * move.normal;
    return axes;
}

Vector3d random_normal(std::mt19937& random) {
    switch (random() % 4) {
        case 0: return simulation::plane_normal(static_cast<Plane>(random() % 3));
        default: return simulation::canonical_normal(simulation::random_direction(random));
    }
}

// If the work is turned, arcs of the axes have any position in the work frame.
TEST(PathRecorder, ArcsAreExactAtAnyRotaryPosition) {
    std::mt19937 random(11);
    for (const char* name : {"af5", "mill-table-table", "mill-head-table", "gantry-offset-head"}) {
        for (int round = 0; round < 30; ++round) {
            RunOf run(sample(name));
            AxisVector start = run.simulator.position().axes();
            for (Eigen::Index i = 0; i < start.size(); ++i) start[i] += simulation::between(random, -50, 50);
            run.line(start);
            ArcMove move;
            move.normal = random_normal(random);
            move.kind = random() % 2 == 0 ? MoveKind::arc_cw : MoveKind::arc_ccw;
            move.sweep_rad = simulation::between(random, 0.1, 12);
            const double radius_mm = simulation::between(random, 1, 40);
            const Vector3d lateral = simulation::random_direction(random).cross(move.normal).normalized();
            move.center_mm = start.head<3>() + radius_mm * lateral;
            move.center_mm += simulation::between(random, -40, 40) * move.normal;
            const double rise_mm = simulation::between(random, -20, 20);
            move.target = is_on_arc(start, move, rise_mm, 1);
            move.feed.linear_mm_min = 1000;
            ASSERT_TRUE(run.simulator.moves().enqueue(move));
            const std::vector<Point> points = run.points();
            const Point& arc = points.back();
            ASSERT_TRUE(std::holds_alternative<CenterArc>(arc.arc)) << name;
            const path::ArcShape shape = path::arc_shape(points[points.size() - 2].position_mm, arc).value();
            for (const double share : {0.1, 0.5, 0.8, 1.0}) {
                const Vector3d tcp = run.location.tcp(is_on_arc(start, move, rise_mm, share));
                EXPECT_LT((shape.at(share) - tcp).norm(), 1e-6) << name << " " << share;
            }
        }
    }
}

// Time is proportional to the axes' path, so that the time of the lines gives the position of the TCP.
TEST(PathRecorder, SplitsLineInEqualTimeIfRotationMovesTcp) {
    RunOf run(sample("gantry-offset-head"));
    const AxisVector start = run.simulator.position().axes();
    AxisVector target = start;
    target[0] += 100;
    target[1] += 30;
    target[target.size() - 1] += 40;
    target[target.size() - 2] += 70;
    run.line(target, 600);
    const std::vector<Point> points = run.points();
    ASSERT_GT(points.size(), 20U);
    EXPECT_EQ(points[0].position_mm, run.location.position(start));
    EXPECT_EQ(points[0].motion, MotionType::none);
    std::vector<double> lasts_s{0};
    double feed_mm_min = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_FALSE(points[i].duration_s) << "that is inverse time feed";
        feed_mm_min = points[i].feed_mm_min.value_or(feed_mm_min);
        lasts_s.push_back(length_mm(points[i - 1].position_mm, points[i]) / feed_mm_min * 60);
    }
    const double total_s = std::accumulate(lasts_s.begin(), lasts_s.end(), 0.0);
    EXPECT_NEAR(total_s, std::hypot(100, 30) / 10, 1e-6);
    double time_s = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double middle_s = time_s + lasts_s[i] / 2;
        time_s += lasts_s[i];
        const Vector3d middle =
            (path::to_eigen(points[i - 1].position_mm) + path::to_eigen(points[i].position_mm)) / 2;
        EXPECT_LT((middle - run.location.tcp(start + middle_s / total_s * (target - start))).norm(), 0.0006);
    }
    EXPECT_EQ(points.back().position_mm, run.location.position(target));
}

// Paths allow 0.01 mm, controllers 0.05 mm.
TEST(PathRecorder, SplitsArcWithDifferentRadii) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}));
    ArcMove move;
    move.kind = MoveKind::arc_ccw;
    move.sweep_rad = std::numbers::pi;
    move.target = run.axes({-10.04, 0, 0, 0, 0});
    move.feed.linear_mm_min = 1000;
    ASSERT_TRUE(run.simulator.moves().enqueue(move));
    const std::vector<Point> points = run.points();
    EXPECT_EQ(points.size(), 7U);
    EXPECT_EQ(points.back().position_mm, (path::Vector{-10.04, 0, 0}));
    EXPECT_NEAR(points[4].position_mm[0], 10.024 * std::cos(0.6 * std::numbers::pi), 1e-8);
}

TEST(PathRecorder, RecordsActionsAndDwellsAtTheirPoints) {
    RunOf run(sample("af5"));
    run.simulator.events().add("spindle_cw", "", {});
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.simulator.events().add("jet_on", "", {});
    run.simulator.events().add("message", "pierced?", {});
    run.simulator.dwells().enqueue(0.5, {});
    run.simulator.dwells().enqueue(0.25, {});
    run.simulator.events().add("digital_output", "P3 on", {});
    run.line(run.axes({20, 0, 0, 0, 0}));
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 5U);
    EXPECT_EQ(points[0].motion, MotionType::none) << "the machine stands there";
    EXPECT_THAT(points[0].actions, ElementsAre("spindle_cw"));
    EXPECT_THAT(points[1].actions, ElementsAre("waterjet_on", "message pierced?"));
    EXPECT_EQ(points[1].dwell_s, 0) << "a dwell comes before the actions of its point";
    EXPECT_EQ(points[2].dwell_s, 0.5);
    EXPECT_EQ(points[3].dwell_s, 0.25);
    EXPECT_THAT(points[3].actions, ElementsAre("digital_output P3 on"));
    EXPECT_EQ(points[3].motion, MotionType::none);
    EXPECT_EQ(points[3].position_mm, (path::Vector{10, 0, 0}));
}

TEST(PathRecorder, RecordsFeedAndOrientationOnlyOnChange) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}), 600);
    run.line(run.axes({20, 0, 0, 0, 0}), 600);
    run.line(run.axes({20, 0, 0, 30, 0}), 600);
    LineMove timed;
    timed.target = run.axes({50, 0, 0, 30, 0});
    timed.feed.motion_s = 2;
    run.simulator.moves().enqueue(timed);
    run.line(run.axes({60, 0, 0, 30, 0}), 900);
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 6U);
    EXPECT_EQ(points[1].feed_mm_min, 600);
    EXPECT_EQ(points[0].orientation, path::Orientation(path::RotaryAxes{{'B', 0}, {'C', 0}}));
    EXPECT_FALSE(points[1].orientation || points[2].feed_mm_min || points[2].orientation);
    EXPECT_EQ(points[3].feed_deg_min, 360) << "rotary axes alone";
    EXPECT_EQ(points[3].orientation, path::Orientation(path::RotaryAxes{{'B', 30}, {'C', 0}}));
    EXPECT_EQ(points[4].duration_s, 2);
    EXPECT_FALSE(points[4].feed_mm_min);
    EXPECT_EQ(points[5].feed_mm_min, 900);
}

TEST(PathRecorder, RecordsSelectionsInOrder) {
    RunOf run(sample("af5"));
    run.simulator.program().work_offsets().select({"55", {{'X', 10}, {'Z', -3}}, 0});
    run.simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0, 0);  // as programs begin
    run.simulator.program().settings().set_spindle_speed(1200.5);
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0.05, 0.01);
    run.simulator.program().settings().exact_stop_once();
    run.line(run.axes({20, 0, 0, 0, 0}));
    run.simulator.program().ramps().set_mode(rrs::RampMode::s_curve);
    run.simulator.program().ramps().set_limit(rrs::RampLimit::jerk, 1, 5000);
    run.simulator.program().ramps().set_limit(rrs::RampLimit::acceleration, 3, 90);
    run.simulator.program().ramps().reset_limits();
    run.simulator.program().work_offsets().select({"54", {}, 0});
    run.line(run.axes({30, 0, 0, 0, 0}));
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 4U);
    EXPECT_THAT(points[0].actions, ElementsAre("speed 1200.5"));
    EXPECT_EQ(points[0].work_offset, "55");
    EXPECT_THAT(points[1].actions, ElementsAre("path_mode continuous 0.05 0.01", "exact_stop_once"));
    EXPECT_THAT(points[2].actions, ElementsAre("ramps s_curve", "ramp_limit jerk Y 5000 mm",
                                               "ramp_limit acceleration B 90 deg", "ramp_limits machine"));
    EXPECT_EQ(points[3].work_offset, "54");
}

// A change of offsets is no event; a dwell or a switch stops the machine anyway.
TEST(PathRecorder, RecordsStandstillOnlyIfNothingElseStops) {
    RunOf run(sample("af5"));
    run.simulator.clock().wait();
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.simulator.clock().wait();
    run.simulator.clock().wait();
    run.line(run.axes({20, 0, 0, 0, 0}));
    run.simulator.clock().wait();
    run.simulator.events().add("jet_on", "", {});
    run.simulator.clock().wait();
    run.line(run.axes({30, 0, 0, 0, 0}));
    run.simulator.events().add("message", "hello", {}, simulation::EventTiming::in_passing);
    run.simulator.clock().wait();
    run.line(run.axes({40, 0, 0, 0, 0}));
    const std::vector<Point> points = run.points();
    EXPECT_THAT(points[0].actions, ElementsAre());
    EXPECT_THAT(points[1].actions, ElementsAre("rest"));
    EXPECT_THAT(points[2].actions, ElementsAre("waterjet_on"));
    EXPECT_THAT(points[3].actions, ElementsAre("message hello", "rest"));
}

// A controller that takes time for each wait takes it again after a dwell, and at the end of the program.
TEST(PathRecorder, RecordsStandstillAfterDwellAndAtEnd) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.simulator.clock().wait();
    run.simulator.dwells().enqueue(0.5, {});
    run.simulator.clock().wait();
    run.simulator.events().add("message", "hello", {}, simulation::EventTiming::in_passing);
    run.line(run.axes({20, 0, 0, 0, 0}));
    run.simulator.clock().wait();
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 3U);
    EXPECT_EQ(points[1].dwell_s, 0.5);
    EXPECT_THAT(points[1].actions, ElementsAre("rest", "message hello"));
    EXPECT_THAT(points[2].actions, ElementsAre("rest"));
}

TEST(PathRecorder, KeepsFeedsAndLeadsPerRevolution) {
    RunOf run(sample("af5"));
    LineMove move;
    move.target = run.axes({10, 0, 0, 0, 0});
    move.feed = {.linear_mm_min = 600, .rotary_deg_min = 600, .linear_mm_rev = 0.5};
    run.simulator.moves().enqueue(move);
    move.kind = MoveKind::thread;
    move.target = run.axes({20, 0, 0, 0, 0});
    move.feed.linear_mm_rev = 2;
    run.simulator.moves().enqueue(move);
    const std::vector<Point> points = run.points();
    EXPECT_EQ(points[1].feed_mm_rev, 0.5);
    EXPECT_EQ(points[2].lead_mm, 2);
    EXPECT_FALSE(points[2].feed_mm_rev);
}

TEST(PathRecorder, RejectsTcpControl) {
    RunOf run(sample("mill-head-table"));
    run.simulator.tcp_control().set(Eigen::Vector3d(0, 0, 50), {});
    EXPECT_EQ(run.recorder.finish("p").error().message, "TCP control (G43.4) moves the TCP, not the axes");
}

TEST(PathRecorder, RecordsPosesForMachineWithoutXyz) {
    RunOf run(machine::load_machine(tests::source_path("samples/machines/arm6.toml")).value());
    AxisVector target = run.simulator.position().axes();
    target[0] += 20;
    target[3] += 10;
    run.line(target);
    const std::vector<Point> points = run.points();
    EXPECT_TRUE(std::holds_alternative<path::RollPitchYaw>(points.back().orientation.value()));
    EXPECT_LT(distance_mm(points.back().position_mm, run.location.tcp(target)), 1e-8);
}

TEST(PathRecorder, KeepsProgrammedCornersIfControllerRoundsThem) {
    machine::Machine machine = sample("af5");
    for (machine::Axis& axis : machine.axes) axis.max_acceleration = 500;
    machine.controller.planner = rrs::PlannerKind::linuxcnc;
    RunOf run(machine);
    run.simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
    run.line(run.axes({10, 0, 0, 0, 0}), 6000);
    run.line(run.axes({10, 10, 0, 0, 0}), 6000);
    const std::vector<Point> points = run.points();
    ASSERT_EQ(points.size(), 3U);
    EXPECT_EQ(points[1].position_mm, (path::Vector{10, 0, 0}));
}

TEST(PathRecorder, RejectsMotionByServices) {
    RunOf run(sample("af5"));
    run.line(run.axes({10, 0, 0, 0, 0}));
    run.recorder.on_unrecordable_motion("the script moves by services (SetNextTarget)");
    EXPECT_THAT(run.recorder.finish("p").error().message, testing::HasSubstr("SetNextTarget"));
}

TEST(PathRecorder, RejectsEmptyRun) {
    const machine::Machine machine = sample("af5");
    PathRecorder recorder(machine);
    EXPECT_THAT(recorder.finish("p").error().message, testing::HasSubstr("neither moves nor switches"));
}

}  // namespace
}  // namespace gsim::record::path_recorder_test
