#include "engine/run.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "tests/build_files/build_files.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::run_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string sample(const std::string& name) {
    std::ifstream file(tests::source_path("samples/") + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

engine::Run prepared(Request request, DiagnosticHandler on_diagnostic = {}) {
    auto run = engine::Run::open(std::move(request), std::move(on_diagnostic));
    EXPECT_TRUE(run) << run.error().message;
    const auto ready = run->prepare();
    EXPECT_TRUE(ready) << ready.error().message;
    return *std::move(run);
}

Report run_report(Request request) {
    return prepared(std::move(request)).go().value();
}

constexpr const char* kSquare = "G0 X100 Y100\nF6000\nG1 X200\nG1 Y200\nG2 X100 Y100 I-50 J-50\nG4 P1\nM2\n";

TEST(Run, NeedsNoSystemFiles) {
    const Report report = run_report(make_request("part.nc", {{"part.nc", kSquare}}));
    EXPECT_EQ(report.status, RunStatus::completed);
    EXPECT_TRUE(report.is_clean());
    EXPECT_EQ(report.counts.moves, 5U);
    EXPECT_NEAR(report.distances.rapid_mm, std::hypot(100, 100), 1e-9);
    EXPECT_NEAR(report.distances.feed_mm, 200 + std::acos(-1.0) * std::hypot(50, 50), 1e-6);
    EXPECT_NEAR(report.times.dwell_s, 1, 1e-9);
    EXPECT_NEAR(text::parse_json<json>(report.json())["cycle_time_s"].get<double>(), report.cycle_time_s,
                1e-9);
    EXPECT_THAT(report.text(), HasSubstr("completed"));
}

TEST(Run, ReadsProgramsAndMachineByCallback) {
    Request request = make_request("jobs/part.nc", {{"jobs/part.nc", "G0 X10\nM98 P7\nM2\n"},
                                                    {"jobs/O0007.nc", "O7\nG1 X40 F600\nM99\n"},
                                                    {"machines/own.toml", sample("machines/router3.toml")}});
    request.machine = "machines/own.toml";
    const Report report = run_report(request);
    EXPECT_EQ(report.status, RunStatus::completed) << report.text();
    EXPECT_NEAR(report.distances.feed_mm, 30, 1e-9);
    EXPECT_NE(report.machine, run_report(make_request("a.nc", {{"a.nc", "M2\n"}})).machine);
}

TEST(Run, NamesMissingFiles) {
    Request request = make_request("part.nc", {{"part.nc", "M98 P7\nM2\n"}});
    EXPECT_THAT(run_report(request).alarm.value().message, HasSubstr("7"));
    request.machine = "own.toml";
    EXPECT_THAT(engine::Run::open(request).error().message, HasSubstr("own.toml"));
    const auto missing = engine::Run::open(make_request("other.nc", {}));
    EXPECT_EQ(missing.error().code, "file");
    EXPECT_THAT(missing.error().message, HasSubstr("other.nc"));
}

TEST(Run, RejectsModuleOutsideProgramFolder) {
    const Report report = run_report(make_request(
        "jobs/part.lua", {{"jobs/part.lua", "require 'gsim'\nrequire '../secret'\n"}, {"secret.lua", ""}}));
    EXPECT_EQ(report.status, RunStatus::alarm);
    EXPECT_THAT(report.alarm->message, HasSubstr("require \"../secret\": the name of a module may have"));
}

TEST(Run, RejectsModuleUnsupportedByHost) {
    Request request = make_request("a.nc", {{"a.nc", "M2\n"}});
    request.module = "planner.so";
    const auto run = engine::Run::open(request);
    ASSERT_FALSE(run);
    EXPECT_THAT(run.error().message, HasSubstr("planner.so"));
    request.overrides.feed_percent = 50;
    EXPECT_EQ(engine::Run::open(request).error().code, "usage");
}

TEST(Run, ProgramErrorsReachHandlerAndReport) {
    std::vector<Diagnostic> reported;
    auto run = engine::Run::open(make_request("part.nc", {{"part.nc", "G1 X1 F\nG0 X\nM2\n"}}),
                                 [&](const Diagnostic& found) { reported.push_back(found); });
    ASSERT_TRUE(run);
    const auto rejected = run->prepare();
    ASSERT_FALSE(rejected);
    EXPECT_TRUE(rejected.error().in_program);
    ASSERT_EQ(reported.size(), 2U);
    EXPECT_EQ(reported[1].line, 2U);
    EXPECT_EQ(reported[1].file, "part.nc");
    const Report report = run->make_report(rejected.error());
    EXPECT_EQ(report.status, RunStatus::alarm);
    EXPECT_EQ(text::parse_json<json>(report.json())["diagnostics"].size(), 2U);
}

TEST(Run, DeliversMovesInChunksInTimeOrder) {
    std::ostringstream program;
    program << "F6000\n";
    for (int i = 1; i <= 3000; ++i) program << "G1 X" << i % 7 << " Y" << i % 11 << "\n";
    engine::Run run = prepared(make_request("part.nc", {{"part.nc", program.str()}}));
    std::vector<Move> moves;
    std::size_t chunks = 0;
    run.on_moves([&](std::span<const Move> chunk) {
        ++chunks;
        for (const Move& move : chunk) EXPECT_EQ(move.file, "part.nc");
        moves.insert(moves.end(), chunk.begin(), chunk.end());
    });
    const Report report = run.go().value();
    EXPECT_EQ(moves.size(), report.counts.moves);
    EXPECT_GT(chunks, 2U);
    for (std::size_t i = 1; i < moves.size(); ++i) {
        EXPECT_EQ(moves[i].n, moves[i - 1].n + 1);
        EXPECT_DOUBLE_EQ(moves[i].start_s, moves[i - 1].end_s);
    }
    EXPECT_DOUBLE_EQ(moves.back().end_s, report.cycle_time_s);
    EXPECT_DOUBLE_EQ(moves.back().end[0], 3000 % 7);
    EXPECT_DOUBLE_EQ(moves.back().end[1], 3000 % 11);
}

// The path of the segments, by the speed that they report, is the length in the report.
TEST(Run, SegmentsJoinAndMatchReportedDistance) {
    engine::Run run = prepared(make_request("part.nc", {{"part.nc", kSquare}}));
    double distance_mm = 0;
    double end_s = 0;
    AxisValues at = run.home();
    run.on_segments([&](std::span<const Segment> chunk) {
        for (const Segment& segment : chunk) {
            EXPECT_NEAR(segment.start_s, end_s, 1e-12);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(segment.start[i], at[i], 1e-9);
                EXPECT_NEAR(segment.axes_at(segment.duration_s)[i], segment.end[i], 1e-9);
            }
            constexpr int kSteps = 2000;
            for (int k = 0; k < kSteps; ++k)
                distance_mm +=
                    segment.speed_mm_s((k + 0.5) * segment.duration_s / kSteps) * segment.duration_s / kSteps;
            at = segment.end;
            end_s = segment.start_s + segment.duration_s;
        }
    });
    const Report report = run.go().value();
    EXPECT_NEAR(distance_mm, report.distances.rapid_mm + report.distances.feed_mm, 1e-3);
    EXPECT_DOUBLE_EQ(end_s, report.cycle_time_s);
}

