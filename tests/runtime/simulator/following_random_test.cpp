// True positions of axes and TCP in random programs, against finer steps.
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "machine/file/controller_file.h"
#include "runtime/monitors/following_monitor.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/fed_lines.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::following_random_test {
namespace {

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

/// Steps of half the time change no relevant value, neither of an axis nor of the TCP.
TEST(FollowingErrorMonitor, HalfStepGivesSameResults) {
    constexpr std::size_t kPrograms = 10;
    double max = 0;
    for (std::size_t program = 0; program < kPrograms; ++program) {
        std::mt19937 random(static_cast<unsigned>(program));
        const machine::Machine machine = random_servos(random, program);
        Simulator simulator(machine, {});
        FollowingErrorMonitor half(simulator.monitors().following_setup().value(),
                                   dynamics::ServoMotion::kStep_s / 2);
        simulator.add_output(half);
        RandomMoves(random, simulator).make(12);
        const Report report = simulator.finish("random");
        const FollowingReport& full = report.drives.following.value();
        for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
            // If both sides have equal peaks, the step may decide which of them counts.
            EXPECT_NEAR(std::abs(full.axes[axis].peak), std::abs(half.report().axes[axis].peak), 1e-6)
                << program;
            EXPECT_NEAR(full.axes[axis].rms, half.report().axes[axis].rms, 1e-6) << program;
            EXPECT_NEAR(full.axes[axis].end, half.report().axes[axis].end, 1e-6) << program;
        }
        EXPECT_NEAR(full.feed.error_mm, half.report().feed.error_mm, 1e-6) << program;
        EXPECT_NEAR(full.rapid.error_mm, half.report().rapid.error_mm, 1e-6) << program;
        max = std::max(max, full.feed.error_mm);
    }
    EXPECT_GT(max, 0.1);
}

// The TCP is no farther from the program than the sum of two distances: from the path of the set points, and
// of this path from the program.
TEST(FollowingErrorMonitor, ErrorFromProgramIsAtMostContourErrorPlusBlend) {
    constexpr std::array kModels{"blend", "linuxcnc-2.9"};
    double rounded = 0;
    for (std::size_t program = 0; program < 16; ++program) {
        std::mt19937 random(static_cast<unsigned>(program));
        machine::Machine machine = random_servos(random, program);
        machine.controller = machine::built_in_controller(kModels[program % 2]).value();
        Simulator simulator(machine, {});
        simulator.program().settings().set_path_mode(rrs::PathMode::continuous, 0.5, 0);
        for (std::uint32_t line = 1; line < 30; ++line)
            feed(simulator, between(random, -20, 20), between(random, -20, 20), line);
        const Report report = simulator.finish("random");
        const double both_mm = report.drives.following->feed.error_mm + report.blends.feed.deviation_mm;
        EXPECT_LE(report.drives.following->program->error_mm, both_mm + 1e-6) << program;
        EXPECT_GE(report.drives.following->program->error_mm, report.blends.feed.deviation_mm / 4) << program;
        rounded = std::max(rounded, report.blends.feed.deviation_mm);
    }
    EXPECT_GT(rounded, 0.1);
}

/// Loop of one joint as defined, by the rule of Runge and Kutta in fine steps along the run.
struct Witness : RunOutput {
    static constexpr double kStep_s = 1e-4;
    using State = std::array<double, 2>;  // position, speed

    Witness(const machine::Servo& of, int of_joint) : servo(of), joint(of_joint) {}

    void begin(const rrs::JointPos& start) override { at = {start[joint], 0}; }
    void on_segment(const motion::Segment& segment, const MoveInfo&) override {
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
        at[1] += servo.acceleration_feed_forward * (from.velocity[joint] - set_speed);  // at its jumps
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

TEST(FollowingErrorMonitor, RandomProgramsMatchFineSteps) {
    constexpr std::size_t kWitnessed = 10 / kFewerBy;
    for (std::size_t program = 0; program < kWitnessed; ++program) {
        std::mt19937 random(static_cast<unsigned>(100 + program));
        machine::Machine machine = random_servos(random, program);
        for (machine::Axis& axis : machine.axes) axis.servo->command_delay_s = 0;
        Simulator simulator(machine, {});
        Witness x(*machine.axes[0].servo, 0), c(*machine.axes[4].servo, 4);
        simulator.add_output(x);
        simulator.add_output(c);
        RandomMoves(random, simulator).make(12);
        const FollowingReport report = simulator.finish("random").drives.following.value();
        constexpr double kDegPerRad = 180 / std::numbers::pi;
        EXPECT_NEAR(report.axes[0].end, x.error, 5e-5 * (1 + std::abs(report.axes[0].peak))) << program;
        EXPECT_NEAR(report.axes[4].end, c.error * kDegPerRad, 5e-5 * (1 + std::abs(report.axes[4].peak)))
            << program;
    }
}

}  // namespace
}  // namespace gsim::simulation::following_random_test
