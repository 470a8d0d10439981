// Random programs under each controller: what the joints do each 0.1 ms, against what the table in
// docs/accuracy.md says that the control keeps.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "machine/file/controller_file.h"
#include "runtime/simulator/make_planner_setup.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::kept_limits_test {
namespace {

constexpr double kPeriod_s = 1e-4;
constexpr double kRounding = 1e-6;
constexpr std::array<std::size_t, 5> kWindows{10, 20, 50, 100, 200};  // 1 to 20 ms
constexpr unsigned kPrograms = 4;
constexpr int kMoves = 40;

/// Amounts by which a controller may exceed a joint's limits.
struct Excess {
    const char* model;
    double speed;         ///< Times the joint's limit.
    double step_s;        ///< Jumps of the speed, as what the acceleration makes in this time,
    double deviation_mm;  ///< or as junction deviation allows them.
    double acceleration;  ///< Times the joint's limit, over a window.
    bool on_arcs;         ///< True if that holds round arcs, too.
};

/// Joint velocities each kPeriod_s, and whether the joints are on an arc; the times and their sums.
struct Samples : RunOutput {
    void on_segment(const motion::Segment& segment, const MoveInfo&) override {
        EXPECT_NEAR(segment.start_s, end_s, 1e-9);
        for (; next_s < segment.end_s(); next_s += kPeriod_s) {
            velocities.push_back(segment.at(next_s - segment.start_s).velocity);
            is_on_arc.push_back(segment.kind == motion::SegmentKind::circular);
        }
        end_s = segment.end_s();
        segments_s += segment.duration_s;
    }
    void on_move(const RecordedMove& move) override { moves_s += move.end_s - move.start_s; }

    std::vector<rrs::JointPos> velocities;
    std::vector<bool> is_on_arc;
    double next_s = 0;
    double end_s = 0;
    double segments_s = 0;
    double moves_s = 0;
};

class JointLimitsOfController : public testing::TestWithParam<Excess> {
  protected:
    static machine::Machine make_machine(std::mt19937& random) {
        machine::Machine machine = random_machine(random, af5());
        for (machine::Axis& axis : machine.axes)
            axis.max_speed_step = std::numeric_limits<double>::infinity();
        machine.controller = machine::built_in_controller(GetParam().model).value();
        return machine;
    }

    static void check_samples(const Samples& samples, const motion::PlannerSetup& setup) {
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const motion::JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
            expect_speed(samples, joint, GetParam().speed * limits.max_speed);
            for (const std::size_t window : kWindows)
                expect_acceleration(samples, joint, limits.max_acceleration, window);
        }
    }

  private:
    static void expect_speed(const Samples& samples, int joint, double limit) {
        double max = 0;
        for (const rrs::JointPos& velocity : samples.velocities)
            max = std::max(max, std::abs(velocity[joint]));
        EXPECT_LE(max, limit * (1 + kRounding)) << joint;
    }

    static void expect_acceleration(const Samples& samples, int joint, double limit, std::size_t window) {
        const Excess& excess = GetParam();
        double max = 0;
        std::size_t last_arc = 0;  // the newest position on an arc, counted from 1
        for (std::size_t i = 0; i < samples.velocities.size(); ++i) {
            if (samples.is_on_arc[i]) last_arc = i + 1;
            if (i < window || (!excess.on_arcs && last_arc + window > i)) continue;
            const double change = samples.velocities[i][joint] - samples.velocities[i - window][joint];
            max = std::max(max, std::abs(change));
        }
        const double time_s = static_cast<double>(window) * kPeriod_s;
        // v^2 = a r with a turn by t about r = 8 d / t^2, for small t and less for others: the jump is v t.
        const double jump = limit * excess.step_s + std::sqrt(8 * limit * excess.deviation_mm);
        EXPECT_LE(max, (jump + limit * excess.acceleration * time_s) * (1 + kRounding))
            << "joint " << joint << " over " << time_s << " s";
    }
};

/// Expects that the times of the moves and the dwells add up to the cycle time, except for the controller's
/// time at its stops.
void expect_sums(const Samples& samples, const Report& report, double standstill_s) {
    const double rounding_s = 1e-6 + 1e-9 * report.cycle_time_s;
    EXPECT_NEAR(report.times.rapid_s + report.times.feed_s + report.times.dwell_s, report.cycle_time_s,
                rounding_s);
    EXPECT_LE(samples.moves_s, report.cycle_time_s + rounding_s);
    EXPECT_GE(samples.moves_s, report.cycle_time_s - kMoves * standstill_s - rounding_s);
}

TEST_P(JointLimitsOfController, HoldAtEachInstantAndOverWindows) {
    for (unsigned seed = 0; seed < kPrograms; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Simulator simulator(make_machine(random), {});
        Samples samples;
        simulator.add_output(samples);
        RandomMoves(random, simulator).make(kMoves);
        const Report report = simulator.finish("p");
        ASSERT_FALSE(report.alarm) << report.alarm->message;
        EXPECT_NEAR(samples.segments_s, report.cycle_time_s, 1e-6 + 1e-9 * report.cycle_time_s);
        expect_sums(samples, report, simulator.machine().controller.standstill.dwell_s);
        check_samples(samples, make_planner_setup(simulator.machine()));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Controllers, JointLimitsOfController,
    testing::Values(Excess{"exact-stop", 1, 0, 0, 1, false}, Excess{"ab9", 1, 0.01, 0, 1.866, true},
                    Excess{"blend", 1, 0.002, 0, 1.866, true}, Excess{"linuxcnc-2.9", 2, 0, 0, 2, true},
                    Excess{"grbl-1.1", 1, 0, 0.01, 5, true}, Excess{"grblhal", 1, 0, 0.01, 5, true}),
    [](const testing::TestParamInfo<Excess>& excess) {
        std::string name = excess.param.model;
        for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
        return name;
    });

}  // namespace
}  // namespace gsim::simulation::kept_limits_test
