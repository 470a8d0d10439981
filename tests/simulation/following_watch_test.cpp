// Where axes and tip really are, against closed forms.
#include "runtime/simulation/following_watch.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "runtime/machine/controller_file.h"
#include "runtime/machine/machine_file.h"
#include "runtime/simulation/plot_data.h"
#include "runtime/simulation/plot_script.h"
#include "runtime/simulation/simulator.h"
#include "runtime/simulation/trajectory_writer.h"
#include "tests/simulation/random_program.h"
#include "tests/simulation/string_stream.h"
#include "tests/simulation/test_segments.h"

namespace gsim::simulation::following_watch_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kGain_1_s = 30;
constexpr double kSpeed_mm_s = 100;

// Nothing limits accelerations: speeds are constant on each line, and jump.
machine::Machine slides(double gain_x_1_s = kGain_1_s, double gain_y_1_s = kGain_1_s) {
    machine::Machine machine = machine::read_machine(R"([machine]
name = "m"
inverse = "gantry"
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
direction = "z"
)",
                                                     "m.toml")
                                   .value();
    machine.axes[0].servo = machine::Servo{.position_gain_1_s = gain_x_1_s};
    machine.axes[1].servo = machine::Servo{.position_gain_1_s = gain_y_1_s};
    machine.axes[2].servo = machine::Servo{.position_gain_1_s = kGain_1_s};
    return machine;
}

void feed(Simulator& simulator, double x, double y, std::uint32_t line, MoveKind kind = MoveKind::linear) {
    LineMove move{.kind = kind,
                  .target = simulator.position(),
                  .feed = {.linear_mm_min = kSpeed_mm_s * 60},
                  .place = {0, line}};
    move.target[0] = x;
    move.target[1] = y;
    ASSERT_TRUE(simulator.move(move));
}

FollowingReport following(Simulator& simulator) {
    simulator.add_file("part.nc");
    return simulator.finish("part.nc").following.value();
}

TEST(FollowingWatch, LineAtConstantSpeed) {
    machine::Machine machine = slides();
    machine.axes[0].servo->velocity_feed_forward = 0.4;
    Simulator simulator(machine, {});
    feed(simulator, 200, 0, 7);  // 2 s
    const FollowingReport report = following(simulator);
    const AxisFollowing& x = report.axes[0];
    const double steady_mm = 0.6 * kSpeed_mm_s / kGain_1_s;
    EXPECT_NEAR(x.peak, steady_mm, 1e-9);
    EXPECT_EQ(x.peak_place.line, 7U);
    EXPECT_NEAR(x.behind_s * kSpeed_mm_s, steady_mm, 1e-12);
    EXPECT_NEAR(x.end, steady_mm, 1e-9);
    // The square of steady (1 - exp(-K t)) over 2 s.
    const double squares = steady_mm * steady_mm * (2 - 2 / kGain_1_s + 1 / (2 * kGain_1_s));
    EXPECT_NEAR(x.rms, std::sqrt(squares / 2), 1e-9);
    EXPECT_EQ(report.axes[1].peak, 0);
    EXPECT_NEAR(report.feed.error_mm, 0, 1e-9);  // it is late, and nowhere beside the line
    // It dies away from there to the band of 0.01 mm.
    EXPECT_NEAR(report.in_position_s.value(), std::log(steady_mm / 0.01) / kGain_1_s, 1e-6);
}

TEST(FollowingWatch, BackwardsTheErrorIsBelowZero) {
    Simulator simulator(slides(), {});
    feed(simulator, -200, 0, 7);
    EXPECT_NEAR(following(simulator).axes[0].peak, -kSpeed_mm_s / kGain_1_s, 1e-9);
}

TEST(FollowingWatch, FullFeedForwardFollows) {
    machine::Machine machine = slides();
    for (machine::Axis& axis : machine.axes) axis.servo->velocity_feed_forward = 1;
    Simulator simulator(machine, {});
    feed(simulator, 50, 20, 1);
    feed(simulator, 0, 60, 2);
    const FollowingReport report = following(simulator);
    for (const AxisFollowing& axis : report.axes) EXPECT_NEAR(axis.peak, 0, 1e-9);
    EXPECT_NEAR(report.feed.error_mm, 0, 1e-9);
    EXPECT_EQ(report.in_position_s, 0);
}

