// Report values of motors, against closed forms.
#include "runtime/monitors/effort_monitor.h"

#include <string>

#include <gmock/gmock.h>

#include "machine/file/machine_file.h"
#include "runtime/outputs/trajectory_writer.h"
#include "runtime/simulator/machine_dynamics.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/string_stream.h"

namespace gsim::simulation::effort_watch_test {
namespace {

using testing::HasSubstr;

// 100 kg along X, of which 20 kg go along Z.
constexpr std::string_view kMachine = R"([machine]
name = "m"
[dynamics]
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
max_speed_mm_s = 500
max_acceleration_mm_s2 = 2000
coulomb_n = 30
peak_n = 200
continuous_n = 120
[[axis]]
letter = "Z"
kind = "linear"
direction = "z"
max_speed_mm_s = 500
max_acceleration_mm_s2 = 2000
[[mass]]
on = "X"
mass_kg = 80
[[mass]]
on = "Z"
mass_kg = 20
)";

machine::Machine make_machine(const std::string& more = "") {
    return machine::read_machine(std::string(kMachine) + more, "m.toml").value();
}

std::unique_ptr<Simulator> simulator_of(const machine::Machine& machine) {
    auto simulator = std::make_unique<Simulator>(machine, RunLimits{});
    simulator->monitors().set_dynamics(make_dynamics(machine).value());
    simulator->program().files().add("part.nc");
    return simulator;
}

void rapid(Simulator& simulator, double x, double z, std::uint32_t line) {
    LineMove move{
        .kind = MoveKind::rapid, .target = simulator.position().axes(), .feed = {}, .location = {0, line}};
    move.target[0] = x;
    move.target[1] = z;
    simulator.moves().enqueue(move);
}

TEST(EffortMonitor, MoveMatchesClosedForm) {
    const auto simulator = simulator_of(make_machine());
    rapid(*simulator, 500, 0, 7);  // 0.25 s up, 0.75 s, 0.25 s down
    simulator->dwells().enqueue(1, {0, 8});
    const Report report = simulator->finish("part.nc");
    ASSERT_TRUE(report.drives.efforts);
    const AxisEffort& x = report.drives.efforts->axes[0];
    EXPECT_NEAR(x.peak, 230, 1e-6);
    EXPECT_LT(x.peak_t_s, 0.25 + 1e-6);
    EXPECT_EQ(x.peak_location.line, 7U);
    EXPECT_NEAR(x.peak_power_w, 115, 1e-6);
    const double squares = 0.25 * 230 * 230 + 0.75 * 900 + 0.25 * 170 * 170;
    EXPECT_NEAR(x.rms, std::sqrt(squares / 2.25), 1e-7);
    EXPECT_NEAR(x.drive_j, 12.5 + 30 * 0.4375, 1e-7);  // but the 0.0625 m in which 170 N brake
    EXPECT_NEAR(x.regenerated_j, 170 * 0.0625, 1e-7);
    EXPECT_NEAR(x.friction_j, 15, 1e-9);
    const AxisEffort& z = report.drives.efforts->axes[1];
    EXPECT_NEAR(z.peak, 20 * 9.80665, 1e-9);
    EXPECT_NEAR(z.rms, 20 * 9.80665, 1e-7);
    EXPECT_EQ(z.drive_j, 0);
    EXPECT_EQ(report.drives.efforts->jumps, 0U);
}

TEST(EffortMonitor, ReportsExcessWithPossibleAcceleration) {
    const auto simulator = simulator_of(make_machine());
    rapid(*simulator, 1, 0, 3);
    rapid(*simulator, 1, 100, 4);
    const Report report = simulator->finish("part.nc");
    ASSERT_EQ(report.drives.efforts->excesses.size(), 1U);
    const EffortExcess& excess = report.drives.efforts->excesses[0];
    EXPECT_EQ(excess.location.line, 3U);
    EXPECT_NEAR(*excess.acceleration_share, (200 - 30) / 200.0, 1e-6);
    EXPECT_EQ(excess_text(excess), "axis X needs 230 N of 200 N; 0.85 of its acceleration is possible");
    const std::string json = to_json(report);
    EXPECT_THAT(json, HasSubstr("\"code\": \"motor-peak\""));
    EXPECT_THAT(
        to_text(report),
        HasSubstr("motor: part.nc:3: axis X needs 230 N of 200 N; 0.85 of its acceleration is possible\n"));
}

// The share is what it says: with 0.85 of the acceleration the same move is within the limit, and with more
// not.
TEST(EffortMonitor, ReportedAccelerationShareIsSufficient) {
    for (const double share : {0.85, 0.86}) {
        machine::Machine machine = make_machine();
        machine.axes[0].max_acceleration *= share;
        const auto simulator = simulator_of(machine);
        rapid(*simulator, 1, 0, 3);
        const Report report = simulator->finish("part.nc");
        EXPECT_EQ(std::any_of(report.drives.efforts->excesses.begin(), report.drives.efforts->excesses.end(),
                              [](const EffortExcess& excess) { return !excess.continuous; }),
                  share > 0.85);
    }
}

TEST(EffortMonitor, ReportsWeightAbovePeakAtAnyAcceleration) {
    machine::Machine machine = make_machine();
    machine.axes[1].drive.peak = 190;
    const auto simulator = simulator_of(machine);
    rapid(*simulator, 0, 1, 5);
    const Report report = simulator->finish("part.nc");
    EXPECT_EQ(
        excess_text(report.drives.efforts->excesses[0]),
        "axis Z needs 236.1 N of 190 N; weight, friction and speed alone exceed it, with any acceleration");
}

TEST(EffortMonitor, ReportsRmsAboveContinuousEffort) {
    machine::Machine machine = make_machine();
    machine.axes[0].drive.peak = 1000;
    const auto simulator = simulator_of(machine);
    for (int i = 0; i < 10; ++i) rapid(*simulator, i % 2 == 0 ? 20 : 0, 0, 3);
    const Report report = simulator->finish("part.nc");
    ASSERT_EQ(report.drives.efforts->excesses.size(), 1U);
    // Half of the time 230 N, half 170 N.
    EXPECT_EQ(
        excess_text(report.drives.efforts->excesses[0]),
        "axis X needs 202.2 N as a root mean square of the complete run, of 120 N continuous of its motor");
    EXPECT_THAT(to_json(report), HasSubstr("\"code\": \"motor-continuous\""));
}

TEST(EffortMonitor, InterpolatesMotorCurve) {
    const machine::Drive drive{.peak = 90, .curve_speeds = {100, 200}, .curve_peaks = {100, 50}};
    EXPECT_EQ(motor_peak(drive, 0), 90);
    EXPECT_EQ(motor_peak(drive, 150), 75);
    EXPECT_EQ(motor_peak(drive, 200), 50);
    EXPECT_EQ(motor_peak(drive, 201), 0);
    EXPECT_EQ(motor_peak({}, 1e9), std::numeric_limits<double>::infinity());
}

// The acceleration has no limit: the speed jumps from 0 to 0.5 m/s and back.
TEST(EffortMonitor, SpeedJumpsAreImpulsesAndWork) {
    machine::Machine machine = make_machine();
    machine.axes[0].max_acceleration = std::numeric_limits<double>::infinity();
    const auto simulator = simulator_of(machine);
    rapid(*simulator, 500, 0, 3);
    const Report report = simulator->finish("part.nc");
    EXPECT_EQ(report.drives.efforts->jumps, 2U);
    const AxisEffort& x = report.drives.efforts->axes[0];
    EXPECT_NEAR(x.impulse, 100 * 0.5, 1e-9);
    EXPECT_NEAR(x.peak, 30, 1e-9);
    EXPECT_NEAR(x.drive_j, 12.5 + 15, 1e-7);
    EXPECT_NEAR(x.regenerated_j, 12.5, 1e-7);
    EXPECT_THAT(to_text(report), HasSubstr("jumps       2 in speed"));
}

TEST(EffortMonitor, SumsEnergyOfEachProgram) {
    const auto simulator = simulator_of(make_machine());
    rapid(*simulator, 500, 0, 1);
    for (int i = 0; i < 2; ++i) {
        simulator->program().calls().enter("O2", {0, 2});
        rapid(*simulator, 500, i == 0 ? 100 : 0, 3);
        simulator->program().calls().leave();
    }
    rapid(*simulator, 0, 0, 4);
    const Report report = simulator->finish("part.nc");
    const std::vector<ProgramEnergy>& programs = report.drives.efforts->programs;
    ASSERT_EQ(programs.size(), 2U);
    EXPECT_EQ(programs[0].program, "");
    EXPECT_NEAR(programs[0].drive_j - programs[0].regenerated_j, 30, 1e-7);
    EXPECT_NEAR(programs[0].time_s, 2.5, 1e-9);
    EXPECT_EQ(programs[1].program, "O2");
    EXPECT_NEAR(programs[1].drive_j - programs[1].regenerated_j, 0, 1e-7);
    EXPECT_NEAR(programs[1].drive_j, 20 * 9.80665 * 0.1, 1e-7);  // up, and back as it moves down
}

TEST(EffortMonitor, TrajectoryHasForcesAndPower) {
    const machine::Machine machine = make_machine();
    const auto dynamics = make_dynamics(machine).value();
    Simulator simulator(machine, {});
    StringStream stream;
    TrajectoryWriter writer(stream.out(), machine, 0.1, 1e9);
    writer.add_efforts(*dynamics);
    simulator.add_output(writer);
    rapid(simulator, 500, 0, 3);
    simulator.finish("part.nc");
    stream.out().flush();
    const std::string text = stream.text();
    EXPECT_EQ(text.substr(0, text.find('\n')), "t_s,line,x_mm,z_mm,speed_mm_s,x_n,z_n,power_w");
    // At 0.2 s 0.4 m/s, 230 N; at 0.5 s 0.5 m/s, 30 N.
    EXPECT_THAT(text, HasSubstr("\n0.2,3,40,0,400,230,196.133,92\n"));
    EXPECT_THAT(text, HasSubstr("\n0.5,3,187.5,0,500,30,196.133,15\n"));
    EXPECT_THAT(text, HasSubstr("\n1.25,3,500,0,0,0,196.133,0\n"));
}

}  // namespace
}  // namespace gsim::simulation::effort_watch_test
