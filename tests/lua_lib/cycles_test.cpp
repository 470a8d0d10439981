// Canned cycles and threads: the order of the strokes, their end points, and what the spindle does. The
// rs274ngc sequences are those that LinuxCNC 2.9 prints for the same blocks.

#include <cmath>

#include <fmt/format.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::cycles_test {
namespace {

Outcome run_ab9(const std::string& lua) {
    return run_lua(lua);
}

Outcome run_rs274(const std::string& lua) {
    return run_ngc_lua(lua, {});
}

// Start of the examples: F, S, the spindle on, and the tool above X10 Y10.
const std::string kStart = "F(600) S(100) M3() G90() G0{x=10, y=10, z=100}\n";

char letter_of(simulation::MoveKind kind) {
    using enum simulation::MoveKind;
    if (kind == rapid) return 'r';
    if (kind == linear) return 'f';
    if (kind == thread) return 't';
    return kind == dwell ? 'd' : '?';
}

// Returns the moves after the first one: "r 10 10 60" (rapid), "f" (feed), "t" (thread) to X Y Z, or "d 0.5"
// (dwell, s).
std::string strokes(const Outcome& run) {
    std::string text;
    for (std::size_t n = 1; n < run.moves.size(); ++n) {
        const char kind = letter_of(run.moves[n].info.kind);
        if (!text.empty()) text += ", ";
        if (kind == 'd') {
            text += fmt::format("d {:g}", std::round(run.seconds(n) * 1e6) / 1e6);
            continue;
        }
        text += kind;
        for (const char axis : {'X', 'Y', 'Z'})
            text += fmt::format(" {:g}", std::round(run.to(n, axis) * 1e6) / 1e6 + 0.0);
    }
    return text;
}

void expect_strokes(const Outcome& run, const std::string& expected_value) {
    EXPECT_TRUE(run.completed()) << run.message() << "\n" << run.lua;
    EXPECT_EQ(strokes(run), expected_value) << run.lua;
}

// --- Both dialects ---

TEST(Cycles, DrillAndRetractToInitialLevelOrR) {
    for (const auto& run_it : {run_ab9, run_rs274}) {
        expect_strokes(run_it(kStart + "G98() G81{x=20, y=30, z=40, r=60}\nG80()"),
                       "r 20 30 100, r 20 30 60, f 20 30 40, r 20 30 100");
        expect_strokes(run_it(kStart + "G99() G81{x=20, z=40, r=60}\nmove{x=30}\nmove{x=40, z=50}"),
                       "r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 60, r 30 10 60, f 30 10 40, r 30 10 60, "
                       "r 40 10 60, f 40 10 50, r 40 10 60");
    }
}

TEST(Cycles, RepeatInIncrementalDimensions) {
    for (const auto& run_it : {run_ab9, run_rs274}) {
        expect_strokes(run_it(kStart + "G99() G91() G81{x=5, z=-20, r=-40, l=3}"),
                       "r 15 10 100, r 15 10 60, f 15 10 40, r 15 10 60, r 20 10 60, f 20 10 40, r 20 10 60, "
                       "r 25 10 60, f 25 10 40, r 25 10 60");
    }
}

TEST(Cycles, DrillAlongPlaneNormal) {
    for (const auto& run_it : {run_ab9, run_rs274}) {
        const std::string start = "F(600) G90() G98() G0{x=100, y=100, z=100}\n";
        expect_strokes(run_it(start + "G18() G81{x=20, z=30, y=40, r=60}"),
                       "r 20 100 30, r 20 60 30, f 20 40 30, r 20 100 30");
        expect_strokes(run_it(start + "G19() G81{y=20, z=30, x=40, r=60}"),
                       "r 100 20 30, r 60 20 30, f 40 20 30, r 100 20 30");
    }
}

TEST(Cycles, AcceptInches) {
    expect_strokes(run_rs274("F(600) G0{x=0, y=0, z=100}\nG20() G99() G81{x=1, y=2, z=1, r=2}"),
                   "r 25.4 50.8 100, r 25.4 50.8 50.8, f 25.4 50.8 25.4, r 25.4 50.8 50.8");
}

TEST(Cycles, DrillAtProgrammedFeed) {
    const Outcome r = run_ab9(kStart + "G81{x=20, z=40, r=60}");
    ASSERT_EQ(r.moves.size(), 5U);
    EXPECT_NEAR(r.seconds(3), trapezoid_s(20, 10, kAcceleration_mm_s2), 1e-6);
}

TEST(Cycles, RejectsMissingAndInvalidWords) {
    for (const auto& run_it : {run_ab9, run_rs274}) {
        expect_alarm(run_it(kStart + "G81{x=20, z=40}"), 2, {"[word-missing]", "G81", " R"});
        expect_alarm(run_it(kStart + "G81{x=20, r=40}"), 2, {"[word-missing]", "G81", " Z"});
        expect_alarm(run_it(kStart + "G83{x=20, z=40, r=60}"), 2, {"[word-missing]", "G83", " Q"});
        expect_alarm(run_it(kStart + "G83{x=20, z=40, r=60, q=0}"), 2,
                     {"[word-value]", "Q of G83", "greater than 0", "not 0"});
        expect_alarm(run_it(kStart + "G83{x=20, z=40, r=60, q=1e-12}"), "too small");
        expect_alarm(run_it(kStart + "G82{x=20, z=40, r=60, p=-1}"), 2,
                     {"[word-value]", "P of G82", "at least 0 s", "-1"});
        expect_alarm(run_it(kStart + "G81{x=20, z=40, r=60, l=1.5}"), 2,
                     {"[word-value]", "L of G81", "integer", "1.5"});
        expect_alarm(run_it(kStart + "G93() G81{x=20, z=40, r=60}"), "inverse time");
        expect_alarm(run_it(kStart + "G53() G81{x=20, z=40, r=60}"), "G53");
    }
}

// --- rs274ngc ---

TEST(CyclesNgc, PecksMatchLinuxCnc) {
    expect_strokes(
        run_rs274(kStart + "G99() G83{z=55, r=60, q=2}"),
        "r 10 10 60, f 10 10 58, r 10 10 60, r 10 10 58.254, f 10 10 56, r 10 10 60, r 10 10 56.254, "
        "f 10 10 55, r 10 10 60");
    expect_strokes(run_rs274(kStart + "G98() G73{z=55, r=60, q=3}"),
                   "r 10 10 60, f 10 10 57, r 10 10 57.254, f 10 10 55, r 10 10 100");
}

TEST(CyclesNgc, ToolBelowRFirstMovesStraightUp) {
    expect_strokes(run_rs274(kStart + "G98() G81{x=20, z=40, r=120}"),
                   "r 10 10 120, r 20 10 120, f 20 10 40, r 20 10 120");
}

// Between G99 and G98 the first move to the next hole slants up to the initial level, as LinuxCNC has it.
TEST(CyclesNgc, G98AfterG99ReturnsToInitialLevel) {
    expect_strokes(run_rs274(kStart + "G99() G81{z=40, r=60}\nG98() move{x=20}"),
                   "r 10 10 60, f 10 10 40, r 10 10 60, r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 100");
}

TEST(CyclesNgc, WordsStayOnlyWhileSameCycleRepeats) {
    expect_alarm(run_rs274(kStart + "G81{z=40, r=60}\nG82{x=20, z=40, p=1}"), "needs R");
    expect_alarm(run_rs274(kStart + "G81{z=40, r=60}\nG82{x=20, z=40, r=60}"), "needs P");
    expect_alarm(run_rs274(kStart + "G81{z=40, r=60}\nG80() move{x=20}"), "need a motion");
    expect_alarm(run_rs274(kStart + "G81{z=40, r=60, b=5}"), 2,
                 {"[word-out-of-place]", "G81", "B cannot be in its block"});
    expect_alarm(run_rs274(kStart + "G81{z=70, r=60}"), "below the bottom");
    expect_alarm(run_rs274(kStart + "G81{z=40, r=60, l=0}"), "0 times");
}

TEST(CyclesNgc, TapReversesSpindle) {
    const Outcome r = run_rs274(kStart + "G99() G84{z=40, r=60, p=0.5}");
    expect_strokes(r, "r 10 10 60, f 10 10 40, d 0.5, f 10 10 60");
    EXPECT_EQ(r.events(), "spindle_cw spindle_off spindle_ccw spindle_off spindle_cw");
    expect_alarm(run_rs274(kStart + "G74{z=40, r=60}"), "counterclockwise");
    expect_alarm(run_rs274(kStart + "M5() G84{z=40, r=60}"), 2, {"[spindle]", "G84", "rotating spindle"});
}

TEST(CyclesNgc, BoringMatchesLinuxCnc) {
    expect_strokes(run_rs274(kStart + "G98() G85{z=40, r=60}"),
                   "r 10 10 60, f 10 10 40, f 10 10 60, r 10 10 100");
    expect_strokes(run_rs274(kStart + "G98() G89{z=40, r=60, p=1}"),
                   "r 10 10 60, f 10 10 40, d 1, f 10 10 100");
    const Outcome stop = run_rs274(kStart + "G98() G86{z=40, r=60, p=1}");
    expect_strokes(stop, "r 10 10 60, f 10 10 40, d 1, r 10 10 100");
    EXPECT_EQ(stop.events(), "spindle_cw spindle_off spindle_cw");
    const Outcome back = run_rs274(kStart + "G99() G87{z=40, r=60, i=1, j=2, k=45}");
    expect_strokes(
        back,
        "r 10 10 60, r 11 12 60, r 11 12 40, r 10 10 40, f 10 10 45, f 10 10 40, r 11 12 40, r 11 12 60, "
        "r 10 10 60");
    EXPECT_EQ(back.events(),
              "spindle_cw spindle_off spindle_orient spindle_cw spindle_off spindle_orient spindle_cw");
}

// The operator retracts the tool; the program continues from the clearance level.
TEST(CyclesNgc, ContinuesAboveHoleAfterManualRetract) {
    const Outcome r = run_rs274(kStart + "G98() G88{z=40, r=60, p=1}\nmove{x=20}\nG0{x=30}\nG0{y=20}");
    expect_strokes(r,
                   "r 10 10 60, f 10 10 40, d 1, r 20 10 100, r 20 10 60, f 20 10 40, d 1, r 30 10 100, "
                   "r 30 20 100");
    EXPECT_EQ(r.events(), "spindle_cw spindle_off stop spindle_cw spindle_off stop spindle_cw");
}

TEST(CyclesNgc, AcceptPolarPositions) {
    expect_strokes(
        run_rs274(kStart + "G99() G81{radius=50, angle=0, z=40, r=60}\nmove{angle=90}\nmove{radius=20}"),
        "r 50 0 100, r 50 0 60, f 50 0 40, r 50 0 60, r 0 50 60, f 0 50 40, r 0 50 60, r 0 20 60, "
        "f 0 20 40, r 0 20 60");
}

TEST(Threads, SynchronizeWithSpindle) {
    const Outcome r = run_rs274(kStart + "G33{z=40, k=2}");
    expect_strokes(r, "t 10 10 40");
    EXPECT_NEAR(r.seconds(1), trapezoid_s(60, 2 * 100 / 60.0, kAcceleration_mm_s2), 1e-6);
    expect_alarm(run_rs274(kStart + "M5() G33{z=40, k=2}"), 2, {"[spindle]", "G33", "stopped"});
    expect_alarm(run_rs274(kStart + "G33{z=40}"), "needs K");
}

TEST(Threads, RigidTapReturns) {
    const Outcome r = run_rs274(kStart + "G33_1{z=40, k=2}");
    expect_strokes(r, "t 10 10 40, t 10 10 100");
    EXPECT_EQ(r.events(), "spindle_cw spindle_ccw spindle_cw");
}

// I outwards of the thread, two passes by degression and one spring pass: drive line X50, crest X48.
TEST(Threads, G76CutsTwoPassesAndSpringPass) {
    const Outcome r =
        run_rs274("F(600) S(100) M3() G18() G0{x=50, y=10, z=100}\nG76{p=2, z=60, i=-2, j=1, k=1.5, h=1}");
    expect_strokes(r,
                   "r 50.5 10 100, r 47 10 100, t 47 10 60, r 50.5 10 60, "
                   "r 50 10 100, r 46.5 10 100, t 46.5 10 60, r 50 10 60, "
                   "r 50 10 100, r 46.5 10 100, t 46.5 10 60, r 50 10 60");
}

TEST(Threads, G76TaperLeadsInAndOut) {
    const Outcome r = run_rs274(
        "F(600) S(100) M3() G18() G0{x=50, y=10, z=100}\nG76{p=2, z=60, i=-2, j=1, k=1.5, r=0, e=5, l=3}");
    expect_strokes(r,
                   "r 50.5 10 100, t 48.5 10 100, t 47 10 95, t 47 10 65, t 48.5 10 60, r 50.5 10 60, "
                   "r 50 10 100, t 48 10 100, t 46.5 10 95, t 46.5 10 65, t 48 10 60, r 50 10 60");
}

TEST(Threads, RejectsInvalidWordsOfG76) {
    const std::string start = "S(100) M3() G18() G0{x=50, y=10, z=100}\n";
    expect_alarm(run_rs274(start + "G76{p=2, z=60, i=0, j=1, k=1.5}"), "I of G76");
    expect_alarm(run_rs274(start + "G76{p=2, z=60, i=-1, j=2, k=1.5}"), 2,
                 {"[word-value]", "K of G76", "greater than J", "K1.5", "J2"});
    expect_alarm(run_rs274(start + "G76{z=60, i=-1, j=1, k=1.5}"), "needs P");
    expect_alarm(run_rs274(start + "G76{p=2, z=60, i=-1, j=1, k=1.5, q=90}"), "below 90");
    expect_alarm(run_rs274(start + "G76{p=2, z=60, i=-1, j=1, k=1.5, l=4}"), "L of G76");
}

// --- ab9 ---

TEST(CyclesAb9, BlockWithoutAxisWordsDoesNotDrill) {
    expect_strokes(
        run_ab9(kStart + "G99() G82{x=20, z=40, r=60}\nF(300) move{p=1}\nmove{x=30}\nmove{x=40, l=0}"),
        "r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 60, r 30 10 60, f 30 10 40, d 1, r 30 10 60");
}

TEST(CyclesAb9, LevelsStayActiveForSeries) {
    expect_strokes(run_ab9(kStart + "G99() G81{x=20, z=40, r=60}\nG85{x=30}\nG91() move{x=5}"),
                   "r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 60, r 30 10 60, f 30 10 40, f 30 10 60, "
                   "r 35 10 60, f 35 10 40, f 35 10 60");
    expect_alarm(run_ab9(kStart + "G81{x=20, z=40, r=60}\nG80() G81{x=30}"), 3,
                 {"[word-missing]", "G81", "R,"});
    expect_alarm(run_ab9(kStart + "G81{x=20, z=40, r=60}\nG0{x=0} G81{x=30, r=60}"), 3,
                 {"[word-missing]", "G81", "Z,"});
}

TEST(CyclesAb9, G80RestoresPreviousMotion) {
    expect_strokes(run_ab9(kStart + "G81{x=20, z=40, r=60}\nG80()\nmove{x=30}"),
                   "r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 100, r 30 10 100");
    expect_strokes(run_ab9(kStart + "G1{x=15} G81{x=20, z=40, r=60}\nG80() G80()\nmove{x=30}"),
                   "f 15 10 100, r 20 10 100, r 20 10 60, f 20 10 40, r 20 10 100, f 30 10 100");
}

TEST(CyclesAb9, PeckClearanceIsOneMillimetre) {
    expect_strokes(run_ab9(kStart + "G99() G83{z=55, r=60, q=3}"),
                   "r 10 10 60, f 10 10 57, r 10 10 60, r 10 10 58, f 10 10 55, r 10 10 60");
    expect_strokes(run_ab9(kStart + "G99() G73{z=55, r=60, q=3, p=0.5}"),
                   "r 10 10 60, f 10 10 57, d 0.5, r 10 10 58, f 10 10 55, d 0.5, r 10 10 60");
    expect_strokes(run_ab9(kStart + "G99() G83{z=59, r=60, q=0.5}"),  // never above R
                   "r 10 10 60, f 10 10 59.5, r 10 10 60, f 10 10 59, r 10 10 60");
}

TEST(CyclesAb9, FineBoringShiftsToolFromWall) {
    const Outcome r = run_ab9(kStart + "G98() G76{z=40, r=60, q=0.5}");
    expect_strokes(r, "r 10 10 60, f 10 10 40, r 10.5 10 40, r 10.5 10 100, r 10 10 100");
    EXPECT_EQ(r.events(), "spindle_cw spindle_off spindle_orient spindle_cw");
    expect_strokes(run_ab9(kStart + "G99() G76{z=40, r=60, i=1, j=-2}"),
                   "r 10 10 60, f 10 10 40, r 11 8 40, r 11 8 60, r 10 10 60");
    expect_alarm(run_ab9(kStart + "G76{z=40, r=60}"), "shift");
}

TEST(CyclesAb9, BackBoringEntersOffAxis) {
    expect_strokes(run_ab9(kStart + "G99() G87{z=50, r=40, q=1}"),
                   "r 11 10 100, r 11 10 40, r 10 10 40, f 10 10 50, r 11 10 50, r 11 10 100, r 10 10 100");
}

TEST(CyclesAb9, LeftHandTapStartsSpindleCounterclockwise) {
    const Outcome r = run_ab9(kStart + "G98() G74{z=40, r=60}");
    expect_strokes(r, "r 10 10 60, f 10 10 40, f 10 10 60, r 10 10 100");
    EXPECT_EQ(r.events(), "spindle_cw spindle_ccw spindle_off spindle_cw spindle_off spindle_ccw");
}

TEST(CyclesAb9, ThreadLeadComesFromFOrE) {
    const Outcome r = run_ab9(kStart + "G33{z=40, f=2}\nmove{z=30}\nG33{z=20, e=12.7}");
    expect_strokes(r, "t 10 10 40, t 10 10 30, t 10 10 20");
    EXPECT_NEAR(r.seconds(2), r.seconds(3), 1e-9);
    expect_alarm(run_ab9(kStart + "G33{z=40}"), 2, {"[word-missing]", "G33", "lead", "F,", "E,"});
}

}  // namespace
}  // namespace gsim::script::cycles_test
