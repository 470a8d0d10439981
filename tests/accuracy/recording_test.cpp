#include "tests/accuracy/recording.h"

#include <gtest/gtest.h>

#include "tests/conformance/scratch_folder.h"

namespace gsim::accuracy::recording_test {
namespace {

constexpr const Controller& kLinuxcnc = kControllers[0];
constexpr const Controller& kGrbl = kControllers[1];
constexpr const Controller& kLinuxcnc2 = kControllers[2];

TEST(Recording, HasTimeOfItsController) {
    const std::string times_json =
        R"({"cycle_time_s": 3.618, "cycle_time_nominal_s": 3.5, "mode": "G61.1", "notes": "a square",
            "time_per_line": [[3, 0.904], [4, 0.904], [0, 0.002]]})";
    Recording linuxcnc;
    ASSERT_TRUE(read_recorded_values(times_json, kLinuxcnc, linuxcnc));
    EXPECT_EQ(linuxcnc.cycle_time_s, 3.618);
    EXPECT_EQ(linuxcnc.note, "G61.1");
    EXPECT_TRUE(linuxcnc.exact_stop);
    ASSERT_EQ(linuxcnc.blocks.size(), 2U);
    EXPECT_EQ(linuxcnc.blocks[1].line, 4);
    EXPECT_EQ(linuxcnc.blocks[1].start_s, 0.904);

    Recording grbl;
    ASSERT_TRUE(read_recorded_values(times_json, kGrbl, grbl));
    EXPECT_EQ(grbl.cycle_time_s, 3.5);
    EXPECT_EQ(grbl.note, "a square");
}

TEST(Recording, RejectsMissingOrInvalidValues) {
    Recording recording;
    EXPECT_FALSE(read_recorded_values("{", kGrbl, recording));
    EXPECT_FALSE(read_recorded_values("[]", kGrbl, recording));
    EXPECT_FALSE(read_recorded_values(R"({"cycle_time_s": 1, "notes": ""})", kGrbl, recording));
    EXPECT_FALSE(read_recorded_values(R"({"cycle_time_s": "1", "mode": ""})", kLinuxcnc, recording));
    const auto negative = read_recorded_values(R"({"cycle_time_s": -1, "mode": ""})", kLinuxcnc, recording);
    ASSERT_FALSE(negative);
    EXPECT_EQ(negative.error().message, "a time is negative");
}

TEST(Recording, DwellIsG4OutsideComments) {
    for (const char* program :
         {"G4 P1", "N10 g04p0.5", "G1 X1\nG 4 P1\n", "G4.0 P1", "G1 X1 (a) G4", "g004"}) {
        EXPECT_TRUE(has_dwell(program)) << program;
    }
    for (const char* program : {"", "G", "G40 G41", "G04.1", "G43 H4", "G1 X4", "(G4 P1)", "; G4 P1\nG0 X1",
                                "G54", "G64", "(open G4\nG1 X1"}) {
        EXPECT_FALSE(has_dwell(program)) << program;
    }
}

TEST(Recordings, PairProgramsWithValuesByName) {
    const conformance::ScratchFolder folder;
    folder.write("router_b.ngc", "G1 X1 F10\n");
    folder.write("router_b.json", R"({"cycle_time_s": 2, "mode": "G61"})");
    folder.write("gantry254_a.ngc", "G4 P1\n");
    folder.write("gantry254_a.json", R"({"cycle_time_s": 1, "mode": "G64"})");
    folder.write("router_alone.ngc", "G1 X1 F10\n");
    const auto recordings = find_recordings(folder.path(), kLinuxcnc);
    ASSERT_TRUE(recordings) << recordings.error().message;
    ASSERT_EQ(recordings->size(), 2U);
    const Recording& first = (*recordings)[0];
    EXPECT_EQ(first.name, "gantry254_a");
    EXPECT_EQ(first.machine_file, "linuxcnc-gantry254.toml");
    EXPECT_EQ(first.samples, folder.path() / "gantry254_a.csv.gz");
    EXPECT_FALSE(first.counted);  // LinuxCNC times a dwell by the wall clock
    const Recording& second = (*recordings)[1];
    EXPECT_EQ(second.name, "router_b");
    EXPECT_EQ(second.machine_file, "linuxcnc-router.toml");
    EXPECT_TRUE(second.counted);
    EXPECT_FALSE(second.exact_stop);
}

TEST(Recordings, CountDwellsTimedByController) {
    const conformance::ScratchFolder folder;
    folder.write("router_dwell.ngc", "G4 P1\n");
    folder.write("router_dwell.json", R"({"cycle_time_nominal_s": 1, "notes": ""})");
    const auto recordings = find_recordings(folder.path(), kGrbl);
    ASSERT_TRUE(recordings) << recordings.error().message;
    ASSERT_EQ(recordings->size(), 1U);
    EXPECT_TRUE(recordings->front().counted);
    EXPECT_EQ(recordings->front().machine_file, "grbl-router.toml");
}

TEST(Recordings, CanBeReadFromTable) {
    const conformance::ScratchFolder folder;
    folder.write("router_a.ngc", "G1 X1 F10\n");
    folder.write("router_b.ngc", "G1 X1 F10\n");
    folder.write("router_b.json", R"({"cycle_time_s": 2, "mode": "G61"})");
    folder.write("router_unlisted.ngc", "G1 X1 F10\n");
    folder.write("table.tsv", "name\tcycle_time_s\nrouter_a\t1.5\nrouter_b\t9\nrouter_gone\t3\n");
    const auto recordings = find_recordings(folder.path(), kLinuxcnc2);
    ASSERT_TRUE(recordings) << recordings.error().message;
    ASSERT_EQ(recordings->size(), 2U);
    EXPECT_EQ((*recordings)[0].cycle_time_s, 1.5);
    EXPECT_EQ((*recordings)[0].machine_file, "linuxcnc-router.toml");
    EXPECT_EQ((*recordings)[1].cycle_time_s, 2);  // its own values
    folder.write("table.tsv", "name\ttime\nrouter_a\t1.5\n");
    EXPECT_FALSE(find_recordings(folder.path(), kLinuxcnc2));
    folder.write("table.tsv", "name\tcycle_time_s\nrouter_a\tsoon\n");
    EXPECT_FALSE(find_recordings(folder.path(), kLinuxcnc2));
}

TEST(Recordings, NameUnreadableFile) {
    const conformance::ScratchFolder folder;
    folder.write("router_a.ngc", "");
    const auto times_json = folder.write("router_a.json", "{}");
    const auto recordings = find_recordings(folder.path(), kLinuxcnc);
    ASSERT_FALSE(recordings);
    EXPECT_EQ(recordings.error().message.find(times_json.string()), 0U) << recordings.error().message;
    EXPECT_FALSE(find_recordings(folder.path() / "missing", kLinuxcnc));
}

}  // namespace
}  // namespace gsim::accuracy::recording_test
