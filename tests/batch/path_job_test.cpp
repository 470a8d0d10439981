// Paths as programs of a batch: written for their machine, then run.
#include "batch/work/path_job.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <unistd.h>

#include "batch/work/run_job.h"
#include "tests/build_files/build_files.h"

namespace gsim::batch::path_job_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kWheel = tests::source_path("samples/wheel.path.json");

Job wheel_job(std::vector<SettingValue> settings) {
    return {.program = kWheel,
            .machine = tests::source_path("samples/machines/af5-measured.toml"),
            .options = {{"collisions", false}},
            .settings = std::move(settings)};
}

Job job_in_cell(std::vector<SettingValue> settings) {
    Job job = wheel_job(std::move(settings));
    job.machine.clear();
    job.options = {{"cell", tests::source_path("samples/cell/wheel.toml")}, {"path_frame", "wheel centre"}};
    return job;
}

TEST(PathJob, RecognizesPathsByName) {
    EXPECT_TRUE(is_path_file("a/b.path.json"));
    EXPECT_TRUE(is_path_file("B.PATH.LUA"));
    for (const char* name : {"a.json", "a.lua", "path.json.nc", "apath.json"})
        EXPECT_FALSE(is_path_file(name));
}

TEST(PathJob, ReportsInvalidKeys) {
    for (const char* key : {"place.x_mm", "place.yaw_deg", "order", "feed_mm_min", "rim.feed_mm_min"})
        EXPECT_FALSE(find_path_key_error(key)) << key;
    for (const char* key : {"place.x", "orders", "feed", ".feed_mm_min", "place"})
        EXPECT_THAT(find_path_key_error(key).value().message, HasSubstr("path.place.x_mm")) << key;
}

// The position of the path changes where the axes move, not how far the tool moves while it cuts.
TEST(PathJob, MovedPathKeepsCutLength) {
    JobRunner runner;
    const RunRow original_host = runner.run(wheel_job({}));
    ASSERT_TRUE(original_host.outcome.is_clean()) << original_host.outcome.message;
    const RunRow placed = runner.run(wheel_job({{"path.place.x_mm", 300}, {"path.place.y_mm", 200}}));
    ASSERT_TRUE(placed.outcome.is_clean()) << placed.outcome.message;
    EXPECT_NEAR(placed.distances.process_on_mm, original_host.distances.process_on_mm, 1e-2)
        << "but for what is rounded in the program";
    EXPECT_EQ(placed.counts.blocks, original_host.counts.blocks);
    // The rim's upper end lies 300 mm further: the first cut reaches farthest.
    EXPECT_THAT(placed.extents, HasSubstr("1015.8997"));
    EXPECT_GT(placed.times.cycle_s, original_host.times.cycle_s) << "it is farther from home";
}

TEST(PathJob, AppliesFeedsAndOrder) {
    JobRunner runner;
    const RunRow fast = runner.run(wheel_job({}));
    const RunRow slow = runner.run(wheel_job({{"path.feed_mm_min", 0.5, SettingUse::factor}}));
    EXPECT_GT(slow.times.cycle_s, fast.times.cycle_s);
    EXPECT_NEAR(slow.distances.process_on_mm, fast.distances.process_on_mm, 1e-9);
    const RunRow other = runner.run(wheel_job({{"path.order", nlohmann::json::array({2U, 1U, 0U})}}));
    ASSERT_TRUE(other.outcome.is_clean()) << other.outcome.message;
    EXPECT_NEAR(other.distances.process_on_mm, fast.distances.process_on_mm, 1e-2);
    EXPECT_NE(other.times.cycle_s, fast.times.cycle_s);
}

TEST(PathJob, PathMovesWithCellFrame) {
    JobRunner runner;
    Job job = job_in_cell({{"cell.frame.wheel centre.frame.x_mm", 250, SettingUse::shift}});
    job.options["collisions"] = false;
    const RunRow moved = runner.run(job);
    ASSERT_TRUE(moved.outcome.is_clean()) << moved.outcome.message;
    EXPECT_THAT(moved.extents, HasSubstr("\"X\":[0.0,965.8997")) << "250 mm further than the path has it";
    // The turn is about the middle of the wheel, 500, 500: the rim's first point moves from below to the
    // right.
    job.settings = {{"cell.frame.wheel centre.frame.roll_deg", 90}};
    const RunRow overridden = runner.run(job);
    ASSERT_TRUE(overridden.outcome.is_clean()) << overridden.outcome.message;
    EXPECT_NEAR(overridden.distances.process_on_mm, moved.distances.process_on_mm, 1e-2)
        << "what is cut is the same";
    EXPECT_THAT(overridden.extents, HasSubstr("\"X\":[0.0,715.9")) << overridden.extents;
}

