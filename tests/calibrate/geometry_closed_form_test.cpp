// Geometry in closed form: the fit finds the values that were put in.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/geometry/compensation.h"
#include "calibrate/geometry/geometry_output.h"
#include "calibrate/geometry/pose_selection.h"
#include "calibrate/geometry/simulated_tcps.h"
#include "calibrate/geometry/squareness.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::calibrate::geometry_closed_form_test {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kDeg = std::numbers::pi / 180;

std::string linear_axis(char letter) {
    return fmt::format(
        "[[axis]]\nletter = \"{}\"\nkind = \"linear\"\nmin_mm = -200.0\nmax_mm = 300.0\nmax_speed_mm_s = "
        "100.0\n"
        "direction = \"{}\"\n",
        letter, static_cast<char>(letter + ('x' - 'X')));
}

machine::Machine gantry(const std::string& more = "") {
    return machine::read_machine("[machine]\nname = \"gantry\"\ninverse = \"gantry\"\n" + linear_axis('X') +
                                     linear_axis('Y') + linear_axis('Z') + more,
                                 "gantry.toml")
        .value();
}

machine::Machine with_table() {
    return gantry("[[axis]]\nletter = \"C\"\nkind = \"rotary\"\ncarries = \"work\"\ndirection = \"z\"\n");
}

machine::Machine sample(const std::string& name) {
    return machine::load_machine(tests::source_path("samples/machines/") + name + ".toml").value();
}

/// Returns TCPs of a formula at poses spread over a machine's ranges.
template <class Formula>
std::vector<MeasuredTcp> tips_of(const machine::Machine& machine, Formula formula) {
    std::vector<MeasuredTcp> tcps = spread_poses(machine, 1, 30, false);
    for (MeasuredTcp& tcp : tcps) tcp.tcp.translation() = formula(tcp.readings);
    return tcps;
}

double value_of(const GeometryFit& fit, const std::string& name) {
    for (const FittedDeviation& found : fit.found)
        if (found.deviation.name == name) return found.value;
    ADD_FAILURE() << name << " was not found";
    return 0;
}

std::string fixed_reason(const GeometryFit& fit, const std::string& name) {
    for (const FixedDeviation& fixed : fit.fixed)
        if (fixed.name == name) return fixed.reason;
    return "it is not held";
}

GeometryFit fitted(const machine::Machine& machine, const std::vector<MeasuredTcp>& tcps,
                   const GeometryOptions& options = {}) {
    return fit_geometry(machine, tcps, options).value();
}

// Y is tilted towards X by 0.4 mrad, Z away from Y by 0.3 mrad; X moves 100 ppm too far.
TEST(GeometryClosedForm, FindsSquarenessErrorsOfGantry) {
    const double tilt_rad = 4e-4, back = 3e-4;
    const auto tcps = tips_of(gantry(), [&](const std::vector<double>& axes) -> Vector3d {
        return axes[0] * 1.0001 * Vector3d::UnitX() +
               axes[1] * Vector3d(std::sin(tilt_rad), std::cos(tilt_rad), 0) +
               axes[2] * Vector3d(0, -std::sin(back), std::cos(back));
    });
    const GeometryFit fit = fitted(gantry(), tcps);
    EXPECT_LT(summarize_errors(fit.after).max_um, 1e-3);
    EXPECT_NEAR(value_of(fit, "Y tilt_z_deg"), -tilt_rad / kDeg, 1e-7);
    EXPECT_NEAR(value_of(fit, "Z tilt_x_deg"), back / kDeg, 1e-7);
    EXPECT_NEAR(value_of(fit, "X scale_ppm"), 100, 1e-3);
    EXPECT_NEAR(value_of(fit, "base turn_z_deg"), 0, 1e-7);
    const auto square = compute_squareness(gantry(), fit);
    ASSERT_EQ(square.size(), 3U);  // X Y, X Z, Y Z
    EXPECT_NEAR(square[0].value_um_m, 1e6 * std::sin(tilt_rad), 1e-2);
    EXPECT_NEAR(square[1].value_um_m, 0, 1e-2);
    EXPECT_NEAR(square[2].value_um_m, -1e6 * std::sin(back) * std::cos(tilt_rad), 1e-2);
    EXPECT_EQ(fixed_reason(fit, "tool x_mm"), "is redundant: -X zero_mm has the same effect");
    EXPECT_EQ(fixed_reason(fit, "tool turn_x_deg"), "moves no measured TCP position");
}