TEST(Run, SamplesMatchTrajectoryOutput) {
    engine::Run run = prepared(make_request("part.nc", {{"part.nc", kSquare}}));
    std::vector<Sample> samples;
    ASSERT_TRUE(run.on_samples(
        [&](std::span<const Sample> chunk) { samples.insert(samples.end(), chunk.begin(), chunk.end()); },
        0.05));
    std::string csv;
    OutputOptions options;
    options.step_s = 0.05;
    ASSERT_TRUE(run.write(
        OutputKind::trajectory,
        [&](std::string_view text) {
            csv += text;
            return true;
        },
        options));
    const Report report = run.go().value();
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    EXPECT_THAT(line, HasSubstr("t_s,line,x_mm,y_mm,z_mm"));
    for (const Sample& sample : samples) {
        ASSERT_TRUE(std::getline(lines, line));
        double t_s = 0, x_mm = 0;
        char comma = 0;
        std::uint32_t number = 0;
        std::istringstream(line) >> t_s >> comma >> number >> comma >> x_mm;
        EXPECT_EQ(sample.line, number);
        EXPECT_NEAR(sample.t_s, t_s, 1e-9);
        EXPECT_NEAR(sample.axes[0], x_mm, 1e-6);
    }
    EXPECT_DOUBLE_EQ(samples.back().t_s, report.cycle_time_s);
    EXPECT_EQ(run.on_samples({}, 0).error().code, "usage");
}

TEST(Run, StopsWritingOutputAfterSinkFails) {
    engine::Run run = prepared(make_request("part.nc", {{"part.nc", kSquare}}));
    int chunk_count = 0;
    ASSERT_TRUE(run.write(OutputKind::moves, [&](std::string_view) {
        ++chunk_count;
        return false;
    }));
    EXPECT_TRUE(run.go());
    EXPECT_EQ(chunk_count, 1);
}

