// Controllers and machines in samples/, compared with the values that they represent.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/os/input_file.h"
#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/support/machine_path.h"

namespace gsim::machine::controller_samples_test {
namespace {

using rrs::ControllerRules;
using rrs::CornerRule;
using rrs::LinuxcncRelease;
using rrs::PlannerKind;

Machine sample(const std::string& name) {
    return load_machine(tests::machine_path(name)).value();
}

TEST(BuiltInControllers, MatchSamples) {
    EXPECT_THAT(built_in_controllers(),
                testing::ElementsAre("exact-stop", "ab9", "linuxcnc-2.9", "linuxcnc-2.10", "grbl-1.1",
                                     "grblhal", "blend", "klipper"));
    for (const std::string_view name : built_in_controllers()) {
        const auto file =
            os::read_text_file(tests::source_path("samples/controllers/") + std::string(name) + ".toml");
        ASSERT_TRUE(file) << file.error().message;
        EXPECT_EQ(built_in_controller_toml(name), *file);
        EXPECT_EQ(built_in_controller(name).value().model, name);
    }
    EXPECT_EQ(built_in_controller("grbl"), std::nullopt);
    EXPECT_EQ(built_in_controller(""), std::nullopt);
    EXPECT_EQ(built_in_controller_toml("grbl").data(), nullptr);
}

TEST(BuiltInControllers, ExactStopEqualsDefaultRules) {
    EXPECT_EQ(built_in_controller("exact-stop").value(), ControllerRules{});
}

TEST(BuiltInControllers, Ab9StopsOnlyInExactPathMode) {
    const ControllerRules rules = built_in_controller("ab9").value();
    EXPECT_EQ(rules.planner, PlannerKind::look_ahead);
    EXPECT_EQ(rules.blocks.look_ahead, 40u);
    EXPECT_EQ(rules.corners.continuous, CornerRule::velocity_step);
    EXPECT_EQ(rules.corners.exact_path, CornerRule::stop);
    EXPECT_TRUE(rules.corners.stop_between_rapid_and_feed);
    EXPECT_NEAR(rules.ramps.centripetal_share, std::sqrt(0.75), 1e-4);  // half of the limit is left
    EXPECT_EQ(rules.position_loop.settle_s, 0);
}

TEST(BuiltInControllers, LinuxcncUsesServoCycles) {
    const ControllerRules rules = built_in_controller("linuxcnc-2.9").value();
    EXPECT_EQ(rules.planner, PlannerKind::linuxcnc);
    EXPECT_EQ(rules.blocks.look_ahead, 50u);
    EXPECT_EQ(rules.position_loop.servo_period_s, 0.001);
    EXPECT_EQ(rules.standstill.dwell_s, 0.0035);
    EXPECT_TRUE(rules.corners.stop_between_rapid_and_feed);
    EXPECT_EQ(rules.linuxcnc.release, LinuxcncRelease::v2_9);
}

TEST(BuiltInControllers, GrblHasChordsAndJunctionDeviation) {
    const ControllerRules rules = built_in_controller("grbl-1.1").value();
    EXPECT_EQ(rules.planner, PlannerKind::look_ahead);
    EXPECT_EQ(rules.blocks.look_ahead, 15u);
    EXPECT_EQ(rules.corners.continuous, CornerRule::junction_deviation);
    EXPECT_EQ(rules.corners.exact_path, CornerRule::junction_deviation);
    EXPECT_EQ(rules.corners.junction_deviation_mm, 0.01);
    EXPECT_FALSE(rules.corners.stop_between_rapid_and_feed);
    EXPECT_EQ(rules.ramps.centripetal_share, std::numeric_limits<double>::infinity());
    EXPECT_EQ(rules.curves.arc_chord_tolerance_mm, 0.002);
    EXPECT_TRUE(rules.curves.inverse_time_per_chord);
    EXPECT_EQ(rules.blocks.min_feed_mm_min, 1);
    EXPECT_EQ(rules.standstill.dwell_step_s, 0.05);
    EXPECT_EQ(rules.standstill.dwell_s, 0);
}

TEST(BuiltInControllers, GrblHalHasLongerLookAheadAndMeasuresAllAxes) {
    const ControllerRules rules = built_in_controller("grblhal").value();
    EXPECT_EQ(rules.blocks.look_ahead, 100u);
    EXPECT_EQ(rules.corners.continuous, CornerRule::junction_deviation);
    EXPECT_EQ(rules.blocks.path_measure, rrs::PathMeasure::all_axes);
    EXPECT_EQ(rules.blocks.feed_measure, rrs::PathMeasure::all_axes);
    EXPECT_EQ(rules.curves.spline_chord_tolerance_mm, 0.1);
    EXPECT_EQ(rules.ramps.step_s, 0.01);
    EXPECT_FALSE(rules.ramps.limit_jerk);
    EXPECT_EQ(rules.drilling.peck_dwell_s, 0.25);
    EXPECT_TRUE(rules.drilling.pecks_feed_down);
    EXPECT_FALSE(rules.drilling.boring_cycles);
}

TEST(BuiltInControllers, BlendRoundsCornersAndLimitsJerk) {
    const ControllerRules rules = built_in_controller("blend").value();
    EXPECT_EQ(rules.corners.continuous, CornerRule::smooth_blend);
    EXPECT_EQ(rules.corners.exact_path, CornerRule::velocity_step);
    EXPECT_TRUE(rules.ramps.limit_jerk);
    EXPECT_EQ(rules.corners.blend_tolerance_mm, 0.05);
    EXPECT_EQ(rules.position_loop.gain_1_s, 33.3);
}

TEST(BuiltInControllers, KlipperHasDefaultsAndNoOverrides) {
    const ControllerRules rules = built_in_controller("klipper").value();
    EXPECT_EQ(rules.planner, PlannerKind::klipper);
    EXPECT_EQ(rules.klipper.square_corner_velocity_mm_s, 5);
    EXPECT_EQ(rules.klipper.minimum_cruise_ratio, 0.5);
    EXPECT_EQ(rules.klipper.arc_resolution_mm, 1);
    EXPECT_EQ(rules.retraction.length_mm, 0);
    EXPECT_FALSE(rules.corners.stop_between_rapid_and_feed);
    EXPECT_EQ(rules.overrides.feed_min_percent, 100);
    EXPECT_EQ(rules.overrides.feed_max_percent, 100);
}
constexpr double kNoJerk = std::numeric_limits<double>::infinity();

struct Linuxcnc {
    const char* file;
    double path_mm_s, speed_mm_s, acceleration_mm_s2, acceleration_deg_s2;
    const char* model = "linuxcnc-2.9";
    double jerk_mm_s3 = kNoJerk, jerk_deg_s3 = kNoJerk;
};

class LinuxcncSample : public testing::TestWithParam<Linuxcnc> {};

TEST_P(LinuxcncSample, HasLimitsOfConfiguration) {
    const Machine machine = sample(GetParam().file);
    ControllerRules rules = built_in_controller(GetParam().model).value();
    rules.ramps.limit_jerk = std::isfinite(GetParam().jerk_mm_s3);
    EXPECT_EQ(machine.controller, rules);
    EXPECT_EQ(machine.path.max_jerk_mm_s3, GetParam().jerk_mm_s3);
    EXPECT_EQ(machine.inverse, InverseKind::none);
    EXPECT_EQ(machine.path.max_feed_mm_s, GetParam().path_mm_s);
    EXPECT_EQ(machine.path.max_rapid_mm_s, GetParam().path_mm_s);
    EXPECT_EQ(machine.path.max_acceleration_mm_s2, std::numeric_limits<double>::infinity());
    std::string letters;
    for (const Axis& axis : machine.axes) {
        letters += axis.letter;
        const bool rotary = axis.letter == 'B' || axis.letter == 'C';
        EXPECT_EQ(axis.kind, rotary ? AxisKind::rotary : AxisKind::linear);
        EXPECT_EQ(axis.max, rotary ? 36000 : 10000);
        EXPECT_EQ(axis.min, -axis.max);
        EXPECT_EQ(axis.max_speed, rotary ? 90 : GetParam().speed_mm_s);
        EXPECT_EQ(axis.max_acceleration,
                  rotary ? GetParam().acceleration_deg_s2 : GetParam().acceleration_mm_s2);
        EXPECT_EQ(axis.max_jerk, rotary ? GetParam().jerk_deg_s3 : GetParam().jerk_mm_s3);
    }
    EXPECT_EQ(letters, "XYZBC");
}

INSTANTIATE_TEST_SUITE_P(
    All, LinuxcncSample,
    testing::Values(
        Linuxcnc{"linuxcnc-gantry.toml", 2000, 508, 490.3, 20},
        Linuxcnc{"linuxcnc-gantry254.toml", 254, 508, 490.3, 20},
        Linuxcnc{"linuxcnc-router.toml", 1000, 100, 1000, 200},
        Linuxcnc{"linuxcnc-2.10-gantry-pt0.toml", 2000, 508, 490.3, 20, "linuxcnc-2.10"},
        Linuxcnc{"linuxcnc-2.10-gantry-pt1-j5000.toml", 2000, 508, 490.3, 20, "linuxcnc-2.10", 5000, 200},
        Linuxcnc{"linuxcnc-2.10-gantry-pt1-j20000.toml", 2000, 508, 490.3, 20, "linuxcnc-2.10", 20000, 200},
        Linuxcnc{"linuxcnc-2.10-router-pt0.toml", 1000, 100, 1000, 200, "linuxcnc-2.10"},
        Linuxcnc{"linuxcnc-2.10-router-pt1-j5000.toml", 1000, 100, 1000, 200, "linuxcnc-2.10", 5000, 2000},
        Linuxcnc{"linuxcnc-2.10-router-pt1-j20000.toml", 1000, 100, 1000, 200, "linuxcnc-2.10", 20000, 2000},
        Linuxcnc{"linuxcnc-2.10-router-pt1-jdef.toml", 1000, 100, 1000, 200, "linuxcnc-2.10", 1e9, 2000}),
    [](const auto& tested) {
        std::string name = tested.param.file;
        name = name.substr(9, name.rfind('.') - 9);
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
        return name;
    });

struct Grbl {
    const char* file;
    double speed_mm_min, acceleration_mm_s2, steps_per_mm;
};

class GrblSample : public testing::TestWithParam<Grbl> {};

TEST_P(GrblSample, HasLimitsOfSettings) {
    const Machine machine = sample(GetParam().file);
    EXPECT_EQ(machine.controller, built_in_controller("grbl-1.1").value());
    EXPECT_EQ(machine.path, PathLimits{});
    std::string letters;
    for (const Axis& axis : machine.axes) {
        letters += axis.letter;
        EXPECT_EQ(axis.kind, AxisKind::linear);
        EXPECT_EQ(axis.max, 10000);
        EXPECT_EQ(axis.min, -axis.max);
        EXPECT_DOUBLE_EQ(axis.max_speed, GetParam().speed_mm_min / 60);
        EXPECT_EQ(axis.max_acceleration, GetParam().acceleration_mm_s2);
        EXPECT_DOUBLE_EQ(axis.step, 1 / GetParam().steps_per_mm);
    }
    EXPECT_EQ(letters, "XYZ");
}

INSTANTIATE_TEST_SUITE_P(All, GrblSample,
                         testing::Values(Grbl{"grbl-router.toml", 6000, 1000, 250},
                                         Grbl{"grbl-gantry3.toml", 30480, 490.3, 80}),
                         [](const auto& tested) {
                             const std::string name = tested.param.file;
                             return name.substr(5, name.find('.') - 5);
                         });

struct Klipper {
    const char* file;
    double speed_mm_s, acceleration_mm_s2, corner_mm_s, cruise_ratio, z_mm_s, z_mm_s2, resolution_mm;
};

class KlipperSample : public testing::TestWithParam<Klipper> {};

TEST_P(KlipperSample, HasLimitsOfConfiguration) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    const Klipper& expected_value = GetParam();
    const Machine machine = sample(expected_value.file);
    const ControllerRules& rules = machine.controller;
    EXPECT_EQ(rules.planner, PlannerKind::klipper);
    EXPECT_EQ(rules.klipper.square_corner_velocity_mm_s, expected_value.corner_mm_s);
    EXPECT_EQ(rules.klipper.minimum_cruise_ratio, expected_value.cruise_ratio);
    EXPECT_EQ(rules.klipper.arc_resolution_mm, expected_value.resolution_mm);
    EXPECT_EQ(machine.path.max_feed_mm_s, expected_value.speed_mm_s);
    EXPECT_EQ(machine.path.max_acceleration_mm_s2, expected_value.acceleration_mm_s2);
    for (const Axis& axis : machine.axes) {
        EXPECT_EQ(axis.kind, AxisKind::linear);
        if (axis.letter == 'E') continue;
        const bool is_z = axis.letter == 'Z';
        EXPECT_EQ(axis.max_speed, is_z ? expected_value.z_mm_s : kUnlimited);
        EXPECT_EQ(axis.max_acceleration, is_z ? expected_value.z_mm_s2 : kUnlimited);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, KlipperSample,
    testing::Values(Klipper{"klipper-router.toml", 100, 1000, 5, 0.5, 20, 200, 0.1},
                    Klipper{"klipper-router-arc1.toml", 100, 1000, 5, 0.5, 20, 200, 1},
                    Klipper{"klipper-fast.toml", 300, 3000, 5, 0.5, INFINITY, INFINITY, 0.1},
                    Klipper{"klipper-fast-arc1.toml", 300, 3000, 5, 0.5, INFINITY, INFINITY, 1},
                    Klipper{"klipper-fast-mcr0.toml", 300, 3000, 20, 0, INFINITY, INFINITY, 0.1},
                    Klipper{"klipper-fast-mcr0-arc1.toml", 300, 3000, 20, 0, INFINITY, INFINITY, 1},
                    Klipper{"klipper-fast-noarcs.toml", 300, 3000, 5, 0.5, INFINITY, INFINITY, 0},
                    Klipper{"klipper-fast-ext.toml", 300, 3000, 5, 0.5, 15, 100, 0.1},
                    Klipper{"klipper-fast-ext-fw.toml", 300, 3000, 5, 0.5, 15, 100, 0.1}),
    [](const auto& tested) {
        std::string name = tested.param.file;
        name = name.substr(8, name.find('.') - 8);
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

// By default an extruder alone moves as fast as filament of its nozzle's largest cross section lets the path
// move.
TEST(KlipperSamples, ExtruderHasDefaultsOfNozzle) {
    for (const char* name : {"klipper-fast-ext.toml", "klipper-fast-ext-fw.toml"}) {
        const Machine machine = sample(name);
        const Axis& extruder = machine.axes.at(3);
        EXPECT_EQ(extruder.letter, 'E');
        const double nozzle_mm = 0.4, filament_mm = 1.75;
        const double share = 4 * nozzle_mm * nozzle_mm / (std::numbers::pi * filament_mm * filament_mm / 4);
        EXPECT_NEAR(extruder.max_speed, 300 * share, 1e-6);
        EXPECT_NEAR(extruder.max_acceleration, 3000 * share, 1e-5);
        EXPECT_EQ(extruder.max_speed_step, 1);
    }
    const ControllerRules rules = sample("klipper-fast-ext-fw.toml").controller;
    EXPECT_EQ(rules.retraction.length_mm, 0.8);
    EXPECT_EQ(rules.retraction.speed_mm_s, 35);
    EXPECT_EQ(rules.retraction.unretract_speed_mm_s, 35);
    EXPECT_EQ(rules.retraction.unretract_extra_length_mm, 0);
}

}  // namespace
}  // namespace gsim::machine::controller_samples_test