// The table turns about (c, d): a point p is at R (p - c) + c of it.
TEST(GeometryClosedForm, FindsOffsetOfTableAxis) {
    const Vector3d centre(0.12, -0.07, 0);
    const auto tcps = tips_of(with_table(), [&](const std::vector<double>& axes) -> Vector3d {
        const Vector3d position(axes[0], axes[1], axes[2]);
        return Eigen::AngleAxisd(axes[3] * kDeg, Vector3d::UnitZ()) * (position - centre) + centre;
    });
    const GeometryFit fit = fitted(with_table(), tcps);
    EXPECT_LT(summarize_errors(fit.after).max_um, 1e-3);
    EXPECT_NEAR(value_of(fit, "C shift_x_mm"), 0.12, 1e-6);
    EXPECT_NEAR(value_of(fit, "C shift_y_mm"), -0.07, 1e-6);
    EXPECT_NEAR(value_of(fit, "X zero_mm"), 0, 1e-6);
    EXPECT_NEAR(value_of(fit, "C tilt_x_deg"), 0, 1e-7);
    // The file states it as the position of the axis, and of the work frame back from there.
    const auto read = machine::read_machine(geometry_text(fit).value(), "fitted.toml").value();
    EXPECT_NEAR(read.axes[3].frame->x_mm, 0.12, 1e-6);
    EXPECT_NEAR(read.work.x_mm, -0.12, 1e-6);
    EXPECT_NEAR(read.work.y_mm, 0.07, 1e-6);
}

// Programs read the written file: its TCPs are those of the fit, however joints are defined.
TEST(GeometryClosedForm, WrittenFileReproducesFittedTcps) {
    for (const char* name : {"arm6", "af5", "mill-table-table", "gantry-offset-head"}) {
        const machine::Machine machine = sample(name);
        const auto poses = suggest_poses(machine, 40, true, {{}, {"scale"}}).value();
        const auto ground_truth = make_ground_truth(machine, poses, {{}, {"scale"}}, 3);
        const GeometryFit fit =
            fitted(machine, simulated_tcps(ground_truth.geometry, poses, {0.002, 0.001}, 4),
                   {.deviation_options = {{}, {"scale"}}, .noise_mm = {}, .noise_deg = {}});
        const auto read = machine::read_machine(geometry_text(fit).value(), "fitted.toml");
        ASSERT_TRUE(read) << name << ": " << read.error().message;
        const auto kinematics = machine::make_kinematics(*read);
        const TcpCalculator calculator(fit.geometry);
        for (const MeasuredTcp& pose : poses) {
            rrs::JointPos joints(static_cast<Eigen::Index>(read->axes.size()));
            for (std::size_t i = 0; i < read->axes.size(); ++i)
                joints[static_cast<Eigen::Index>(i)] = machine::joint_value(read->axes[i], pose.readings[i]);
            const rrs::CartPos apart = kinematics->forward(joints).inverse() * calculator.tcp(pose.readings);
            EXPECT_LT(apart.translation().norm(), 1e-9) << name;
            EXPECT_TRUE(apart.linear().isIdentity(1e-12)) << name;
        }
    }
}

