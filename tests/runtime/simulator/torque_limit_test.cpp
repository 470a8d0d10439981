// Accelerations that the peaks of the motors allow, against closed forms and the efforts of finished runs.
#include "machine/model/torque_limit.h"

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "runtime/simulator/machine_dynamics.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::torque_limit_test {
namespace {

using testing::HasSubstr;

constexpr double kG = 9.80665;  // m/s2

// 50 kg along X; Z is vertical, with 20 of them. What the axes could do is much less than the motors.
std::string slides(std::string_view x = "peak_n = 400", std::string_view controller = "exact-stop") {
    return fmt::format(R"([machine]
name = "slides"
[controller]
model = "{}"
[dynamics]
limit = "torque"
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
max_speed_mm_s = 1000
max_acceleration_mm_s2 = 1000
coulomb_n = 100
{}
[[axis]]
letter = "Z"
kind = "linear"
direction = "z"
max_speed_mm_s = 1000
max_acceleration_mm_s2 = 1000
coulomb_n = 20
peak_n = 300
[[mass]]
on = "X"
mass_kg = 30
[[mass]]
on = "Z"
mass_kg = 20
)",
                       controller, x);
}

machine::Machine read(const std::string& text) {
    auto machine = machine::read_machine(text, "m.toml");
    EXPECT_TRUE(machine) << machine.error().message;
    return *std::move(machine);
}

std::string rejection(const std::string& text) {
    const auto machine = machine::read_machine(text, "m.toml");
    return machine ? "" : machine.error().message;
}

std::unique_ptr<Simulator> simulator_of(const machine::Machine& machine) {
    auto simulator = std::make_unique<Simulator>(machine, RunLimits{});
    simulator->monitors().set_dynamics(make_dynamics(machine).value());
    simulator->program().files().add("part.nc");
    return simulator;
}

bool rapid(Simulator& simulator, const AxisVector& target) {
    return simulator.moves().enqueue(
        LineMove{.kind = MoveKind::rapid, .target = target, .feed = {}, .location = {0, 1}});
}

AxisVector at(double x, double z) {
    AxisVector axes(2);
    axes << x, z;
    return axes;
}

/// Returns the time between standstills over a distance; m, m/s, m/s2.
double time_s(double distance, double speed, double up, double down) {
    const double ramps = 1 / up + 1 / down;
    if (speed * speed * ramps / 2 > distance) return std::sqrt(2 * distance * ramps);
    return distance / speed + speed * ramps / 2;
}

/// Beyond the peaks, as a share of them.
double excess(const Report& report) {
    double max = 0;
    for (const EffortExcess& one : report.drives.efforts->excesses)
        max = std::max(max, one.effort / one.limit - 1);
    return max;
}

TEST(TorqueLimit, SlideMatchesClosedForm) {
    const auto simulator = simulator_of(read(slides()));
    ASSERT_TRUE(rapid(*simulator, at(500, 0)));
    const Report report = simulator->finish("part.nc");
    EXPECT_NEAR(report.cycle_time_s, time_s(0.5, 1, 300.0 / 50, 500.0 / 50), 1e-9);
    EXPECT_NEAR(report.drives.efforts->axes[0].peak, 400, 1e-6);
    EXPECT_EQ(report.drives.efforts->excess_count, 0U);
    ASSERT_TRUE(report.drives.efforts->time_by_axis_accelerations_s);
    EXPECT_NEAR(*report.drives.efforts->time_by_axis_accelerations_s, time_s(0.5, 1, 1, 1), 1e-9);
    EXPECT_THAT(to_text(report),
                HasSubstr("limit       torques: with the axis accelerations the same moves take 1.414 s"));
    EXPECT_THAT(to_json(report), HasSubstr("\"time_by_axes_s\""));
}

TEST(TorqueLimit, VerticalAxisIncludesWeight) {
    const double weight = 20 * kG;
    const auto up = simulator_of(read(slides()));
    ASSERT_TRUE(rapid(*up, at(0, 300)));
    EXPECT_NEAR(up->finish("up").cycle_time_s,
                time_s(0.3, 1, (300 - 20 - weight) / 20, (300 + 20 + weight) / 20), 1e-9);
    const auto down = simulator_of(read(slides()));
    ASSERT_TRUE(rapid(*down, at(0, -300)));
    const Report report = down->finish("down");
    EXPECT_NEAR(report.cycle_time_s, time_s(0.3, 1, (300 - 20 + weight) / 20, (300 + 20 - weight) / 20),
                1e-9);
    EXPECT_EQ(report.drives.efforts->excess_count, 0U);
}