// x is late by v/Kx, y by v/Ky: the tip goes beside the line by half of their difference.
TEST(FollowingWatch, UnequalGainsOnALineOf45Degrees) {
    Simulator simulator(slides(40, 25), {});
    feed(simulator, 300, 300, 3);
    const FollowingReport report = following(simulator);
    const double each_mm_s = kSpeed_mm_s / std::numbers::sqrt2;
    EXPECT_NEAR(report.axes[0].peak, each_mm_s / 40, 1e-9);
    EXPECT_NEAR(report.axes[1].peak, each_mm_s / 25, 1e-9);
    EXPECT_NEAR(report.feed.error_mm, kSpeed_mm_s / 2 * (1.0 / 25 - 1.0 / 40), 1e-9);
    EXPECT_EQ(report.feed.place.line, 3U);
}

TEST(FollowingWatch, DelayOfOneAxisIsAContourErrorOfAllIsNone) {
    for (const bool of_all : {false, true}) {
        machine::Machine machine = slides();
        machine.axes[0].servo->command_delay_s = 0.004;
        if (of_all) machine.axes[1].servo->command_delay_s = 0.004;
        Simulator simulator(machine, {});
        feed(simulator, 300, 300, 3);
        const FollowingReport report = following(simulator);
        const double each_mm_s = kSpeed_mm_s / std::numbers::sqrt2;
        EXPECT_NEAR(report.axes[0].peak, each_mm_s * (1 / kGain_1_s + 0.004), 1e-9);
        EXPECT_NEAR(report.feed.error_mm, of_all ? 0 : each_mm_s * 0.004 / std::numbers::sqrt2, 1e-9);
    }
}

// Behind a corner of 90 degrees x = -v/K exp(-K t) and y = v t - v/K (1 - exp(-K t)). The tip is as far from
// both lines at t = 1/K, and nowhere farther from the nearer one: by v / (K e).
TEST(FollowingWatch, CornerIsRoundedByTheLag) {
    Simulator simulator(slides(), {});
    feed(simulator, 200, 0, 1);
    feed(simulator, 200, 200, 2);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.feed.error_mm, kSpeed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_NEAR(report.feed.t_s, 2 + 1 / kGain_1_s, 1e-8);
    EXPECT_EQ(report.feed.place.line, 2U);
    EXPECT_EQ(report.rapid.error_mm, 0);
    EXPECT_EQ(report.program->error_mm, report.feed.error_mm);  // it drives what is programmed
}

// A parabola in a corner of 90 degrees passes it at D, and is D / sqrt(2) from either line there. Who follows
// it exactly is on the way of the set points, and as far from that of the program.
TEST(FollowingWatch, CornerThatTheControllerRoundsIsPartOfTheWayFromTheProgramAlone) {
    machine::Machine machine = slides();
    machine.controller = machine::built_in_controller("blend").value();
    machine.controller.position_gain_1_s = 0;
    for (machine::Axis& axis : machine.axes) {
        axis.servo->velocity_feed_forward = 1;
        axis.max_acceleration = 1000;
        axis.max_speed = 500;
    }
    Simulator simulator(machine, {});
    simulator.set_path_mode(rrs::PathMode::continuous, 0.2, 0);
    feed(simulator, 50, 0, 1);
    feed(simulator, 50, 50, 2);
    simulator.add_file("part.nc");
    const Report report = simulator.finish("part.nc");
    ASSERT_GT(report.blends.feed.deviation_mm, 0.05);
    EXPECT_NEAR(report.following->feed.error_mm, 0, 1e-6);
    EXPECT_NEAR(report.following->program->error_mm, report.blends.feed.deviation_mm / std::numbers::sqrt2,
                1e-6);
}

// Corners of rapid moves count by themselves.
TEST(FollowingWatch, RapidMovesAreToldApart) {
    machine::Machine machine = slides();
    for (machine::Axis& axis : machine.axes) axis.max_speed = 3 * kSpeed_mm_s;
    Simulator simulator(machine, {});
    feed(simulator, 300, 0, 1, MoveKind::rapid);
    feed(simulator, 300, 300, 2, MoveKind::rapid);
    simulator.dwell(2, {0, 3});
    feed(simulator, 100, 300, 4);
    feed(simulator, 100, 100, 5);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.rapid.error_mm, 3 * kSpeed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_EQ(report.rapid.place.line, 2U);
    EXPECT_NEAR(report.feed.error_mm, kSpeed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_EQ(report.feed.place.line, 5U);
}

/// Rows of a trajectory.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    for (std::size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1) {
        rows.emplace_back();
        std::string line = csv.substr(at, csv.find('\n', at) - at);
        for (std::size_t from = 0; from <= line.size();) {
            const std::size_t to = std::min(line.find(',', from), line.size());
            rows.back().push_back(std::stod(line.substr(from, to - from)));
            from = to + 1;
        }
    }
    return rows;
}

