// Time of words: [times] of the machine file.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::word_times_test {
namespace {

using machine::WordTimes;

Conditions with_times(WordTimes times, const char* dialect = "rs274ngc") {
    Conditions setup = with_tools();
    setup.options.dialect = dialect;
    setup.machine.process.reset();
    setup.machine.times = std::move(times);
    return setup;
}

// Returns the time of a word between two moves, in s.
double taken_s(const std::string& word, const WordTimes& times, const char* dialect = "rs274ngc") {
    const std::string before = "G21 G1 X10 F6000\n", behind = "G1 X20\nM30\n";
    const Outcome timed = run(before + word + "\n" + behind, with_times(times, dialect));
    const Outcome bare = run(before + behind, with_times({}, dialect));
    EXPECT_TRUE(timed.completed()) << timed.message();
    EXPECT_NEAR(timed.report.times.words_s, timed.report.cycle_time_s - bare.report.cycle_time_s, 1e-9)
        << word;
    EXPECT_NEAR(timed.report.times.dwell_s - bare.report.times.dwell_s, timed.report.times.words_s, 1e-9)
        << word;
    return timed.report.times.words_s;
}

const WordTimes kTimes{.tool_change_s = 8,
                       .tool_table_s = 0.0625,
                       .coolant_on_s = 0.5,
                       .coolant_off_s = 0.25,
                       .spindle_start_s = 2,
                       .spindle_stop_s = 1.5,
                       .process_on_s = 0.3,
                       .process_off_s = 0.2,
                       .codes_s = {{4, 3}, {100, 0.75}}};

TEST(WordTimes, DependOnEffectOfWord) {
    EXPECT_EQ(taken_s("T1 M6", kTimes), 8);
    EXPECT_EQ(taken_s("M7", kTimes), 0.5);
    EXPECT_EQ(taken_s("M8", kTimes), 0.5);
    EXPECT_EQ(taken_s("M9", kTimes), 0.25);
    EXPECT_EQ(taken_s("M3 S100", kTimes), 2);
    EXPECT_EQ(taken_s("M5", kTimes), 1.5);
    EXPECT_EQ(taken_s("M64 P0", kTimes), 0);
    EXPECT_EQ(taken_s("M8\nM9\nM8", kTimes), 1.25);
}

TEST(WordTimes, ApplyToToolTableWrites) {
    for (const char* const word : {"G10 L1 P1 Z5", "G10 L10 P1 Z5", "G10 L11 P1 Z5"})
        EXPECT_EQ(taken_s(word, kTimes), 0.0625) << word;
    for (const char* const word : {"G10 L2 P1 X0", "G10 L20 P1 X10", "G10 L0"})
        EXPECT_EQ(taken_s(word, kTimes), 0) << word;
    for (const char* const word : {"G10 L10 P1 R5", "G10 L11 P1 R0", "G10 L12 P1 R5", "G10 L13 P1 R0"})
        EXPECT_EQ(taken_s(word, kTimes, "ab9"), 0.0625) << word;
    EXPECT_EQ(taken_s("G10 L2 P1 X0 Y0", kTimes, "ab9"), 0);
}

TEST(WordTimes, CodeNumberPrecedesNamedTime) {
    EXPECT_EQ(taken_s("M4 S100", kTimes), 3);
    EXPECT_EQ(taken_s("M3 S100", {.spindle_start_s = 2, .codes_s = {{3, 0}}}), 0);
}

// An undefined user code takes its time and has no other effect.
TEST(WordTimes, ApplyToUserCodes) {
    EXPECT_EQ(taken_s("M100", kTimes), 0.75);
    EXPECT_EQ(taken_s("M100 P1 Q2", kTimes), 0.75);
    expect_alarm(run("G21\nM101\nM2\n", with_times(kTimes)), "M101");
}

TEST(WordTimes, ApplyToProcessWords) {
    EXPECT_EQ(taken_s("M8", kTimes, "ab9"), 0.3);  // the waterjet's jet
    EXPECT_EQ(taken_s("M9", kTimes, "ab9"), 0.2);
    Conditions laser = with_times(kTimes);
    laser.machine.process = machine::Process{.kind = machine::ProcessKind::laser,
                                             .on = {{62, {{'P', 0}}}, {101, {}}},
                                             .off = {{63, {{'P', 0}}}, {100, {}}},
                                             .checks = {.dwell_s = 9}};
    const Outcome run = script::run(
        "G21 F6000\nG1 X10\nM62 P0\nG1 X20\nM63 P0\nG1 X30\nM62 P1\nG1 X40\nM101\nG1 X50\nM100\nG1 "
        "X60\nM8\nM2\n",
        laser);
    ASSERT_TRUE(run.completed()) << run.message();
    EXPECT_NEAR(run.report.times.words_s, 0.3 + 0.2 + 0.3 + 0.75 + 0.5, 1e-12);
    EXPECT_EQ(run.events(), "laser_on laser_off digital_output laser_on laser_off flood_on");
}

// Recordings that begin with the first move leave these times out.
TEST(WordTimes, MayStartAtFirstMove) {
    const std::string program = "G21 T1 M6\nG1 X10 F6000\nT2 M6\nG1 X20\nM2\n";
    EXPECT_EQ(run(program, with_times({.tool_change_s = 8})).report.times.words_s, 16);
    EXPECT_EQ(run(program, with_times({.tool_change_s = 8, .before_first_move = false})).report.times.words_s,
              8);
}

TEST(WordTimes, AppearInReport) {
    const Outcome timed = run("G21 M8\nG1 X10 F6000\nM2\n", with_times(kTimes));
    EXPECT_NE(simulation::to_json(timed.report).find("\"words_s\": 0.5"), std::string::npos);
    const Outcome bare = run("G21 M8\nG1 X10 F6000\nM2\n", with_times({}));
    EXPECT_EQ(simulation::to_json(bare.report).find("words_s"), std::string::npos);
}

}  // namespace
}  // namespace gsim::script::word_times_test