TEST(TorqueLimit, FollowsMotorCurveAtSpeed) {
    const std::string curve = "curve_speed_mm_s = [0, 500, 1000]\ncurve_peak_n = [400, 400, 110]";
    const auto simulator = simulator_of(read(slides(curve)));
    ASSERT_TRUE(rapid(*simulator, at(20, 0)));  // never faster than 500 mm/s
    EXPECT_NEAR(simulator->clock().time_s(), time_s(0.02, 0.5, 300.0 / 50, 500.0 / 50), 1e-9);
    ASSERT_TRUE(rapid(*simulator, at(2000, 0)));
    const Report report = simulator->finish("part.nc");
    EXPECT_EQ(report.drives.efforts->excess_count, 0U);
    const double second_s = report.cycle_time_s - time_s(0.02, 0.5, 6, 10);
    EXPECT_LT(second_s, time_s(1.98, 0.5, 6, 10));  // faster than without what the motor has beyond
    EXPECT_GT(second_s, time_s(1.98, 1, 6, 10));
}

TEST(TorqueLimit, ProgrammedRampsStillApply) {
    const auto simulator = simulator_of(read(slides()));
    simulator->program().ramps().set_limit(rrs::RampLimit::acceleration, 0, 4000);
    ASSERT_TRUE(rapid(*simulator, at(500, 0)));
    EXPECT_NEAR(simulator->clock().time_s(), time_s(0.5, 1, 4, 10), 1e-9);
}

TEST(TorqueLimit, RejectsMoveIfMotorCannotHoldWeight) {
    std::string text = slides();
    text.replace(text.find("peak_n = 300"), 12, "peak_n = 190");
    const auto simulator = simulator_of(read(text));
    EXPECT_FALSE(rapid(*simulator, at(0, 300)));
    EXPECT_THAT(simulator->outcome().alarm()->message,
                HasSubstr("axis Z: The motor is too weak for this move"));
}

TEST(TorqueLimit, RejectsInvalidSettingsByName) {
    EXPECT_THAT(
        rejection(slides("", "exact-stop").replace(slides("").find("max_acceleration_mm_s2 = 1000"), 29, "")),
        HasSubstr("'limit = \"torque\"' of [dynamics] needs 'peak_n' of axis X, or 'max_acceleration_mm_s2' "
                  "if it has no motor"));
    for (const std::string_view model : {"linuxcnc-2.9", "linuxcnc-2.10", "klipper"})
        EXPECT_THAT(rejection(slides("peak_n = 400", model)), HasSubstr("\"linuxcnc\" and \"klipper\""))
            << model;
    for (const std::string_view model : {"grbl-1.1", "grblhal"})
        EXPECT_THAT(rejection(slides("peak_n = 400", model)), HasSubstr("'arc_chord_tolerance_mm'")) << model;
    const auto without_mass = read(slides().substr(0, slides().find("[[mass]]")));
    const auto dynamics_result = make_dynamics(without_mass);
    ASSERT_FALSE(dynamics_result);
    EXPECT_THAT(dynamics_result.error(), HasSubstr("needs a mass that axis X moves"));
}

// An arm of two links in a vertical plane, 400 and 300 mm, with speeds at which the one throws the other.
constexpr std::string_view kArm = R"([machine]
name = "arm"
[controller]
model = "blend"
[base]
roll_deg = 90
[dynamics]
limit = "torque"
[[axis]]
letter = "A"
kind = "rotary"
max_speed_deg_s = 400
max_acceleration_deg_s2 = 300
dh = { a_mm = 400 }
coulomb_nm = 3
viscous_nm_per_deg_s = 0.02
peak_nm = 220
[[axis]]
letter = "B"
kind = "rotary"
max_speed_deg_s = 500
max_acceleration_deg_s2 = 300
dh = { a_mm = 300 }
coulomb_nm = 1
peak_nm = 70
curve_speed_deg_s = [0, 250, 600]
curve_peak_nm = [70, 70, 30]
[[mass]]
on = "A"
mass_kg = 12
centre_mm = [-200, 0, 0]
inertia_kg_m2 = [0.01, 0.2, 0.2]
[[mass]]
on = "B"
mass_kg = 6
centre_mm = [-120, 0, 0]
inertia_kg_m2 = [0.01, 0.1, 0.1]
)";

