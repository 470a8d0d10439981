// Probing (G38.2 to G38.5): what a script answers, and the dry run without one.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script {
namespace {

TEST(Probe, StopsWhereTheScriptSays) {
    const Outcome r = run_ngc_lua(
        "on_probe(function(from, to) return { z = -3 } end)\n"
        "G21() F(100) G10{l=2, p=1, z=-1}\n"
        "G38_2{z=-10}\n"
        "DEBUG('%f %f %f', v[5063], v[5070], p._z)\n");
    EXPECT_EQ(debug_texts(r), "-2.000000 1.000000 -2.000000\n");
    ASSERT_EQ(r.moves.size(), 1U);
    EXPECT_EQ(r.moves[0].info.kind, simulation::MoveKind::probe);
    EXPECT_NEAR(r.to(0, 'Z'), -3, 1e-9);
}

TEST(Probe, MayAnswerWithAPartOfTheWay) {
    const Outcome r = run_ngc_lua("function probe(from, to) return 0.25 end\nG21() F(100) G38_3{x=8, y=4}\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.to(0, 'X'), 2, 1e-9);
    EXPECT_NEAR(r.to(0, 'Y'), 1, 1e-9);
}

TEST(Probe, FindingNothingIsAnAlarmWhereItMust) {
    const std::string nothing = "on_probe(function() return nil end)\nG21() F(100)\n";
    expect_alarm(run_ngc_lua(nothing + "G38_2{x=5}"), 3, {"G38.2", "touched"});
    expect_alarm(run_ngc_lua(nothing + "G38_4{x=5}"), 3, {"G38.4", "come free"});
    const Outcome r = run_ngc_lua(nothing + "G38_5{x=5} DEBUG('%f %f', v[5061], v[5070])");
    EXPECT_EQ(debug_texts(r), "5.000000 0.000000\n");
}

TEST(Probe, AnAnswerBesideTheWayIsRefused) {
    const std::string head = "G21() F(100)\n";
    expect_alarm(run_ngc_lua(head + "on_probe(function() return {x=2, y=1} end) G38_2{x=5}"), 2,
                 {"beside the way", "Y"});
    expect_alarm(run_ngc_lua(head + "on_probe(function() return {x=6} end) G38_2{x=5}"), 2,
                 {"outside the way"});
    expect_alarm(run_ngc_lua(head + "on_probe(function() return 'here' end) G38_2{x=5}"), 2,
                 {"answers with"});
}

// LinuxCNC's dry run: the move goes to its end, and the program goes on 0.254 mm before it.
TEST(Probe, WithoutAScriptIsThatOfADryRun) {
    const Outcome r = run_ngc(
        "G21 F50\nG0 Z10\nG38.2 Z-5\nG1 X#5061 Z#5063\nG38.3 X10\nG38.4 Z5\n(debug,%.4f#5070 #<_x> "
        "#<_z>)\nG1 Y1\nM2\n");
    EXPECT_EQ(debug_texts(r), "0.0000 9.7460 4.7460\n");
    ASSERT_EQ(r.moves.size(), 5U);
    EXPECT_NEAR(r.to(1, 'Z'), -5, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 10, 1e-9);
    EXPECT_NEAR(r.to(3, 'X'), 9.746, 1e-9);
    EXPECT_NEAR(r.to(4, 'Z'), 4.746, 1e-9);
}

// A rapid leads to the arc's start only where the probe has left it in the arc's plane.
TEST(Probe, AnArcBehindADryRunBeginsWhereTheProgramIs) {
    const Outcome along = run_ngc("G21 F50\nG38.3 Z-5\nG2 X10 R5\nM2\n");
    ASSERT_EQ(along.moves.size(), 2U) << along.message();
    EXPECT_EQ(along.moves[1].info.kind, simulation::MoveKind::arc_cw);
    EXPECT_NEAR(along.to(1, 'Z'), -4.746, 1e-9);
    const Outcome across = run_ngc("G21 F50\nG38.3 X5\nG2 X10 R5\nM2\n");
    ASSERT_EQ(across.moves.size(), 3U) << across.message();
    EXPECT_EQ(across.moves[1].info.kind, simulation::MoveKind::rapid);
    EXPECT_NEAR(across.to(1, 'X'), 4.746, 1e-9);
}

TEST(Probe, WrongWords) {
    expect_alarm(run_ngc("G21 F50\nG38.2\nM2\n"), 2, {"G38.2"});
    expect_alarm(run_ngc("G21 F50\nG38.2 X0\nM2\n"), 2, {"begins at its end"});
    expect_alarm(run_ngc("G21\nG38.2 X5\nM2\n"), 2, {"feed"});
    expect_alarm(run_ngc("G21 G93\nG38.2 X5 F2\nM2\n"), 2, {"G94"});
}

}  // namespace
}  // namespace gsim::script