#ifndef GSIM_SANITIZED  // bodies are looked at two hundred times as long there
// All objects on the frame move along: no other body touches then. Without the path the cell alone is moved.
TEST(PathJob, PathAndCellMoveTogether) {
    JobRunner runner;
    const RunRow moved =
        runner.run(job_in_cell({{"cell.frame.wheel centre.frame.x_mm", 250, SettingUse::shift},
                                {"cell.frame.wheel centre.frame.roll_deg", -45}}));
    ASSERT_TRUE(moved.outcome.is_clean()) << moved.outcome.message;
    EXPECT_EQ(moved.counts.collisions, 0U);
    EXPECT_NEAR(moved.clearance_mm.value(), 0.25, 1e-9) << "nothing comes nearer than the cell asks for";
    Job apart = job_in_cell({{"cell.frame.wheel centre.frame.x_mm", 250, SettingUse::shift}});
    apart.options.erase("path_frame");
    EXPECT_GT(runner.run(apart).counts.collisions, 0U);
}
#endif

TEST(PathJob, ReportsInvalidCombinations) {
    JobRunner runner;
    Job job = job_in_cell({});
    job.options["path_frame"] = "wheel center";
    EXPECT_THAT(runner.run(job).outcome.message, HasSubstr("did you mean 'wheel centre'?"));
    job.options["path_frame"] = "X";
    EXPECT_THAT(runner.run(job).outcome.message, HasSubstr("'X' does not move with the workpiece"));
    Job plain = wheel_job({{"path.place.x_mm", 1}});
    plain.program = tests::source_path("samples/wheel.nc");
    EXPECT_THAT(runner.run(plain).outcome.message, HasSubstr("'path.place.x_mm' applies to paths"));
    EXPECT_THAT(runner.run(wheel_job({{"path.place.x_mm", 5000}})).outcome.message,
                HasSubstr("out of reach"));
    EXPECT_THAT(runner.run(wheel_job({{"path.rin.feed_mm_min", 5000}})).outcome.message, HasSubstr("'rim'"));
    EXPECT_THAT(runner.run(wheel_job({{"path.feed_mm_min", 0}})).outcome.message,
                HasSubstr("'path.feed_mm_min' must be greater than 0"));
    EXPECT_THAT(runner.run(wheel_job({{"path.order", nlohmann::json::array({0U, 1U})}})).outcome.message,
                HasSubstr("each of 0 to 2"));
    Job program = job_in_cell({{"cell.frame.wheel centre.frame.x_mm", 250, SettingUse::shift}});
    program.program = tests::source_path("samples/wheel.nc");
    EXPECT_THAT(runner.run(program).outcome.message, HasSubstr("would not move with 'wheel centre'"));
    Job klipper = wheel_job({});
    klipper.options["dialect"] = "klipper";
    EXPECT_THAT(runner.run(klipper).outcome.message, HasSubstr("option 'post'"));
    const RunRow framed = runner.run(wheel_job({}));
    EXPECT_EQ(framed.files.size(), 2U) << "the path and the machine";
}

// The machine that is built in has no file: its settings go with a frame all the same.
TEST(PathJob, AppliesSettingsToBuiltInMachine) {
    const fs::path folder = fs::temp_directory_path() / ("gsim-built-in-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "c.toml")
        << "[cell]\nname = \"c\"\n[[frame]]\nname = \"f\"\nframe = { x_mm = 500.0, y_mm "
           "= 500.0, z_mm = 52.0 }\n";
    Job job = wheel_job({{"machine.axis.B.max_acceleration_deg_s2", 2, SettingUse::factor},
                         {"cell.frame.f.frame.roll_deg", -45}});
    job.machine.clear();
    job.options = {{"cell", (folder / "c.toml").string()}, {"path_frame", "f"}, {"collisions", false}};
    JobRunner runner;
    const RunRow row = runner.run(job);
    EXPECT_EQ(row.outcome.status, "completed") << row.outcome.message;
    fs::remove_all(folder);
}

TEST(PathJob, ComputesRequestedMetrics) {
    JobRunner runner;
    Job job = wheel_job({});
    EXPECT_FALSE(runner.run(job).joint_speed_share);
    EXPECT_FALSE(runner.run(job).times.lower_bound_s);
    EXPECT_FALSE(runner.run(job).clearance_mm) << "bodies are not looked at";
    job.options["joint_speeds"] = true;
    job.options["lower_bound"] = true;
    const RunRow row = runner.run(job);
    EXPECT_NEAR(row.joint_speed_share.value(), 1, 1e-9) << "B turns at its limit";
    EXPECT_GT(row.times.lower_bound_s.value(), 0);
    EXPECT_LE(row.times.lower_bound_s.value(), row.times.cycle_s);
    // At a tenth of the feed along one straight line no joint is near its limit.
    const fs::path folder = fs::temp_directory_path() / ("gsim-path-job-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string line = (folder / "line.nc").string();
    std::ofstream(line) << "G21 G90 G94\nG01 X100 F3048\nM2\n";
    job.program = line;
    EXPECT_NEAR(runner.run(job).joint_speed_share.value(), 3048.0 / 60 / 508, 1e-9);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace gsim::batch::path_job_test
