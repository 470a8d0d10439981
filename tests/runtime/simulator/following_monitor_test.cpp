// True positions of axes and TCP, against closed forms.
#include "runtime/monitors/following_monitor.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "runtime/outputs/plot_data.h"
#include "runtime/outputs/plot_script.h"
#include "runtime/outputs/trajectory_writer.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/fed_lines.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/string_stream.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::following_watch_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kGain_1_s = 30;

// Returns a machine without limits on accelerations: speeds are constant on each line, and jump.
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

FollowingReport following(Simulator& simulator) {
    simulator.program().files().add("part.nc");
    return simulator.finish("part.nc").drives.following.value();
}

TEST(FollowingErrorMonitor, LineMatchesClosedForm) {
    machine::Machine machine = slides();
    machine.axes[0].servo->velocity_feed_forward = 0.4;
    Simulator simulator(machine, {});
    feed(simulator, 200, 0, 7);  // 2 s
    const FollowingReport report = following(simulator);
    const AxisFollowing& x = report.axes[0];
    const double steady_mm = 0.6 * kFed_mm_s / kGain_1_s;
    EXPECT_NEAR(x.peak, steady_mm, 1e-9);
    EXPECT_EQ(x.peak_location.line, 7U);
    EXPECT_NEAR(x.constant_speed_lag_s * kFed_mm_s, steady_mm, 1e-12);
    EXPECT_NEAR(x.end, steady_mm, 1e-9);
    // The square of steady (1 - exp(-K t)) over 2 s.
    const double squares = steady_mm * steady_mm * (2 - 2 / kGain_1_s + 1 / (2 * kGain_1_s));
    EXPECT_NEAR(x.rms, std::sqrt(squares / 2), 1e-9);
    EXPECT_EQ(report.axes[1].peak, 0);
    EXPECT_NEAR(report.feed.error_mm, 0, 1e-9);  // it is late, and nowhere off the line
    // It dies away from there to the band of 0.01 mm.
    EXPECT_NEAR(report.in_position_s.value(), std::log(steady_mm / 0.01) / kGain_1_s, 1e-6);
}

TEST(FollowingErrorMonitor, BackwardMoveHasNegativeError) {
    Simulator simulator(slides(), {});
    feed(simulator, -200, 0, 7);
    EXPECT_NEAR(following(simulator).axes[0].peak, -kFed_mm_s / kGain_1_s, 1e-9);
}

