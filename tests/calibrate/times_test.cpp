// Parameters that are hidden in a machine, recovered from the times that it takes.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/times/fit.h"
#include "calibrate/times/fit_output.h"
#include "calibrate/times/model_selection.h"
#include "engine/run.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate::times_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

machine::Machine router(double acceleration_mm_s2, double speed_step_s) {
    std::string text = fmt::format(
        "[machine]\nname = \"router\"\ninverse = \"gantry\"\n[controller]\nplanner = \"look-ahead\"\n"
        "corner = \"velocity-step\"\nexact_path_corner = \"velocity-step\"\nspeed_step_s = {}\n"
        "stop_between_rapid_and_feed = false\n",
        speed_step_s);
    for (const char letter : {'X', 'Y', 'Z'}) {
        text += fmt::format(
            "[[axis]]\nletter = \"{}\"\nkind = \"linear\"\nmin_mm = -500.0\nmax_mm = 500.0\n"
            "max_speed_mm_s = 100.0\nmax_acceleration_mm_s2 = {}\ndirection = \"{}\"\n",
            letter, acceleration_mm_s2, static_cast<char>(letter + ('x' - 'X')));
    }
    return machine::read_machine(text, "router.toml").value();
}

/// A folder with programs of zigzags, of several sides.
class TimesFit : public testing::Test {
  protected:
    TimesFit() : folder_(fs::temp_directory_path() / "gsim-calibrate-times-test") {
        fs::create_directories(folder_);
        for (int i = 0; i < 8; ++i) add_zigzag(2.0 * (i + 1), 10 + 15 * i);
    }
    ~TimesFit() override { fs::remove_all(folder_); }

    void add_zigzag(double side_mm, double angle_deg) {
        std::string text = "G21 G90 G94 G17 G64\nG0 X0 Y0\n";
        const double angle = angle_deg * std::acos(-1.0) / 180;
        for (int i = 1; i <= 20; ++i) {
            text += fmt::format("G1 X{:.3f} Y{:.3f} F6000\n", i * side_mm * std::cos(angle / 2),
                                i % 2 == 0 ? 0.0 : side_mm * std::sin(angle / 2));
        }
        add(text + "M2\n");
    }
    void add(const std::string& text) {
        const fs::path file = folder_ / fmt::format("{}.ngc", runs_.size());
        std::ofstream(file) << text;
        runs_.push_back({file.string(), 1});
    }
    /// The times of a machine, off by a factor with this standard deviation.
    void record(const machine::Machine& machine, double noise, unsigned seed = 5) {
        std::mt19937 random(seed);
        const auto times = Predictor::of(runs_, {"rs274ngc"}, machine).value().times_s(machine);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            ASSERT_TRUE(times[i]) << times[i].error().message;
            runs_[i].time_s = *times[i] * std::exp(std::normal_distribution<double>(0, noise)(random));
        }
    }
    static engine::Run run_of(const std::string& program, const std::string& machine) {
        engine::Request request;
        request.program = program;
        request.machine = "m.toml";
        request.language.dialect = "rs274ngc";
        request.host.files =
            engine::Files::given([machine](const std::string& name) -> std::optional<std::string> {
                if (name == "m.toml") return machine;
                std::ifstream in(name, std::ios::binary);
                return std::string(std::istreambuf_iterator<char>(in), {});
            });
        auto run = engine::Run::open(std::move(request)).value();
        EXPECT_TRUE(run.prepare());
        return run;
    }
    /// Each 10 ms.
    void add_positions(const machine::Machine& machine) {
        for (RecordedRun& recorded : runs_) {
            auto run = run_of(recorded.program, machine::print_machine(machine));
            EXPECT_TRUE(run.on_samples(
                [&](std::span<const engine::Sample> samples) {
                    for (const engine::Sample& sample : samples)
                        recorded.samples.push_back(
                            {sample.t_s, {sample.axes[0], sample.axes[1], sample.axes[2]}});
                },
                0.01));
            EXPECT_TRUE(run.go());
        }
    }
    static std::optional<engine::Report::Interval> make_interval(const std::string& machine,
                                                                 const std::string& program) {
        auto run = run_of(program, machine);
        return run.go().value().cycle_time_95;
    }
    Fit fit(const machine::Machine& start) {
        return fit_times(start, runs_, Predictor::of(runs_, {"rs274ngc"}, router(400, 0.03)).value(), {})
            .value();
    }

    /// Returns a generic controller with this machine's parameters, refined by the recordings.
    ModelSelection choose(const machine::Machine& start, const Predictor& predictor) const {
        const Candidate candidate{"velocity-step", start};
        return select_model(std::span(&candidate, 1), runs_, predictor, 3).value();
    }

    fs::path folder_;
    std::vector<RecordedRun> runs_;
};

const FittedParameter& named(const Fit& fit, const std::string& name) {
    for (const FittedParameter& parameter : fit.parameters) {
        if (parameter.parameter_id.key.find(name) != std::string::npos) return parameter;
    }
    throw std::out_of_range(name);
}