Report arm_run(const machine::Machine& machine, unsigned seed) {
    const auto simulator = simulator_of(machine);
    std::mt19937 random(seed);
    simulator->program().settings().set_path_mode(
        seed % 3 == 0 ? rrs::PathMode::exact_stop : rrs::PathMode::continuous, 0, 0);
    for (int i = 0; i < 20; ++i) {
        AxisVector target(2);
        target << between(random, -180, 180), between(random, -150, 150);
        if (i % 4 == 3)
            target = simulator->position().axes() + AxisVector::Constant(2, between(random, -4, 4));
        LineMove move{.kind = i % 2 == 0 ? MoveKind::rapid : MoveKind::linear,
                      .target = target,
                      .feed = {.linear_mm_min = 60000, .rotary_deg_min = between(random, 6000, 30000)},
                      .location = {0, 1}};
        EXPECT_TRUE(simulator->moves().enqueue(move));
    }
    return simulator->finish("arm");
}

TEST(TorqueLimit, ArmKeepsPeaksAndSavesTime) {
    const machine::Machine machine = read(std::string(kArm));
    double shortest = 1, longest = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Report report = arm_run(machine, seed);
        ASSERT_EQ(report.status, RunStatus::completed);
        EXPECT_LE(excess(report), 1e-6) << seed;
        ASSERT_TRUE(report.drives.efforts->time_by_axis_accelerations_s);
        const double share = report.cycle_time_s / *report.drives.efforts->time_by_axis_accelerations_s;
        shortest = std::min(shortest, share);
        longest = std::max(longest, share);
    }
    fmt::print("times of those by constant accelerations that keep the peaks: {:.3f} to {:.3f}\n", shortest,
               longest);
    EXPECT_LT(longest, 1);
    // Those constants are safe, so that the comparison is one of like with like.
    std::string constant(kArm);
    constant.replace(constant.find("limit = \"torque\""), 16, "");
    for (unsigned seed = 0; seed < 60; ++seed) EXPECT_LE(excess(arm_run(read(constant), seed)), 1e-6) << seed;
}

/// Returns the gantry with a turning head and a tool off its axes, under a hose. Its motors are strong enough
/// to hold it.
machine::Machine heavy(std::mt19937& random, std::string_view model) {
    machine::Machine machine = random_machine(random, af5());
    machine.controller = machine::built_in_controller(model).value();
    machine.dynamics = machine::DynamicsTable{.gravity_m_s2 = {1, -2, -9.5}};
    machine.dynamics->limit = machine::AccelerationLimit::torque;
    for (machine::Axis& axis : machine.axes) {
        const bool rotary = axis.kind == machine::AxisKind::rotary;
        axis.drive = {.coulomb_friction = around(random, rotary ? 2 : 40, 0.3),
                      .viscous = around(random, rotary ? 0.02 : 0.2, 0.3),
                      .rotor = around(random, rotary ? 0.1 : 10, 0.3),
                      .counterweight = between(random, -20, 20),
                      .peak = around(random, rotary ? 150 : 5000, 0.1)};
        if (random() % 2 == 0) {
            axis.drive.curve_speeds = {0, axis.max_speed / 3, axis.max_speed * 1.1};
            axis.drive.curve_peaks = {axis.drive.peak * 1.2, axis.drive.peak * 1.1, axis.drive.peak * 0.5};
        }
        machine.dynamics->masses.push_back({.on = std::string(1, axis.letter),
                                            .mass_kg = around(random, rotary ? 4 : 20, 0.3),
                                            .centre_mm = {between(random, -50, 50), 30, -60},
                                            .inertia_kg_m2 = {0.5, 0.6, 0.7, 0.05, 0.02, -0.1}});
    }
    add_tool_on_hose(machine);
    return machine;
}

TEST(TorqueLimit, RandomProgramsKeepPeaks) {
    int completed = 0;
    constexpr unsigned kPrograms = 120;
    for (unsigned program = 0; program < kPrograms; ++program) {
        constexpr std::array kModels{"exact-stop", "ab9", "blend"};
        std::mt19937 random(program);
        const machine::Machine machine = heavy(random, kModels[program % kModels.size()]);
        if (const auto error = machine::find_torque_limit_error(machine)) FAIL() << error->message;
        const auto simulator = simulator_of(machine);
        RandomMoves(random, *simulator).make(12);
        const Report report = simulator->finish("random");
        completed += report.status == RunStatus::completed ? 1 : 0;
        EXPECT_LE(excess(report), 1e-6) << program << ' ' << machine.controller.model;
    }
    EXPECT_GT(completed, static_cast<int>(kPrograms) / 2);
}

}  // namespace
}  // namespace gsim::simulation::torque_limit_test