TEST(FollowingErrorMonitor, FullFeedForwardHasNoError) {
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

// x is late by v/Kx, y by v/Ky: the TCP runs off the line by half of their difference.
TEST(FollowingErrorMonitor, UnequalGainsGiveContourErrorOnDiagonal) {
    Simulator simulator(slides(40, 25), {});
    feed(simulator, 300, 300, 3);
    const FollowingReport report = following(simulator);
    const double each_mm_s = kFed_mm_s / std::numbers::sqrt2;
    EXPECT_NEAR(report.axes[0].peak, each_mm_s / 40, 1e-9);
    EXPECT_NEAR(report.axes[1].peak, each_mm_s / 25, 1e-9);
    EXPECT_NEAR(report.feed.error_mm, kFed_mm_s / 2 * (1.0 / 25 - 1.0 / 40), 1e-9);
    EXPECT_EQ(report.feed.location.line, 3U);
}

TEST(FollowingErrorMonitor, DelayOfOneAxisGivesContourErrorAndOfAllNone) {
    for (const bool of_all : {false, true}) {
        machine::Machine machine = slides();
        machine.axes[0].servo->command_delay_s = 0.004;
        if (of_all) machine.axes[1].servo->command_delay_s = 0.004;
        Simulator simulator(machine, {});
        feed(simulator, 300, 300, 3);
        const FollowingReport report = following(simulator);
        const double each_mm_s = kFed_mm_s / std::numbers::sqrt2;
        EXPECT_NEAR(report.axes[0].peak, each_mm_s * (1 / kGain_1_s + 0.004), 1e-9);
        EXPECT_NEAR(report.feed.error_mm, of_all ? 0 : each_mm_s * 0.004 / std::numbers::sqrt2, 1e-9);
    }
}

// After a corner of 90 degrees x = -v/K exp(-K t) and y = v t - v/K (1 - exp(-K t)). The TCP is equally far
// from both lines at t = 1/K, and nowhere farther from the nearer one: by v / (K e).
TEST(FollowingErrorMonitor, LagRoundsCorner) {
    Simulator simulator(slides(), {});
    feed(simulator, 200, 0, 1);
    feed(simulator, 200, 200, 2);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.feed.error_mm, kFed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_NEAR(report.feed.t_s, 2 + 1 / kGain_1_s, 1e-8);
    EXPECT_EQ(report.feed.location.line, 2U);
    EXPECT_EQ(report.rapid.error_mm, 0);
    EXPECT_EQ(report.program->error_mm, report.feed.error_mm);  // it drives what is programmed
}

// A parabola in a corner of 90 degrees passes it at D, and is D / sqrt(2) from either line there. A machine
// that follows it exactly is on the path of the set points, and as far from that of the program.
TEST(FollowingErrorMonitor, BlendCountsOnlyInErrorFromProgram) {
    machine::Machine machine = slides();
    machine.controller = machine::built_in_controller("blend").value();
    machine.controller.position_loop.gain_1_s = 0;
    for (machine::Axis& axis : machine.axes) {
        axis.servo->velocity_feed_forward = 1;
        axis.max_acceleration = 1000;
        axis.max_speed = 500;
    }
    Simulator simulator(machine, {});
    simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0.2, 0);
    feed(simulator, 50, 0, 1);
    feed(simulator, 50, 50, 2);
    simulator.program().files().add("part.nc");
    const Report report = simulator.finish("part.nc");
    ASSERT_GT(report.blends.feed.deviation_mm, 0.05);
    EXPECT_NEAR(report.drives.following->feed.error_mm, 0, 1e-6);
    EXPECT_NEAR(report.drives.following->program->error_mm,
                report.blends.feed.deviation_mm / std::numbers::sqrt2, 1e-6);
}