// A circle comes out smaller by sqrt(1 + (w/K)^2). On the way in the tip is nowhere farther off.
TEST(FollowingWatch, CircleShrinks) {
    constexpr double kRadius_mm = 25;
    Simulator simulator(slides(), {});
    StringStream stream;
    TrajectoryWriter writer(stream.out(), simulator.machine(), 0.05, 1e9);
    writer.add_following(simulator.following_setup().value());
    simulator.add_output(writer);
    ArcMove move = circle_at(simulator, kRadius_mm, kSpeed_mm_s * 60);
    move.place = {0, 4};
    ASSERT_TRUE(simulator.move(move));
    const FollowingReport report = following(simulator);
    const double w = kSpeed_mm_s / kRadius_mm / kGain_1_s;
    const double shrunk_mm = kRadius_mm - kRadius_mm / std::sqrt(1 + w * w);
    const std::string csv = stream.text();
    EXPECT_EQ(
        csv.substr(0, csv.find('\n')),
        "t_s,line,x_mm,y_mm,z_mm,speed_mm_s,x_error_mm,y_error_mm,z_error_mm,tip_x_mm,tip_y_mm,tip_z_mm,"
        "contour_mm");
    int late = 0;
    for (const std::vector<double>& row : rows_of(csv)) {
        EXPECT_NEAR(row[9], row[2] - row[6], 1e-8);
        EXPECT_NEAR(row[10], row[3] - row[7], 1e-8);
        if (row[0] < 0.8) continue;  // exp(-24) of how it began
        ++late;
        EXPECT_NEAR(std::hypot(row[9] - kRadius_mm, row[10]), kRadius_mm - shrunk_mm, 1e-7);
        EXPECT_NEAR(row[12], shrunk_mm, 1e-7) << row[0];
    }
    EXPECT_GT(late, 10);
    EXPECT_GE(report.feed.error_mm, shrunk_mm - 1e-9);
}

// A move of thousands of turns takes no longer than its steps, and a very slow one as few as any.
TEST(FollowingWatch, EndlessTurnsAndVerySlowMovesEnd) {
    machine::Machine machine = slides();
    machine.controller = machine::built_in_controller("blend").value();
    Simulator simulator(machine, {});
    ArcMove move = circle_at(simulator, 25, kSpeed_mm_s * 60);
    move.sweep_rad *= 2000;
    ASSERT_TRUE(simulator.move(move));
    move.sweep_rad /= 2000;
    move.feed.linear_mm_min = 0.1;
    ASSERT_TRUE(simulator.move(move));
    simulator.dwell(1e6, {0, 3});
    const FollowingReport report = following(simulator);
    const double w = kSpeed_mm_s / 25 / kGain_1_s;
    EXPECT_GE(report.feed.error_mm, 25 - 25 / std::sqrt(1 + w * w) - 1e-4);
    EXPECT_NEAR(report.axes[0].end, 0, 1e-9);
}

// The gain of the controller is that of axes which tell none.
TEST(FollowingWatch, GainOfTheControllerIsThatOfTheAxesWithoutOne) {
    machine::Machine machine = slides();
    machine.axes[0].servo = machine::Servo{};
    machine.axes[1].servo.reset();
    machine.controller.position_gain_1_s = 20;
    Simulator simulator(machine, {});
    feed(simulator, 300, 400, 1);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.axes[0].peak, 0.6 * kSpeed_mm_s / 20, 1e-9);
    EXPECT_NEAR(report.axes[1].peak, 0.8 * kSpeed_mm_s / 20, 1e-9);
    EXPECT_EQ(report.axes[2].gain_1_s, kGain_1_s);
}

TEST(FollowingWatch, MachineWithoutServosTellsNothing) {
    machine::Machine machine = slides();
    for (machine::Axis& axis : machine.axes) axis.servo.reset();
    machine.controller.position_gain_1_s = 20;  // for exact stops alone
    Simulator simulator(machine, {});
    feed(simulator, 10, 0, 1);
    const Report report = simulator.finish("part.nc");
    EXPECT_FALSE(report.following);
    EXPECT_FALSE(simulator.following_setup());
    EXPECT_THAT(to_json(report), Not(HasSubstr("following")));
    EXPECT_THAT(to_text(report), Not(HasSubstr("following")));
}