TEST(Run, ReturnsVariablesAndMachineData) {
    Request request = make_request("part.ngc", {{"part.ngc", "#100 = 1\n#31 = 2.5\nG10 L2 P1 X12.5\nM2\n"},
                                                {"kept.var", "31\t1\n5220\t1\n"}});
    request.language.dialect = "rs274ngc";
    request.variables = "kept.var";
    engine::Run run = prepared(request);
    ASSERT_TRUE(run.go());
    EXPECT_THAT(run.variables().value(), HasSubstr("5221"));
    EXPECT_THAT(run.machine_data().value(), HasSubstr("12.5"));
}

TEST(Run, StopsAtStepMemoryAndCpuLimits) {
    Request endless = make_request("part.lua", {{"part.lua", "require 'gsim'\nwhile true do end\n"}});
    endless.limits.steps = 100'000;
    const Report steps = run_report(endless);
    EXPECT_EQ(steps.status, RunStatus::stopped);
    EXPECT_EQ(steps.alarm->location.line, 2U);
    Request big = make_request(
        "part.lua", {{"part.lua", "require 'gsim'\nlocal t = {} for i = 1, 1e7 do t[i] = {} end\n"}});
    big.limits.memory_bytes = 32U << 20U;
    EXPECT_EQ(run_report(big).status, RunStatus::stopped);
    endless.limits = {};
    endless.limits.cpu_s = 0.1;
    EXPECT_EQ(run_report(endless).status, RunStatus::stopped);
}

TEST(Run, InterleavedRunsAreIndependent) {
    const auto files = std::map<std::string, std::string>{{"a.nc", "G0 X10\nG1 X60 F600\nM2\n"}};
    engine::Run one = prepared(make_request("a.nc", files));
    engine::Run other = prepared(make_request("a.nc", files));
    std::optional<Report> within;
    one.on_moves([&](std::span<const Move>) { within = other.go().value(); });
    const Report report = one.go().value();
    EXPECT_EQ(report.json(), within.value().json());
}

// Other programs are built with these numbers.
TEST(OutputSet, KeepsNamesAndNumbers) {
    const std::vector<std::string> names = output_names();
    EXPECT_EQ(names, (std::vector<std::string>{"moves", "trajectory", "dxf", "path", "plot"}));
    for (std::size_t number = 0; number < names.size(); ++number)
        EXPECT_EQ(find_output(names[number]), static_cast<OutputKind>(number));
    EXPECT_EQ(find_output("film"), std::nullopt);
}

// A body of 10 kg that moves 100 mm up at 1 m/s2 and 0.1 m/s.
constexpr const char* kLift = R"([machine]
name = "lift"
[dynamics]
gravity_m_s2 = [0, 0, -10]
[[axis]]
letter = "Z"
kind = "linear"
direction = "z"
max_speed_mm_s = 100
max_acceleration_mm_s2 = 1000
peak_n = 400
curve_speed_mm_s = [0, 200]
curve_peak_n = [400, 200]
[[mass]]
on = "Z"
mass_kg = 10
)";

TEST(Run, DeliversMotorEffortsAndPower) {
    Request request = make_request("up.nc", {{"up.nc", "G0 Z100\nM2\n"}, {"lift.toml", kLift}});
    request.machine = "lift.toml";
    engine::Run run = prepared(std::move(request));
    EffortColumns all;
    ASSERT_TRUE(run.on_efforts([&](const EffortColumns& some) { all = some; }));
    const Report report = run.go().value();
    ASSERT_EQ(all.efforts.size(), all.t_s.size());
    EXPECT_TRUE(std::is_sorted(all.t_s.begin(), all.t_s.end()));
    for (std::size_t i = 0; i < all.t_s.size(); ++i) {
        const double expected_value = all.t_s[i] < 0.1 ? 110 : (all.t_s[i] < 1 ? 100 : 90);
        EXPECT_NEAR(all.efforts[i], expected_value, 1e-4) << all.t_s[i];
        const double speed_mm_s = 1000 * std::min({all.t_s[i], 0.1, 1.1 - all.t_s[i]});
        EXPECT_NEAR(all.motor_peaks[i], 400 - speed_mm_s, 1e-3) << all.t_s[i];
        EXPECT_EQ(all.line[i], 1U);
    }
    EXPECT_NEAR(*std::max_element(all.power_w.begin(), all.power_w.end()), 11, 1e-4);
}

// 100 mm at 0.1 m/s, from the start on, and an axis with a lag of a fiftieth of a second.
constexpr const char* kSlow = R"([machine]
name = "slow"
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
max_speed_mm_s = 100
position_gain_1_s = 50
)";