// Corners of rapid moves count by themselves.
TEST(FollowingErrorMonitor, ReportsRapidMovesSeparately) {
    machine::Machine machine = slides();
    for (machine::Axis& axis : machine.axes) axis.max_speed = 3 * kFed_mm_s;
    Simulator simulator(machine, {});
    feed(simulator, 300, 0, 1, MoveKind::rapid);
    feed(simulator, 300, 300, 2, MoveKind::rapid);
    simulator.dwells().enqueue(2, {0, 3});
    feed(simulator, 100, 300, 4);
    feed(simulator, 100, 100, 5);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.rapid.error_mm, 3 * kFed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_EQ(report.rapid.location.line, 2U);
    EXPECT_NEAR(report.feed.error_mm, kFed_mm_s / kGain_1_s / std::numbers::e, 1e-8);
    EXPECT_EQ(report.feed.location.line, 5U);
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

// A circle comes out smaller by sqrt(1 + (w/K)^2). On the path into it the TCP is nowhere farther off.
TEST(FollowingErrorMonitor, CircleShrinksByClosedForm) {
    constexpr double kRadius_mm = 25;
    Simulator simulator(slides(), {});
    StringStream stream;
    TrajectoryWriter writer(stream.out(), simulator.machine(), 0.05, 1e9);
    writer.add_following(simulator.monitors().following_setup().value());
    simulator.add_output(writer);
    ArcMove move = circle_at(simulator, kRadius_mm, kFed_mm_s * 60);
    move.location = {0, 4};
    ASSERT_TRUE(simulator.moves().enqueue(move));
    const FollowingReport report = following(simulator);
    const double w = kFed_mm_s / kRadius_mm / kGain_1_s;
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

// A move of thousands of turns takes no longer than its steps, and a very slow one needs as few as any.
TEST(FollowingErrorMonitor, HandlesThousandsOfTurnsAndVerySlowMoves) {
    machine::Machine machine = slides();
    machine.controller = machine::built_in_controller("blend").value();
    Simulator simulator(machine, {});
    ArcMove move = circle_at(simulator, 25, kFed_mm_s * 60);
    move.sweep_rad *= 2000;
    ASSERT_TRUE(simulator.moves().enqueue(move));
    move.sweep_rad /= 2000;
    move.feed.linear_mm_min = 0.1;
    ASSERT_TRUE(simulator.moves().enqueue(move));
    simulator.dwells().enqueue(1e6, {0, 3});
    const FollowingReport report = following(simulator);
    const double w = kFed_mm_s / 25 / kGain_1_s;
    EXPECT_GE(report.feed.error_mm, 25 - 25 / std::sqrt(1 + w * w) - 1e-4);
    EXPECT_NEAR(report.axes[0].end, 0, 1e-9);
}

// The gain of the controller is that of axes without one of their own.
TEST(FollowingErrorMonitor, UsesControllerGainForAxesWithoutGain) {
    machine::Machine machine = slides();
    machine.axes[0].servo = machine::Servo{};
    machine.axes[1].servo.reset();
    machine.controller.position_loop.gain_1_s = 20;
    Simulator simulator(machine, {});
    feed(simulator, 300, 400, 1);
    const FollowingReport report = following(simulator);
    EXPECT_NEAR(report.axes[0].peak, 0.6 * kFed_mm_s / 20, 1e-9);
    EXPECT_NEAR(report.axes[1].peak, 0.8 * kFed_mm_s / 20, 1e-9);
    EXPECT_EQ(report.axes[2].gain_1_s, kGain_1_s);
}

TEST(FollowingErrorMonitor, MachineWithoutServosHasNoReport) {
    machine::Machine machine = slides();
    for (machine::Axis& axis : machine.axes) axis.servo.reset();
    machine.controller.position_loop.gain_1_s = 20;  // for exact stops alone
    Simulator simulator(machine, {});
    feed(simulator, 10, 0, 1);
    const Report report = simulator.finish("part.nc");
    EXPECT_FALSE(report.drives.following);
    EXPECT_FALSE(simulator.monitors().following_setup());
    EXPECT_THAT(to_json(report), Not(HasSubstr("following")));
    EXPECT_THAT(to_text(report), Not(HasSubstr("following")));
}

TEST(FollowingErrorMonitor, IsWrittenInReport) {
    Simulator simulator(slides(), {});
    simulator.program().files().add("part.nc");
    feed(simulator, 200, 0, 1);
    feed(simulator, 200, 200, 2);
    const Report report = simulator.finish("part.nc");
    EXPECT_THAT(to_json(report), HasSubstr(R"("contour": {
      "error_mm": 1.226)"));
    const std::string text = to_text(report);
    EXPECT_THAT(text, HasSubstr("following             peak         rms    delay (ms)   peak at\n"
                                "X mm                3.3333      2.3373        33.333   part.nc:1\n"));
    EXPECT_THAT(text, HasSubstr("contour     1.2263 mm at part.nc:2\n            1.2263 mm at part.nc:2, "
                                "from the programmed path\nin position 0.1936 s after the end\n"));
}

TEST(FollowingErrorMonitor, IsDrawnInPlot) {
    Simulator simulator(slides(), {});
    PlotData data(simulator.machine());
    data.add_following(simulator.monitors().following_setup().value());
    simulator.add_output(data);
    feed(simulator, 200, 0, 1);
    simulator.finish("part.nc");
    const std::string script = plot_script(data, PictureFormat::svg, "part.nc");
    EXPECT_THAT(script, HasSubstr("set ylabel 'following error (mm)' noenhanced"));
    EXPECT_THAT(script, HasSubstr("$following_X << EOD"));
    EXPECT_THAT(script, HasSubstr("title 'contour error of the TCP'"));
    EXPECT_NEAR(data.following(0).back().value, kFed_mm_s / kGain_1_s, 1e-9);
}

}  // namespace
}  // namespace gsim::simulation::following_watch_test
