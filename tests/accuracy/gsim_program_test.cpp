#include "tests/accuracy/gsim_program.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::accuracy::gsim_program_test {
namespace {

namespace fs = std::filesystem;

// Writes a program that replaces gsim-run.
fs::path script(const conformance::ScratchFolder& folder, const std::string& body) {
    fs::path file = folder.write("fake-gsim-run", fmt::format("#!/bin/sh\n{}", body));
    fs::permissions(file, fs::perms::owner_all);
    return file;
}

Recording recording(const conformance::ScratchFolder& folder) {
    Recording sample_outcome;
    sample_outcome.name = "router_a";
    sample_outcome.program = folder.path() / "router_a.ngc";
    sample_outcome.machine_file = "grbl-router.toml";
    return sample_outcome;
}

TEST(CycleTime, IsReadOnlyFromCompletedRun) {
    EXPECT_EQ(read_cycle_time_s(R"({"status": "completed", "alarm": null, "cycle_time_s": 1.25})").value(),
              1.25);
    EXPECT_EQ(read_cycle_time_s(R"({"status": "alarm", "alarm": {"message": "limit"}, "cycle_time_s": 1})")
                  .error()
                  .message,
              "alarm: limit");
    EXPECT_FALSE(read_cycle_time_s(""));
    EXPECT_FALSE(read_cycle_time_s("{}"));
}

TEST(GsimProgram, RunsProgramOnItsMachine) {
    const conformance::ScratchFolder folder;
    const fs::path fake = script(folder,
                                 "echo \"$@\" >\"$(dirname \"$0\")/arguments\"\n"
                                 "echo '{\"status\": \"completed\", \"cycle_time_s\": 2.5}'\n");
    const GsimProgram gsim(fake, {"machines"});
    EXPECT_EQ(gsim.cycle_time_s(recording(folder)).value(), 2.5);
    std::ifstream arguments(folder.path() / "arguments");
    std::string line;
    std::getline(arguments, line);
    EXPECT_EQ(line, fmt::format("--dialect rs274ngc --machine machines/grbl-router.toml --json {}",
                                (folder.path() / "router_a.ngc").string()));
}

TEST(GsimProgram, PassesToolsOfRecording) {
    const conformance::ScratchFolder folder;
    const fs::path fake =
        script(folder,
               "cat \"$7\" >\"$(dirname \"$0\")/data\"; test \"$6\" = --machine-data || exit 1\n"
               "echo '{\"status\": \"completed\", \"cycle_time_s\": 2.5}'\n");
    Recording with_tools = recording(folder);
    with_tools.tools = 2;
    ASSERT_TRUE(GsimProgram(fake, {"machines"}).cycle_time_s(with_tools));
    std::ifstream data(folder.path() / "data");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(data), {}),
              "NCFILE\nTOOL\n1 0 0 CUTTER\n2 0 0 CUTTER\nENDFILE\n");
}

TEST(GsimProgram, ReportsFirstErrorWithoutFolders) {
    const conformance::ScratchFolder folder;
    const GsimProgram gsim(script(folder, "echo \"$6:3: no such code\" >&2\nexit 1\n"), {"machines"});
    EXPECT_EQ(gsim.cycle_time_s(recording(folder)).error().message, "router_a.ngc:3: no such code");
    const GsimProgram killed(script(folder, "kill -9 $$\n"), {"machines"});
    EXPECT_EQ(killed.cycle_time_s(recording(folder)).error().message,
              "fake-gsim-run was terminated by signal 9");
    const GsimProgram silent(script(folder, "exit 1\n"), {"machines"});
    EXPECT_EQ(silent.cycle_time_s(recording(folder)).error().message, "gsim-run failed without a word");
    const GsimProgram refusing(
        script(folder, "echo '{\"status\": \"alarm\", \"alarm\": {\"message\": \"no such code\"}}'; exit 1"),
        {"machines"});
    EXPECT_EQ(refusing.cycle_time_s(recording(folder)).error().message, "alarm: no such code");
    const GsimProgram missing(folder.path() / "missing", {"machines"});
    EXPECT_FALSE(missing.cycle_time_s(recording(folder)));
}

TEST(GsimProgram, ReadsTrajectoryAndMoves) {
    const conformance::ScratchFolder folder;
    const GsimProgram gsim(
        script(folder,
               "printf 't_s,line,x_mm,y_mm,z_mm,speed_mm_s\\n0,3,0,0,0,0\\n0.5,3,7,0,0,0\\n' >\"$7\"\n"
               "test \"$8 $9\" = '--step 0.01' || exit 1\n"
               "echo '{\"line\": 3, \"start_s\": 0, \"end_s\": 0.5}' >\"${11}\"\n"),
        {"machines"});
    const auto path = gsim.path(recording(folder));
    ASSERT_TRUE(path) << path.error().message;
    ASSERT_EQ(path->trajectory.size(), 2U);
    EXPECT_EQ(path->trajectory[1].at_mm[0], 7);
    ASSERT_EQ(path->blocks.size(), 1U);
    EXPECT_EQ(path->blocks[0].end_s, 0.5);
}

TEST(RecordedPath, IsReadFromCompressedFile) {
    const conformance::ScratchFolder folder;
    const fs::path csv = folder.write("router_a.csv", "t,x,y,z,line\n0,0,0,0,0\n0.01,0.5,0,0,3\n");
    ASSERT_EQ(std::system(fmt::format("gzip '{}'", csv.string()).c_str()), 0);
    Recording sample_outcome = recording(folder);
    sample_outcome.samples = folder.path() / "router_a.csv.gz";
    sample_outcome.blocks = {{3, 0, 0.01}};
    const auto path = recorded_path(sample_outcome);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->trajectory.size(), 2U);
    EXPECT_EQ(path->blocks.size(), 1U);
    sample_outcome.samples = folder.path() / "missing.csv.gz";
    EXPECT_FALSE(recorded_path(sample_outcome));
}

TEST(Moves, StartAtFirstMotionAfterDwell) {
    std::istringstream moves(
        "{\"n\":1,\"kind\":\"dwell\",\"start_s\":0,\"end_s\":3}\n{\"n\":2,\"kind\":\"rapid\",\"start_s\":3.5}"
        "\n"
        "{\"n\":3,\"kind\":\"linear\",\"start_s\":4}\n");
    EXPECT_EQ(first_motion_s(moves), 3.5);
    std::istringstream none("");
    EXPECT_EQ(first_motion_s(none), 0);
}

}  // namespace
}  // namespace gsim::accuracy::gsim_program_test