TEST(Run, DeliversFollowingErrorsAndActualTcp) {
    Request request = make_request("over.nc", {{"over.nc", "G0 X100\nM2\n"}, {"slow.toml", kSlow}});
    request.machine = "slow.toml";
    engine::Run run = prepared(std::move(request));
    FollowingColumns all;
    ASSERT_TRUE(run.on_following([&](const FollowingColumns& some) { all = some; }));
    ASSERT_TRUE(run.go());
    ASSERT_GT(all.t_s.size(), 10U);
    ASSERT_EQ(all.errors.size(), all.t_s.size());
    ASSERT_EQ(all.tcp_mm.size(), 3 * all.t_s.size());
    EXPECT_TRUE(std::is_sorted(all.t_s.begin(), all.t_s.end()));
    for (std::size_t i = 0; i < all.t_s.size(); ++i) {
        const double following_error_mm = 2 * (1 - std::exp(-50 * all.t_s[i]));
        EXPECT_NEAR(all.errors[i], following_error_mm, 1e-5) << all.t_s[i];
        EXPECT_NEAR(all.tcp_mm[3 * i], 100 * all.t_s[i] - following_error_mm, 1e-4);
        EXPECT_NEAR(all.contour_error_mm[i], 0, 1e-6);
        EXPECT_EQ(all.line[i], 1U);
    }
}

// While the acceleration grows, with it the force and with its square the speed, power is a curve of third
// order: straight lines between few instants would be a hundredth off.
TEST(Run, InterpolatedPowerIsNearExactCurve) {
    constexpr double kJerk_m_s3 = 2;
    std::string machine = std::string(kLift) + "[controller]\nmodel = \"ab9\"\nlimit_jerk = true\n";
    machine.insert(machine.find("max_acceleration_mm_s2"), "max_jerk_mm_s3 = 2000\n");
    Request request = make_request("up.nc", {{"up.nc", "G0 Z100\nM2\n"}, {"lift.toml", machine}});
    request.machine = "lift.toml";
    engine::Run run = prepared(std::move(request));
    EffortColumns all;
    ASSERT_TRUE(run.on_efforts([&](const EffortColumns& some) { all = some; }));
    ASSERT_TRUE(run.go());
    // 0.1 m/s are reached by growing for as long as by shrinking: 0.1 = jerk T^2.
    const double growing_s = std::sqrt(0.1 / kJerk_m_s3);
    const double highest_w = *std::max_element(all.power_w.begin(), all.power_w.end());
    const auto power_w = [&](double t_s) {
        return 10 * (10 + kJerk_m_s3 * t_s) * kJerk_m_s3 * t_s * t_s / 2;
    };
    for (int i = 0; i < 1000; ++i) {
        const double t_s = growing_s * (i + 0.5) / 1000;
        const auto above =
            static_cast<std::size_t>(std::upper_bound(all.t_s.begin(), all.t_s.end(), t_s) - all.t_s.begin());
        ASSERT_GT(above, 0U);
        const double share = (t_s - all.t_s[above - 1]) / (all.t_s[above] - all.t_s[above - 1]);
        const double straight_w = std::lerp(static_cast<double>(all.power_w[above - 1]),
                                            static_cast<double>(all.power_w[above]), share);
        EXPECT_NEAR(straight_w, power_w(t_s), 0.002 * highest_w) << t_s;
    }
}

// A single instant of a dwell would not show how long it lasts.
TEST(Run, MotorsHoldWeightDuringDwell) {
    Request request = make_request("up.nc", {{"up.nc", "G0 Z100\nG4 P3\nG0 Z0\nM2\n"}, {"lift.toml", kLift}});
    request.machine = "lift.toml";
    engine::Run run = prepared(std::move(request));
    EffortColumns all;
    ASSERT_TRUE(run.on_efforts([&](const EffortColumns& some) { all = some; }));
    ASSERT_TRUE(run.go());
    std::vector<double> held_s;
    for (std::size_t i = 0; i < all.t_s.size(); ++i) {
        if (all.line[i] != 2) continue;
        held_s.push_back(all.t_s[i]);
        EXPECT_NEAR(all.efforts[i], 100, 1e-4);
    }
    ASSERT_EQ(held_s.size(), 2U);
    EXPECT_NEAR(held_s[0], 1.1, 1e-9);
    EXPECT_NEAR(held_s[1], 4.1, 1e-9);
}

TEST(Run, RejectsFollowingErrorsWithoutServoLoop) {
    Request request = make_request("up.nc", {{"up.nc", "G0 Z100\nM2\n"}, {"lift.toml", kLift}});
    request.machine = "lift.toml";
    engine::Run run = prepared(std::move(request));
    const std::string message =
        "following errors are requested, but no [[axis]] of the machine file defines its servo loop "
        "(position_gain_1_s)";
    const auto taken = run.on_following([](const FollowingColumns&) {});
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().message, message);
    const auto written =
        run.write(OutputKind::trajectory, [](std::string_view) { return true; }, {.following = true});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, message);
}

}  // namespace
}  // namespace gsim::engine::run_test
