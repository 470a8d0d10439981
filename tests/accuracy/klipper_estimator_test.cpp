// The estimator of Klipper's programs, against what its rules come to by hand.

#include "tests/accuracy/klipper_estimator.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::accuracy::klipper_estimator_test {
namespace {

machine::Machine router() {
    return machine::load_machine(tests::source_path("samples/machines/klipper-router.toml"))
        .value();  // 100 mm/s, 1000 mm/s2
}

ProgrammedMove line(double length_mm, double angle_deg = 0, double feed_mm_s = 100) {
    const double angle = angle_deg * std::numbers::pi / 180;
    const Eigen::Vector3d displacement(std::cos(angle), std::sin(angle), 0);
    return {.length_mm = length_mm,
            .length = length_mm,
            .feed_s = feed_mm_s,
            .speed_limit = 100,
            .acceleration = 1000,
            .enters = displacement,
            .leaves = displacement};
}

double time_s(const std::vector<ProgrammedMove>& moves) {
    return klipper_estimator_s(moves, router());
}

TEST(KlipperEstimator, LineIsTrapezoid) {
    EXPECT_NEAR(time_s({line(100)}), 1.1, 1e-12);
}

/// Each phase takes a third of the time: half of the acceleration is left out at the peak.
TEST(KlipperEstimator, ShortLineKeepsMinimumCruiseRatio) {
    EXPECT_NEAR(time_s({line(3)}), 3 * 0.0387298335, 1e-9);
}

TEST(KlipperEstimator, PassesRightAngleAtCornerSpeed) {
    // Each line: 95 mm/s up or down at 1000 mm/s2 on one side, 100 mm/s on the other.
    const double ramps_s = 0.1 + 0.095, ramps_mm = 5 + (100 * 100 - 25) / 2000.0;
    EXPECT_NEAR(time_s({line(100), line(100, 90)}), 2 * (ramps_s + (100 - ramps_mm) / 100), 1e-9);
}

TEST(KlipperEstimator, DwellDoesNotStopMotion) {
    EXPECT_NEAR(time_s({line(50), {.wait_s = 2}, line(50)}), 2 + 1.1, 1e-9);
}

/// Chords of 0.1 mm on 5 mm: sqrt(a r) but for the ramps.
TEST(KlipperEstimator, ArcsBecomeChords) {
    ProgrammedMove arc = line(10 * std::numbers::pi, 90);
    arc.radius_mm = 5;
    arc.sweep_rad = 2 * std::numbers::pi;
    const double speed = std::sqrt(1000 * 5.0);
    EXPECT_NEAR(time_s({arc}), arc.length / speed + speed / 1000, 0.02);
}

TEST(KlipperEstimator, ExtruderMoveBeginsAndEndsAtStandstill) {
    ProgrammedMove retract{.length = 2, .feed_s = 30, .speed_limit = 80, .acceleration = 800};
    EXPECT_NEAR(time_s({line(50), retract, line(50)}), 2 * 0.6 + 2.0 / 30 + 30.0 / 800, 1e-9);
}

}  // namespace
}  // namespace gsim::accuracy::klipper_estimator_test
