// Moves that are replanned take as long as the program that is rerun.

#include "calibrate/times/predictor.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate::predictor_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAxes = R"(
[[axis]]
letter = "X"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 500.0
max_jerk_mm_s3 = 5000.0
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 80.0
max_acceleration_mm_s2 = 300.0
max_jerk_mm_s3 = 5000.0
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 50.0
max_acceleration_mm_s2 = 200.0
max_jerk_mm_s3 = 5000.0
direction = "z"
)";

std::string machine_text(const std::string& controller) {
    return "[machine]\nname = \"m\"\ninverse = \"gantry\"\n[controller]\n" + controller + kAxes;
}

/// Controllers with a planner of each kind.
const std::vector<std::string> kControllers = {
    "model = \"exact-stop\"\n",
    "planner = \"look-ahead\"\ncorner = \"velocity-step\"\nspeed_step_s = 0.02\nsettle_s = 0.03\n",
    "planner = \"look-ahead\"\ncorner = \"smooth-blend\"\nblend_tolerance_mm = 0.1\nlimit_jerk = true\n",
    "model = \"ab9\"\n",
    "model = \"blend\"\n",
    "model = \"grbl-1.1\"\n",
    "model = \"grblhal\"\n",
    "model = \"linuxcnc-2.9\"\n",
    "model = \"linuxcnc-2.10\"\n",
    "model = \"klipper\"\n",
};

constexpr const char* kPrograms[] = {
    // Lines, arcs, corners, dwells, offsets, both path modes.
    "G21 G90 G17\nG64\nG0 X10 Y5\nG1 Z-2 F600\nG1 X30 F3000\nY20\nG2 X40 Y30 I10 J0\nG61\nG1 X0\nY0\n"
    "G4 P0.25\nG64 P0.05\nG10 L2 P1 X5\nG1 X20 Y20 F1000\nG3 X20 Y20 I-5 J0\nM3 S1000\nG0 Z5\nM2\n",
    // Stops, cycles, drilling.
    "G21 G90\nG0 X1\nM8\nG0 X50 Y50\nG81 X60 Y60 Z-5 R2 F500\nX70\nG80\nM9\nG0 X0 Y0\nM2\n",
    // A probing move cannot be replanned.
    "G21 G90\nG38.2 Z-10 F100\nG0 Z5\nM2\n",
};

class PredictorTest : public testing::Test {
  protected:
    PredictorTest() : folder_(fs::temp_directory_path() / "gsim-calibrate-predictor-test") {
        fs::create_directories(folder_);
        for (const char* text : kPrograms) {
            const fs::path file = folder_ / (std::to_string(runs_.size()) + ".ngc");
            std::ofstream(file) << text;
            runs_.push_back({file.string(), 1});
        }
    }
    ~PredictorTest() override { fs::remove_all(folder_); }

    /// The program is run on the machine.
    double run_time_s(const std::string& program, const std::string& machine) {
        engine::Request request;
        request.program = program;
        request.machine = (folder_ / "machine.toml").string();
        request.language.dialect = "rs274ngc";
        std::ofstream(request.machine) << machine;
        auto run = engine::Run::open(std::move(request)).value();
        EXPECT_TRUE(run.prepare());
        double first_s = std::numeric_limits<double>::infinity();
        run.on_moves([&](std::span<const engine::Move> moves) {
            for (const engine::Move& move : moves) first_s = std::min(first_s, move.start_s);
        });
        const auto report = run.go();
        EXPECT_TRUE(report && report->status == engine::RunStatus::completed) << program;
        return report ? report->cycle_time_s - first_s : 0;
    }

    fs::path folder_;
    std::vector<RecordedRun> runs_;
};

TEST_F(PredictorTest, MatchesRunTimeOnAnyController) {
    const auto start = machine::read_machine(machine_text(kControllers[1]), "start.toml").value();
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    for (const std::string& controller : kControllers) {
        SCOPED_TRACE(controller);
        const std::string text = machine_text(controller);
        const auto machine = machine::read_machine(text, "m.toml");
        ASSERT_TRUE(machine) << machine.error().message;
        const auto times = predictor.times_s(*machine);
        ASSERT_EQ(times.size(), runs_.size());
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            ASSERT_TRUE(times[i]) << times[i].error().message;
            EXPECT_NEAR(*times[i], run_time_s(runs_[i].program, text), 1e-9) << kPrograms[i];
        }
    }
}

/// Words take time or none: in the first runs of the programs they took some.
TEST_F(PredictorTest, MatchesRunTimeIfWordsTakeTime) {
    const auto start =
        machine::read_machine(machine_text(kControllers[1]) + "[times]\nM3 = 1.0\n", "start.toml").value();
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, start).value();
    EXPECT_THAT(predictor.words(), testing::UnorderedElementsAre("coolant_on_s", "coolant_off_s", "M3"));
    for (const std::string& controller : kControllers) {
        SCOPED_TRACE(controller);
        const std::string text = machine_text(controller) + "[times]\ncoolant_on_s = 0.7\nM3 = 2.5\n";
        const auto times = predictor.times_s(machine::read_machine(text, "m.toml").value());
        for (std::size_t i = 0; i < runs_.size(); ++i)
            EXPECT_NEAR(times[i].value(), run_time_s(runs_[i].program, text), 1e-9) << kPrograms[i];
    }
}

/// As in recordings, which begin and end with motion.
TEST_F(PredictorTest, IgnoresWordsBeforeAndAfterMotion) {
    const std::string moves = "G0 X10\nM8\nG4 P1\nG1 X30 F1000\n";
    std::vector<RecordedRun> runs;
    for (const std::string& text : {moves + "M2\n", "M3 S100\n" + moves + "M9\nM5\nM2\n"}) {
        const fs::path file = folder_ / (std::to_string(runs.size()) + "-words.ngc");
        std::ofstream(file) << "G21 G90\n" << text;
        runs.push_back({file.string(), 1});
    }
    const auto machine = machine::read_machine(machine_text(kControllers[1]) +
                                                   "[times]\nspindle_start_s = 3.0\ncoolant_on_s = 0.5\n"
                                                   "coolant_off_s = 0.25\nspindle_stop_s = 4.0\n",
                                               "m.toml")
                             .value();
    const Predictor predictor = Predictor::of(runs, {"rs274ngc"}, machine).value();
    EXPECT_THAT(predictor.words(), testing::ElementsAre("coolant_on_s"));
    const auto times = predictor.times_s(machine);
    EXPECT_NEAR(times[0].value(), times[1].value(), 1e-9);
}

TEST_F(PredictorTest, PartKeepsTimesOfSelectedPrograms) {
    const auto machine = machine::read_machine(machine_text(kControllers[1]), "m.toml").value();
    const Predictor predictor = Predictor::of(runs_, {"rs274ngc"}, machine).value();
    const auto all = predictor.times_s(machine);
    const auto some = predictor.part(std::vector<std::size_t>{1, 0}).times_s(machine);
    ASSERT_EQ(some.size(), 2U);
    EXPECT_EQ(some[0], all[1]);
    EXPECT_EQ(some[1], all[0]);
}

}  // namespace
}  // namespace gsim::calibrate::predictor_test