TEST(FollowingWatch, ReportTellsOfIt) {
    Simulator simulator(slides(), {});
    simulator.add_file("part.nc");
    feed(simulator, 200, 0, 1);
    feed(simulator, 200, 200, 2);
    const Report report = simulator.finish("part.nc");
    EXPECT_THAT(to_json(report), HasSubstr(R"("contour": {
      "error_mm": 1.226)"));
    const std::string text = to_text(report);
    EXPECT_THAT(text, HasSubstr("following             peak         rms   behind (ms)   peak at\n"
                                "X mm                3.3333      2.3373        33.333   part.nc:1\n"));
    EXPECT_THAT(text, HasSubstr("contour     1.2263 mm at part.nc:2\n"
                                "            1.2263 mm at part.nc:2, from the programmed way\n"
                                "in position 0.1936 s behind the end\n"));
}

TEST(FollowingWatch, PlotShowsIt) {
    Simulator simulator(slides(), {});
    PlotData data(simulator.machine());
    data.add_following(simulator.following_setup().value());
    simulator.add_output(data);
    feed(simulator, 200, 0, 1);
    simulator.finish("part.nc");
    const std::string script = plot_script(data, PictureFormat::svg, "part.nc");
    EXPECT_THAT(script, HasSubstr("set ylabel 'following error (mm)' noenhanced"));
    EXPECT_THAT(script, HasSubstr("$following_X << EOD"));
    EXPECT_THAT(script, HasSubstr("title 'contour error of the tip'"));
    EXPECT_NEAR(data.following(0).back().value, kSpeed_mm_s / kGain_1_s, 1e-9);
}

/// The gantry with a turning head, with loops of all kinds.
machine::Machine random_servos(std::mt19937& random, std::size_t program) {
    constexpr std::array kModels{"exact-stop", "ab9", "blend", "linuxcnc-2.9", "grbl-1.1"};
    machine::Machine machine = random_machine(random, af5());
    machine.controller = machine::built_in_controller(kModels[program % kModels.size()]).value();
    for (machine::Axis& axis : machine.axes) {
        axis.servo = machine::Servo{.position_gain_1_s = around(random, 30, 0.4),
                                    .velocity_feed_forward = between(random, 0, 1),
                                    .acceleration_feed_forward = between(random, 0, 1),
                                    .velocity_lag_s = random() % 3 == 0 ? 0 : around(random, 0.004, 0.6),
                                    .command_delay_s = random() % 2 == 0 ? 0 : between(random, 0, 0.01)};
    }
    return machine;
}

/// Steps in half the time change nothing that matters: of no axis, nor of the tip.
TEST(FollowingWatch, HalfTheStepChangesNothing) {
    constexpr std::size_t kPrograms = 10;
    double greatest = 0;
    for (std::size_t program = 0; program < kPrograms; ++program) {
        std::mt19937 random(static_cast<unsigned>(program));
        const machine::Machine machine = random_servos(random, program);
        Simulator simulator(machine, {});
        FollowingWatch half(simulator.following_setup().value(), dynamics::ServoMotion::kStep_s / 2);
        simulator.add_output(half);
        RandomMoves(random, simulator).make(12);
        const Report report = simulator.finish("random");
        const FollowingReport& whole = report.following.value();
        for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
            // Where it is as much to both sides the step may decide which of them counts.
            EXPECT_NEAR(std::abs(whole.axes[axis].peak), std::abs(half.report().axes[axis].peak), 1e-6)
                << program;
            EXPECT_NEAR(whole.axes[axis].rms, half.report().axes[axis].rms, 1e-6) << program;
            EXPECT_NEAR(whole.axes[axis].end, half.report().axes[axis].end, 1e-6) << program;
        }
        EXPECT_NEAR(whole.feed.error_mm, half.report().feed.error_mm, 1e-6) << program;
        EXPECT_NEAR(whole.rapid.error_mm, half.report().rapid.error_mm, 1e-6) << program;
        greatest = std::max(greatest, whole.feed.error_mm);
    }
    EXPECT_GT(greatest, 0.1);
}