TEST_F(TimesFit, RecoversParametersWithoutNoise) {
    record(router(730, 0.012), 0);
    const Fit found = fit(router(400, 0.03));
    EXPECT_NEAR(named(found, "max_acceleration").value, 730, 7);
    EXPECT_NEAR(named(found, "speed_step_s").value, 0.012, 0.0003);
    for (std::size_t i = 0; i < runs_.size(); ++i)
        EXPECT_NEAR(found.times_s[i], runs_[i].time_s, 0.003 * runs_[i].time_s);
}

TEST_F(TimesFit, RecoversNoisyParametersWithinThreeSigma) {
    record(router(730, 0.012), 0.005);
    const Fit found = fit(router(400, 0.03));
    for (const auto& [name, truth] :
         {std::pair{"max_acceleration", 730.0}, std::pair{"speed_step_s", 0.012}}) {
        const FittedParameter& parameter = named(found, name);
        ASSERT_TRUE(parameter.identified) << name;
        EXPECT_LT(std::abs(std::log(parameter.value / truth)), 3 * parameter.standard_deviation) << name;
    }
    EXPECT_NEAR(found.noise, 0.005, 0.004);
}

TEST_F(TimesFit, LeavesUntestedParametersUnidentified) {
    record(router(730, 0.012), 0);
    const Fit found = fit(router(400, 0.03));
    EXPECT_FALSE(named(found, "centripetal_share").identified);
    const std::string program = test_program(found);
    EXPECT_THAT(program, HasSubstr("(curves)\n"));
    EXPECT_THAT(program, HasSubstr("G2 X"));
    EXPECT_THAT(fit_table(found, runs_), HasSubstr("= 0.866, not determined by these runs alone"));
}

/// Times of words are found among those of moves, with every planning method.
TEST_F(TimesFit, FindsTimesOfWords) {
    for (int i = 1; i < 5; ++i) {
        std::string text = "G21 G90 G17 G64\n";
        for (int k = 0; k < 3 * i; ++k)
            text += fmt::format("G1 X{} F6000\n{}", 7 * (k % 2), k % 3 == 0 ? "T1 M6\n" : "M8\n");
        add(text + "G0 X50\nM2\n");
    }
    // The time of each stop is in the times of words, too: dwells separate it.
    std::string dwells = "G21 G90 G17 G64\n";
    for (int k = 0; k < 20; ++k) dwells += fmt::format("G1 X{} F6000\nG4 P0.05\n", 7 * (k % 2));
    add(dwells + "M2\n");
    machine::Machine ground_truth = router(730, 0.012);
    ground_truth.times.tool_change_s = 6;
    ground_truth.times.coolant_on_s = 0.2;
    record(ground_truth, 0.002);
    const machine::Machine start = router(400, 0.03);
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    const ModelSelection choice = choose(start, predictor);
    EXPECT_THAT(choice.candidate.name, HasSubstr("words that take time"));
    const Fit found = fit_times(choice.candidate.machine, runs_, predictor, {}).value();
    EXPECT_NEAR(named(found, "tool_change_s").value, 6, 0.1);
    EXPECT_NEAR(named(found, "coolant_on_s").value, 0.2, 0.02);
    EXPECT_NEAR(named(found, "max_acceleration").value, 730, 30);
    const std::string text = machine_text(found, runs_);
    EXPECT_THAT(text, HasSubstr("of = \"times\"\nkey = \"tool_change_s\""));
    EXPECT_TRUE(make_interval(text, runs_.back().program));
}

/// The time of a word that is one of a thousand things cannot be found: the program for it has it ten times.
TEST_F(TimesFit, WritesTestProgramForUnidentifiedWords) {
    add("G21 G90\nG1 X100 F60\nM8\nG1 X0\nM2\n");
    record(router(730, 0.012), 0.01);
    machine::Machine start = router(400, 0.03);
    start.times.coolant_on_s = 0.01;
    const Fit found = fit(start);
    EXPECT_FALSE(named(found, "coolant_on_s").identified);
    EXPECT_THAT(test_program(found), HasSubstr("(time of M8)\nM8\nG1 X"));
}

/// Chords of 0.5 mm that are too short for the feed.
TEST_F(TimesFit, FindsBlockTime) {
    for (int i = 1; i < 5; ++i) {
        std::string text = "G21 G90 G17 G64\nG1 X0 Y0 F6000\n";
        for (int k = 1; k < 60 * i; ++k) text += fmt::format("G1 X{:.2f}\n", 0.5 * k);
        add(text + "M2\n");
    }
    machine::Machine ground_truth = router(730, 0.012);
    ground_truth.controller.blocks.time_s = 0.008;
    record(ground_truth, 0.002);
    const machine::Machine start = router(400, 0.03);
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    const ModelSelection choice = choose(start, predictor);
    EXPECT_THAT(choice.candidate.name, HasSubstr("a time for each block"));
    EXPECT_NEAR(choice.candidate.machine.controller.blocks.time_s, 0.008, 0.0002);
}