// Points do not show how the tool is turned: poses of the file can still be reached if slides are found to
// lie askew.
TEST(GeometryClosedForm, KeepsToolDirectionIfOnlyPointsAreMeasured) {
    const Eigen::Matrix3d askew = Eigen::AngleAxisd(6e-4, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const auto tcps = tips_of(gantry(), [&](const std::vector<double>& axes) -> Vector3d {
        return askew * Vector3d(axes[0], axes[1], axes[2]);
    });
    const GeometryFit fit = fitted(gantry(), tcps);
    EXPECT_LT(summarize_errors(fit.after).max_um, 1e-3);
    const auto kinematics = machine::make_kinematics(fit.geometry.machine);
    rrs::CartPos pose = rrs::CartPos::Identity();
    pose.translation() = Vector3d(10, 20, -30);
    const auto joints = kinematics->inverse(pose, rrs::JointPos::Zero(3));
    ASSERT_TRUE(joints) << joints.error();
    EXPECT_TRUE(kinematics->forward(*joints).isApprox(pose, 1e-9));
}

// One joint's line moves, and no other part does while all joints are at zero.
TEST(GeometryClosedForm, AxisDeviationKeepsTcpAtZeroJoints) {
    for (const char* name : {"arm6", "af5", "mill-table-table", "mill-head-table", "unlimited"}) {
        const machine::Machine machine = sample(name);
        const DeviatedMachine deviated({.machine = machine, .scales = {}});
        std::vector<double> at_zero;
        for (const machine::Axis& axis : machine.axes) at_zero.push_back(axis.zero);
        const rrs::CartPos before = TcpCalculator(deviated.nominal()).tcp(at_zero);
        for (const Deviation& deviation : all_deviations(machine, {})) {
            if (deviation.kind != Deviation::Kind::tilt && deviation.kind != Deviation::Kind::shift) continue;
            const std::vector<Deviation> one{deviation};
            const TcpCalculator calculator(deviated.at(one, Eigen::VectorXd::Constant(1, 0.3)));
            EXPECT_TRUE(calculator.tcp(at_zero).isApprox(before, 1e-12)) << name << ", " << deviation.name;
        }
    }
}

TEST(GeometryClosedForm, EstimatesNoiseAndMarksOutliers) {
    const machine::Machine machine = with_table();
    const auto poses = suggest_poses(machine, 60, false, {}).value();
    const auto ground_truth = make_ground_truth(machine, poses, {}, 5);
    auto tcps = simulated_tcps(ground_truth.geometry, poses, {.mm = 0.008, .deg = 0}, 6);
    tcps[17].tcp.translation().y() += 1.5;
    const GeometryFit fit = fitted(machine, tcps);
    EXPECT_TRUE(fit.noise_is_estimated);
    EXPECT_NEAR(fit.noise.mm, 0.008, 0.0015);
    EXPECT_TRUE(fit.outliers[17]);
    EXPECT_EQ(std::count(fit.outliers.begin(), fit.outliers.end(), true), 1);
    for (std::size_t i = 0; i < fit.found.size(); ++i) {
        EXPECT_EQ(fit.found[i].deviation.name, ground_truth.deviations[i].name);
        EXPECT_NEAR(fit.found[i].value, ground_truth.values[static_cast<Eigen::Index>(i)],
                    4 * fit.found[i].standard_deviation)
            << fit.found[i].deviation.name;
    }
}

// X curves by a tenth of a millimetre, which no straight slide does; turns are given without their noise.
TEST(GeometryClosedForm, ReportsResidualAboveNoise) {
    const machine::Machine machine = with_table();
    const auto poses = suggest_poses(machine, 40, true, {}).value();
    const Geometry file{.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)};
    auto tcps = simulated_tcps(file, poses, {.mm = 0.005, .deg = 0.002}, 12);
    const GeometryOptions options{.deviation_options = {}, .noise_mm = 0.005, .noise_deg = {}};
    const GeometryFit straight = fitted(machine, tcps, options);
    EXPECT_FALSE(straight.noise_is_estimated);
    EXPECT_NEAR(straight.noise.deg, 0.002, 0.0005);
    EXPECT_NEAR(straight.residual_noise_ratio, 1, 0.2);
    EXPECT_THAT(geometry_table(straight, {}), Not(HasSubstr("the residual exceeds the noise")));
    for (MeasuredTcp& tcp : tcps) {
        const double x = tcp.readings[0] / 250;
        const Vector3d bent(0, 0.1 * x * x, 0);
        tcp.tcp.translation() += Eigen::AngleAxisd(tcp.readings[3] * kDeg, Vector3d::UnitZ()) * bent;
    }
    const GeometryFit bent = fitted(machine, tcps, options);
    EXPECT_GT(bent.residual_noise_ratio, 1.5);
    EXPECT_THAT(geometry_table(bent, {}), HasSubstr("the residual exceeds the noise"));
}