// From the program the tip is no farther than from the way of the set points, and this way from the program.
TEST(FollowingWatch, FromTheProgramItIsNoFartherThanBothTogether) {
    constexpr std::array kModels{"blend", "linuxcnc-2.9"};
    double rounded = 0;
    for (std::size_t program = 0; program < 16; ++program) {
        std::mt19937 random(static_cast<unsigned>(program));
        machine::Machine machine = random_servos(random, program);
        machine.controller = machine::built_in_controller(kModels[program % 2]).value();
        Simulator simulator(machine, {});
        simulator.set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        for (std::uint32_t line = 1; line < 30; ++line)
            feed(simulator, between(random, -20, 20), between(random, -20, 20), line);
        const Report report = simulator.finish("random");
        const double both_mm = report.following->feed.error_mm + report.blends.feed.deviation_mm;
        EXPECT_LE(report.following->program->error_mm, both_mm + 1e-6) << program;
        EXPECT_GE(report.following->program->error_mm, report.blends.feed.deviation_mm / 4) << program;
        rounded = std::max(rounded, report.blends.feed.deviation_mm);
    }
    EXPECT_GT(rounded, 0.1);
}

/// A loop of one joint as it is told, by Runge's and Kutta's rule in fine steps along the run.
struct Witness : RunOutput {
    static constexpr double kStep_s = 1e-4;
    using State = std::array<double, 2>;  // place, speed

    Witness(const machine::Servo& of, int of_joint) : servo(of), joint(of_joint) {}

    void begin(const rrs::JointPos& start) override { at = {start[joint], 0}; }
    void take(const motion::Segment& segment, const MoveInfo&) override {
        const int steps = static_cast<int>(std::ceil(segment.duration_s / kStep_s));
        const double h = segment.duration_s / steps;
        for (int i = 0; i < steps; ++i) {
            const double inside = 1e-6 * h;
            go(h, segment.at(i * h + inside), segment.at((i + 0.5) * h), segment.at((i + 1) * h - inside));
        }
    }
    State slope(const motion::JointState& set, const State& of) const {
        const double command =
            servo.position_gain_1_s * (set.position[joint] - of[0]) +
            servo.velocity_feed_forward * set.velocity[joint] +
            servo.acceleration_feed_forward * servo.velocity_lag_s * set.acceleration[joint];
        if (servo.velocity_lag_s <= 0) return {command, 0};
        return {of[1], (command - of[1]) / servo.velocity_lag_s};
    }
    void go(double h, const motion::JointState& from, const motion::JointState& middle,
            const motion::JointState& to) {
        at[1] += servo.acceleration_feed_forward * (from.velocity[joint] - set_speed);  // where it jumps
        set_speed = to.velocity[joint];
        const auto moved = [this](const State& by, double share) {
            return State{at[0] + share * by[0], at[1] + share * by[1]};
        };
        const State a = slope(from, at), b = slope(middle, moved(a, h / 2));
        const State c = slope(middle, moved(b, h / 2)), d = slope(to, moved(c, h));
        for (std::size_t i = 0; i < at.size(); ++i) at[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        error = to.position[joint] - at[0];
    }

    machine::Servo servo;
    int joint;
    State at{};
    double set_speed = 0, error = 0;
};

TEST(FollowingWatch, RandomProgramsAgainstFineSteps) {
    constexpr std::size_t kWitnessed = 10;
    for (std::size_t program = 0; program < kWitnessed; ++program) {
        std::mt19937 random(static_cast<unsigned>(100 + program));
        machine::Machine machine = random_servos(random, program);
        for (machine::Axis& axis : machine.axes) axis.servo->command_delay_s = 0;
        Simulator simulator(machine, {});
        Witness x(*machine.axes[0].servo, 0), c(*machine.axes[4].servo, 4);
        simulator.add_output(x);
        simulator.add_output(c);
        RandomMoves(random, simulator).make(12);
        const FollowingReport report = simulator.finish("random").following.value();
        constexpr double kDegPerRad = 180 / std::numbers::pi;
        EXPECT_NEAR(report.axes[0].end, x.error, 5e-5 * (1 + std::abs(report.axes[0].peak))) << program;
        EXPECT_NEAR(report.axes[4].end, c.error * kDegPerRad, 5e-5 * (1 + std::abs(report.axes[4].peak)))
            << program;
    }
}

}  // namespace
}  // namespace gsim::simulation::following_watch_test