/// Long paths run at the speeds of the axes.
TEST_F(TimesFit, FindsAxisSpeedIfRequested) {
    for (int i = 1; i < 5; ++i) add(fmt::format("G21 G90\nG0 X{0} Y{1}\nX0\nY{0}\nM2\n", 90 * i, 70 * i));
    machine::Machine ground_truth = router(730, 0.012);
    for (machine::Axis& axis : ground_truth.axes) axis.max_speed = 240;
    record(ground_truth, 0.002);
    const machine::Machine start = router(400, 0.03);
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    const Fit found = fit_times(start, runs_, predictor, {.open = {.speeds = true}}).value();
    EXPECT_NEAR(named(found, "max_speed").value, 240, 5);
    EXPECT_NEAR(named(found, "max_acceleration").value, 730, 20);
}

TEST_F(TimesFit, FindsCentripetalShareFromCurves) {
    for (const double radius : {2.0, 5.0, 10.0})
        add(fmt::format("G21 G90 G17 G64\nG1 X1 F6000\nG2 X1 Y0 I{0} J0\nG2 X1 Y0 I{0} J0\nM2\n", radius));
    machine::Machine ground_truth = router(730, 0.012);
    ground_truth.controller.ramps.centripetal_share = 0.6;
    record(ground_truth, 0);
    const Fit found = fit(router(400, 0.03));
    EXPECT_TRUE(named(found, "centripetal_share").identified);
    EXPECT_NEAR(named(found, "centripetal_share").value, 0.6, 0.02);
}

/// v = sqrt(s a r) is as fast by a great share, which leaves little to speed up with, as by a small one.
TEST_F(TimesFit, OneCurveDoesNotIdentifyCentripetalShare) {
    add("G21 G90 G17 G64\nG1 X1 F6000\nG2 X1 Y0 I10 J0\nG2 X1 Y0 I10 J0\nM2\n");
    machine::Machine ground_truth = router(730, 0.012);
    ground_truth.controller.ramps.centripetal_share = 0.5;
    record(ground_truth, 0.005);
    const machine::Machine start = router(400, 0.03);
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    const Fit found = fit_times(start, runs_, predictor, {.multi_start = true}).value();
    EXPECT_TRUE(named(found, "max_acceleration").identified);
    EXPECT_FALSE(named(found, "centripetal_share").identified);
}

TEST_F(TimesFit, MachineFileReadsBackUnchanged) {
    record(router(730, 0.012), 0.005);
    const Fit found = fit(router(400, 0.03));
    const auto repeated = machine::read_machine(machine_text(found, runs_), "fitted.toml");
    ASSERT_TRUE(repeated) << repeated.error().message;
    machine::Machine calibrated = found.machine;
    calibrated.calibration = make_calibration(found);
    EXPECT_EQ(*repeated, calibrated);
    EXPECT_THAT(residuals_svg(found, runs_), HasSubstr("0.ngc"));
}

/// The positions of one program with lines, corners and curves of all sides show as much as the times of many
/// programs.
TEST_F(TimesFit, FindsParametersFromPositions) {
    const std::vector<RecordedRun> zigzags = runs_;
    runs_.assign(zigzags.begin() + 2, zigzags.begin() + 4);
    const machine::Machine ground_truth = router(730, 0.012);
    record(ground_truth, 0);
    add_positions(ground_truth);
    const Fit found = fit(router(400, 0.03));
    EXPECT_NEAR(named(found, "max_acceleration").value, 730, 20);
    EXPECT_NEAR(named(found, "speed_step_s").value, 0.012, 0.001);
    EXPECT_TRUE(named(found, "max_acceleration").identified);
    EXPECT_TRUE(named(found, "speed_step_s").identified);
}

TEST_F(TimesFit, IntervalsCoverTimesOfOtherPrograms) {
    add_zigzag(5, 33);
    const std::string other = runs_.back().program;
    runs_.pop_back();
    const machine::Machine ground_truth = router(730, 0.012);
    const std::vector<RecordedRun> unknown{{other, 1}};
    const double truth_s =
        Predictor::of(unknown, {"rs274ngc"}, ground_truth).value().times_s(ground_truth).front().value();
    constexpr int kTrials = 25;
    int covered = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        record(ground_truth, 0.005, static_cast<unsigned>(trial));
        const auto interval = make_interval(machine_text(fit(router(400, 0.03)), runs_), other);
        ASSERT_TRUE(interval);
        if (interval->min_s <= truth_s && truth_s <= interval->max_s) ++covered;
        EXPECT_LT(interval->max_s - interval->min_s, 0.08 * truth_s);
    }
    EXPECT_GE(covered, 0.85 * kTrials) << "95 % are promised, of times with their noise";
}

TEST_F(TimesFit, NamesProgramWithoutCompletedRun) {
    add("G1 X9999 F100\nM2\n");
    const auto found = fit_times(router(400, 0.03), runs_,
                                 Predictor::of(runs_, {"rs274ngc"}, router(400, 0.03)).value(), {});
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().message, HasSubstr("8.ngc"));
    EXPECT_FALSE(Predictor::of(std::vector<RecordedRun>{{"/nowhere.ngc", 1}}, {}, router(400, 0.03)));
}

}  // namespace
}  // namespace gsim::calibrate::times_test
