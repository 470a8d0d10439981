// Random programs under each controller: the work of the motors is the loss by friction plus the energy that
// the machine has gained, both computed by other means.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "machine/file/controller_file.h"
#include "motion/kinematics/chain.h"
#include "runtime/simulator/machine_dynamics.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::efforts_balance_test {
namespace {

constexpr int kPrograms = 100 / kFewerBy;
constexpr int kMoves = 12;
constexpr double kRelative = 1e-6;

/// Returns the gantry with masses, so that gravity is along no axis, and with a tool off the axis of its
/// turning head.
machine::Machine heavy(std::mt19937& random, std::size_t program) {
    constexpr std::array kModels{"exact-stop", "ab9", "blend", "linuxcnc-2.9", "grbl-1.1"};
    machine::Machine machine = random_machine(random, af5());
    machine.controller = machine::built_in_controller(kModels[program % kModels.size()]).value();
    machine.dynamics = machine::DynamicsTable{.gravity_m_s2 = {1, -2, -9.5}};
    for (machine::Axis& axis : machine.axes) {
        const bool rotary = axis.kind == machine::AxisKind::rotary;
        axis.drive = {.coulomb_friction = around(random, rotary ? 2 : 40, 0.3),
                      .viscous = around(random, rotary ? 0.02 : 0.2, 0.3),
                      .rotor = around(random, rotary ? 0.1 : 10, 0.3),
                      .counterweight = between(random, -20, 20)};
        machine.dynamics->masses.push_back({.on = std::string(1, axis.letter),
                                            .mass_kg = around(random, 20, 0.5),
                                            .centre_mm = {between(random, -100, 100), 30, -60},
                                            .inertia_kg_m2 = {0.5, 0.6, 0.7, 0.05, 0.02, -0.1}});
    }
    add_tool_on_hose(machine);
    return machine;
}

/// Friction work, from fine samples of the path; and the positions at the machine's start and end.
struct Friction : RunOutput {
    explicit Friction(const machine::Machine& of) : machine(of) {}

    void begin(const rrs::JointPos& at) override { start = end_at = at; }
    void on_segment(const motion::Segment& segment, const MoveInfo&) override {
        constexpr int kSteps = 4000;
        end_at = segment.end_position();
        if (segment.kind == motion::SegmentKind::rest && !segment.superimposed) return;
        rrs::JointPos from = segment.start;
        const double step_s = segment.duration_s / kSteps;
        for (int i = 1; i <= kSteps; ++i) {
            const rrs::JointPos to = segment.position_at(step_s * i);
            const rrs::JointPos v = segment.at(step_s * (i - 0.5)).velocity;
            for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
                const auto joint = static_cast<Eigen::Index>(axis);
                const bool linear = machine.axes[axis].kind == machine::AxisKind::linear;
                const machine::Drive& drive = machine.axes[axis].drive;
                const double distance = std::abs(to[joint] - from[joint]) * (linear ? 1e-3 : 1);
                const double speed = axis_speed(linear, v[joint]);
                work_j += drive.coulomb_friction * distance;
                work_j += drive.viscous * speed * std::abs(v[joint]) * (linear ? 1e-3 : 1) * step_s;
            }
            from = to;
        }
    }
    static double axis_speed(bool linear, double v) {
        return std::abs(linear ? v : v * 180 / std::numbers::pi);
    }

    const machine::Machine& machine;
    rrs::JointPos start, end_at;
    double work_j = 0;
};

/// Returns the potential energy of weights, counterweights and hose, from the frames of the links.
double potential_j(const machine::Machine& machine, const rrs::JointPos& q) {
    const auto kinematics = make_kinematics(machine);
    const std::vector<rrs::CartPos> frames = kinematics->chain().tool_frames(q);
    const machine::DynamicsTable& table = *machine.dynamics;
    const Eigen::Vector3d gravity(table.gravity_m_s2[0], table.gravity_m_s2[1], table.gravity_m_s2[2]);
    const auto vector = [](const std::array<double, 3>& a) { return Eigen::Vector3d(a[0], a[1], a[2]); };
    double energy = 0;
    for (const machine::LinkMass& mass : table.masses) {
        const std::size_t frame =
            mass.on == "tool" ? frames.size() - 1 : machine.find(mass.on[0]).value() + 1;
        energy -= mass.mass_kg * gravity.dot(1e-3 * (frames[frame] * vector(mass.centre_mm)));
    }
    for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
        const double scale = machine.axes[axis].kind == machine::AxisKind::linear ? 1e-3 : 1;
        energy -= machine.axes[axis].drive.counterweight * scale * q[static_cast<Eigen::Index>(axis)];
    }
    const machine::HoseTable& hose = table.hoses.front();
    const double excess_mm =
        (frames.back() * vector(hose.point_mm) - vector(hose.anchor_mm)).norm() - hose.free_length_mm;
    if (excess_mm > 0) energy += 0.5e-3 * hose.stiffness_n_per_mm * excess_mm * excess_mm;
    return energy;
}

TEST(EnergyBalance, HoldsForRandomProgramsWithEachController) {
    std::uint64_t jumps = 0;
    for (std::size_t program = 0; program < kPrograms; ++program) {
        std::mt19937 random(static_cast<unsigned>(program));
        const machine::Machine machine = heavy(random, program);
        Simulator simulator(machine, {});
        simulator.monitors().set_dynamics(make_dynamics(machine).value());
        Friction friction(machine);
        simulator.add_output(friction);
        RandomMoves(random, simulator).make(kMoves);
        const Report report = simulator.finish("random");
        ASSERT_TRUE(report.drives.efforts);
        const EffortReport& efforts = *report.drives.efforts;
        jumps += efforts.jumps;
        const double through_j = efforts.drive_j + efforts.regenerated_j;
        const double gained_j = potential_j(machine, friction.end_at) - potential_j(machine, friction.start);
        EXPECT_NEAR(efforts.drive_j - efforts.regenerated_j, gained_j + efforts.friction_j,
                    kRelative * through_j)
            << program << ' ' << machine.controller.model;
        EXPECT_NEAR(efforts.friction_j, friction.work_j, 1e-5 * friction.work_j)
            << program << ' ' << machine.controller.model;
        double of_programs = 0;
        for (const ProgramEnergy& one : efforts.programs) of_programs += one.drive_j;
        EXPECT_NEAR(of_programs, efforts.drive_j, 1e-9 * through_j);
    }
    EXPECT_GT(jumps, 100U);
}

}  // namespace
}  // namespace gsim::simulation::efforts_balance_test