TEST(GeometryClosedForm, FindsDeviationsInAnyInstrumentFrame) {
    const machine::Machine machine = with_table();
    const auto poses = suggest_poses(machine, 40, false, {.instrument_frame = true, .fixed = {}}).value();
    const auto ground_truth = make_ground_truth(machine, poses, {.instrument_frame = true, .fixed = {}}, 8);
    Geometry seen = ground_truth.geometry;
    seen.instrument =
        Eigen::Translation3d(900, -2000, 400) * Eigen::AngleAxisd(2, Vector3d(1, 2, 3).normalized());
    const GeometryOptions options{
        .deviation_options = {.instrument_frame = true, .fixed = {}}, .noise_mm = 0.005, .noise_deg = {}};
    const auto exact = fitted(machine, simulated_tcps(seen, poses, {.mm = 0, .deg = 0}, 9), options);
    EXPECT_LT(summarize_errors(exact.after).rms_um, 0.01);
    const auto tcps = simulated_tcps(seen, poses, {.mm = 0.005, .deg = 0}, 9);
    const GeometryFit fit = fitted(machine, tcps, options);
    // The best fit is no worse than the truth.
    EXPECT_LE(summarize_errors(fit.after).rms_um, summarize_errors(tcp_errors(seen, tcps)).rms_um);
    for (std::size_t i = 0; i < fit.found.size(); ++i) {
        if (fit.found[i].deviation.kind == Deviation::Kind::instrument) continue;
        EXPECT_NEAR(fit.found[i].value, ground_truth.values[static_cast<Eigen::Index>(i)],
                    4 * fit.found[i].standard_deviation)
            << fit.found[i].deviation.name;
    }
}

TEST(GeometryClosedForm, FixedDeviationsStayFixed) {
    const auto tcps = tips_of(gantry(), [](const std::vector<double>& axes) -> Vector3d {
        return Vector3d(axes[0] + 0.1, axes[1], axes[2]);
    });
    const GeometryFit fit =
        fitted(gantry(), tcps,
               {.deviation_options = {.instrument_frame = false, .fixed = {"scale", "X zero", "tilt"}}});
    EXPECT_NEAR(value_of(fit, "tool x_mm"), 0.1, 1e-6);
    for (const FittedDeviation& found : fit.found)
        EXPECT_THAT(found.deviation.name, Not(testing::AnyOf(HasSubstr("scale"), HasSubstr("tilt"))));
    EXPECT_EQ(
        find_unknown_fixed(gantry(), {.instrument_frame = false, .fixed = {"scale", "tool z", "tilts"}}),
        "tilts");
    EXPECT_EQ(find_unknown_fixed(gantry(), {.instrument_frame = false, .fixed = {"X", "instrument"}}),
              "instrument");
    EXPECT_EQ(find_unknown_fixed(gantry(), {.instrument_frame = true, .fixed = {"X", "instrument"}}),
              std::nullopt);
    const auto none = fit_geometry(gantry(), {}, {});
    EXPECT_EQ(none.error().message, "there are no measured TCP positions");
    const std::vector<MeasuredTcp> one(tcps.begin(), tcps.begin() + 1);
    EXPECT_EQ(fit_geometry(gantry(), one, {}).error().message,
              "these TCP positions do not determine the machine's geometry: there are too few, or all "
              "deviations are fixed");
}

// With the table LinuxCNC sends the motor to nominal + (nominal - forward). The axis is then where it should
// be, to the square of the scale's error.
TEST(GeometryClosedForm, CompensationTableCorrectsScale) {
    const auto tcps = tips_of(gantry(), [](const std::vector<double>& axes) -> Vector3d {
        return Vector3d(axes[0] * 1.0002, axes[1], axes[2]);
    });
    const auto tables = compensation_tables(fitted(gantry(), tcps), tcps);
    ASSERT_EQ(tables.size(), 3U);
    EXPECT_EQ(tables[0].letter, 'X');
    double nominal = 0, forward = 0, reverse = 0, last = -1e9;
    std::istringstream lines(tables[0].text);
    int count = 0;
    for (; lines >> nominal >> forward >> reverse; ++count) {
        EXPECT_GT(nominal, last);
        EXPECT_EQ(forward, reverse);
        EXPECT_NEAR((nominal + (nominal - forward)) * 1.0002, nominal, 300 * 0.0002 * 0.0002 + 2e-6);
        last = nominal;
    }
    EXPECT_GE(count, 2);
    EXPECT_EQ(last, 300);
}

