// Uncertainty of a cycle time, against closed forms.
#include "runtime/monitors/confidence_interval_monitor.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "machine/file/machine_file.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation::interval_watch_test {
namespace {

using testing::HasSubstr;

constexpr double kSpreads = 1.959964;

std::string machine_text(double acceleration_percent2, double residual_percent) {
    return "[machine]\nname = \"m\"\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndirection = \"x\"\n"
           "max_speed_mm_s = 100\nmax_acceleration_mm_s2 = 500\n[calibration]\nruns = 9\nresidual_percent "
           "= " +
           std::to_string(residual_percent) +
           "\n[[calibrated]]\nof = \"X\"\nkey = \"max_acceleration_mm_s2\"\ncovariance_percent2 = [" +
           std::to_string(acceleration_percent2) + "]\n";
}

/// 300 mm at 100 mm/s: 3 s and v / a = 0.2 s.
Report run(const std::string& machine, double dwell_s = 0, bool turned = false) {
    Simulator simulator(machine::read_machine(machine, "m.toml").value(), RunLimits{});
    simulator.program().files().add("part.nc");
    if (turned) simulator.motion().set_overrides(motion::OverrideSchedule({{0, {.rapid = 0.5}}}));
    LineMove move{
        .kind = MoveKind::rapid, .target = simulator.position().axes(), .feed = {}, .location = {0, 1}};
    move.target[0] = 300;
    EXPECT_TRUE(simulator.moves().enqueue(move));
    EXPECT_TRUE(simulator.dwells().enqueue(dwell_s, {0, 2}));
    return simulator.finish("part.nc");
}

TEST(ConfidenceIntervalMonitor, SpreadOfAccelerationGivesSpreadOfTime) {
    const Report report = run(machine_text(100, 0));
    ASSERT_TRUE(report.times.interval);
    EXPECT_NEAR(report.cycle_time_s, 3.2, 1e-9);
    // d log T / d log a = -(v / a) / T; the difference is over 1 %.
    const double log_half_width = kSpreads * 0.1 * 0.2 / 3.2;
    EXPECT_NEAR(std::log(report.times.interval->max_s / 3.2), log_half_width, 0.01 * log_half_width);
    EXPECT_NEAR(std::log(report.times.interval->min_s / 3.2), -log_half_width, 0.01 * log_half_width);
}

TEST(ConfidenceIntervalMonitor, AddsResidualInQuadrature) {
    const Report report = run(machine_text(100, 1));
    ASSERT_TRUE(report.times.interval);
    const double log_half_width = kSpreads * std::hypot(0.1 * 0.2 / 3.2, 0.01);
    EXPECT_NEAR(std::log(report.times.interval->max_s / 3.2), log_half_width, 0.01 * log_half_width);
}

TEST(ConfidenceIntervalMonitor, DwellHasNoUncertainty) {
    const Report report = run(machine_text(100, 0), 10);
    ASSERT_TRUE(report.times.interval);
    EXPECT_NEAR(report.times.interval->max_s - 13.2, kSpreads * 0.1 * 0.2, 5e-4);
}

TEST(ConfidenceIntervalMonitor, IsWrittenInReport) {
    const Report report = run(machine_text(100, 0));
    EXPECT_THAT(to_text(report), HasSubstr("cycle time  3.200 s  (0:00:03), 3.161 to 3.240 s (95 %)"));
    EXPECT_THAT(to_json(report), HasSubstr("\"cycle_time_95_s\": ["));
}

TEST(ConfidenceIntervalMonitor, WarnsIfOverridesPreventInterval) {
    const Report report = run(machine_text(100, 0), 0, true);
    EXPECT_FALSE(report.times.interval);
    EXPECT_THAT(report.messages.warnings, testing::Contains(HasSubstr("no interval: overrides are changed")));
}

TEST(ConfidenceIntervalMonitor, UncalibratedMachineHasNoInterval) {
    std::string text = machine_text(100, 0);
    text.resize(text.find("[calibration]"));
    const Report report = run(text);
    EXPECT_FALSE(report.times.interval);
    EXPECT_TRUE(report.messages.warnings.empty());
    EXPECT_THAT(to_json(report), testing::Not(HasSubstr("cycle_time_95_s")));
}

}  // namespace
}  // namespace gsim::simulation::interval_watch_test