// The TCP is at the work frame's origin if the readings are those of the line.
TEST(GeometryClosedForm, WritesWorkOffsetOfFittedFrame) {
    const auto tcps = tips_of(gantry(), [](const std::vector<double>& axes) -> Vector3d {
        return Vector3d(axes[0] - 0.25, axes[1] + 0.5, axes[2] - 0.125);
    });
    EXPECT_EQ(work_offset_line(gantry(), fitted(gantry(), tcps)).value(),
              "G21\nG10 L2 P1 X0.2500 Y-0.5000 Z0.1250\n");
    const machine::Machine arm = sample("arm6");
    const auto poses = suggest_poses(arm, 30, true, {}).value();
    EXPECT_EQ(
        work_offset_line(arm, fitted(arm, poses)).error().message,
        "a work offset (--g10) requires three linear axes that move the TCP to the origin of the work frame");
}

// D-optimal: the deviations' ellipsoid is smaller than that of as many poses that are spread evenly.
TEST(GeometryClosedForm, SuggestedPosesDetermineMoreThanSpreadPoses) {
    for (const char* name : {"mill-head-table", "arm6"}) {
        const machine::Machine machine = sample(name);
        const auto log_volume = [&](const std::vector<MeasuredTcp>& poses) {
            const Geometry file{.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)};
            const GeometryFit fit = fitted(machine, simulated_tcps(file, poses, {.mm = 0, .deg = 0}, 1),
                                           {.deviation_options = {}, .noise_mm = 0.005, .noise_deg = 0.001});
            const Eigen::VectorXd sizes =
                Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(fit.covariance).eigenvalues();
            return std::pair(fit.found.size(), sizes.array().log().sum());
        };
        const auto suggested_count = suggest_poses(machine, 40, true, {}).value();
        const auto [count, best] = log_volume(suggested_count);
        const auto [same, uniform] = log_volume(spread_poses(machine, 1, 40, true));
        EXPECT_EQ(count, same);
        // For an arm, evenly spread poses show nearly as much already.
        EXPECT_LT(best, uniform - 0.1 * static_cast<double>(count)) << "a tenth less of each one's variance";
        for (const MeasuredTcp& pose : suggested_count) {
            for (std::size_t i = 0; i < machine.axes.size(); ++i) {
                EXPECT_GE(pose.readings[i], machine.axes[i].min);
                EXPECT_LE(pose.readings[i], machine.axes[i].max);
            }
        }
    }
    EXPECT_EQ(suggest_poses(gantry(), 3, false, {}).error().message,
              "12 deviations of this machine can be determined, which requires at least 5 poses");
}

TEST(GeometryClosedForm, WritesTableJsonAndSvg) {
    const machine::Machine machine = with_table();
    const auto poses = suggest_poses(machine, 30, false, {}).value();
    const auto ground_truth = make_ground_truth(machine, poses, {}, 5);
    const GeometryFit fit =
        fitted(machine, simulated_tcps(ground_truth.geometry, poses, {.mm = 0.005, .deg = 0}, 6));
    const auto square = compute_squareness(machine, fit);
    EXPECT_THAT(geometry_table(fit, square),
                testing::AllOf(HasSubstr("C shift_x_mm"), HasSubstr("square X Y"), HasSubstr("noise found"),
                               HasSubstr("30 TCP positions: ")));
    EXPECT_THAT(geometry_json(fit, square),
                testing::AllOf(HasSubstr("\"covariance\""), HasSubstr("\"fixed\"")));
    EXPECT_THAT(tcps_svg(fit),
                testing::AllOf(HasSubstr("<svg"), HasSubstr("TCP 30<"), HasSubstr("before, um")));
    EXPECT_THAT(geometry_text(fit).value(), HasSubstr("which a machine file cannot contain"));
}

}  // namespace
}  // namespace gsim::calibrate::geometry_closed_form_test
