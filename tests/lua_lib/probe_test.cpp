// Probing (G38.2 to G38.5): the answer of a script, a plane, no contact, and the targets themselves.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::probe_test {
namespace {

using simulation::ProbeSurface;

constexpr double kF3000_mm_s = 50;

/// Returns the braking distance of a joint from a speed: v^2 / 2a.
double braking_mm(double speed_mm_s) {
    return speed_mm_s * speed_mm_s / (2 * kAcceleration_mm_s2);
}

/// RS274/NGC on the built-in machine, of which the accelerations are known.
Conditions on_built_in(const ProbeSurface& feels = {}) {
    Conditions setup;
    setup.options.dialect = "rs274ngc";
    setup.machine.axes[2].min = -1000;
    setup.probe = feels;
    return setup;
}

Conditions at_plane(char axis, double at_mm) {
    return on_built_in(
        {.kind = ProbeSurface::Kind::plane, .axis = static_cast<std::size_t>(axis - 'x'), .at_mm = at_mm});
}

TEST(Probe, TripsAtPointFromScriptAndThenBrakes) {
    const Outcome r = run_ngc_lua(
        "on_probe(function(from, to) return { z = -3 } end)\n"
        "G21() F(3000) G10{l=2, p=1, z=-1}\n"
        "G38_2{z=-100}\n"
        "DEBUG('%.4f %.4f %.4f', v[5063], v[5070], p._z)\n",
        on_built_in());
    // The axis has reached its speed at the contact: 50^2 / 2a is 2.5493 mm.
    EXPECT_EQ(debug_texts(r), "-2.0000 1.0000 -4.5493\n");
    ASSERT_EQ(r.moves.size(), 1U);
    EXPECT_EQ(r.moves[0].info.kind, simulation::MoveKind::probe);
    EXPECT_NEAR(r.to(0, 'Z'), -3 - braking_mm(kF3000_mm_s), 1e-9);
    EXPECT_NEAR(r.seconds(0), 3 / kF3000_mm_s + 1.5 * kF3000_mm_s / kAcceleration_mm_s2, 1e-9);
}

TEST(Probe, AcceptsFractionOfPathFromScript) {
    const Outcome r = run_ngc_lua(
        "function probe(from, to) return 0.25 end\nG21() F(100) G38_3{x=8, y=4} "
        "DEBUG('%.6f %.6f', v[5061], v[5062])\n");
    EXPECT_EQ(debug_texts(r), "2.000000 1.000000\n");
    const Outcome at_once =
        run_ngc_lua("on_probe(function() return 0 end) G21() F(100) G38_2{x=8} DEBUG('%.1f', v[5070])");
    EXPECT_EQ(debug_texts(at_once), "1.0\n");
    EXPECT_TRUE(at_once.moves.empty());
    const Outcome full = run_ngc_lua("on_probe(function() return 1 end) G21() F(100) G38_2{x=8}");
    EXPECT_NEAR(full.to(0, 'X'), 8, 1e-12);
}

TEST(Probe, RejectsMissingContactFromScriptIfRequired) {
    const std::string nothing = "on_probe(function() return nil end)\nG21() F(100)\n";
    expect_alarm(run_ngc_lua(nothing + "G38_2{x=5}"), 3, {"[probe]", "G38.2", "not made contact"});
    expect_alarm(run_ngc_lua(nothing + "G38_4{x=5}"), 3, {"[probe]", "G38.4", "not lost contact"});
    const Outcome r = run_ngc_lua(nothing + "G38_5{x=5} DEBUG('%f %f', v[5061], v[5070])");
    EXPECT_EQ(debug_texts(r), "5.000000 0.000000\n");
}

TEST(Probe, RejectsContactOffPath) {
    const std::string head = "G21() F(100)\n";
    expect_alarm(run_ngc_lua(head + "on_probe(function() return {x=2, y=1} end) G38_2{x=5}"), 2,
                 {"[probe]", "1 mm off the path", "Y"});
    expect_alarm(run_ngc_lua(head + "on_probe(function() return {x=6} end) G38_2{x=5}"), 2,
                 {"[probe]", "outside the path", "1.2"});
    expect_alarm(run_ngc_lua(head + "on_probe(function() return 'here' end) G38_2{x=5}"), 2,
                 {"[probe]", "must be a point"});
}

TEST(Probe, TouchesAtTargetByDefault) {
    const Outcome r = run_ngc(
        "G21 F50\nG0 Z10\nG38.2 Z-5\nG1 X#5061 Z#5063\nG38.3 X10\nG38.4 Z5\n(debug,%.4f#5070 #<_x> "
        "#<_z>)\nG1 Y1\nM2\n");
    EXPECT_EQ(debug_texts(r), "1.0000 10.0000 5.0000\n");
    ASSERT_EQ(r.moves.size(), 5U);
    EXPECT_NEAR(r.to(1, 'Z'), -5, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 10, 1e-9);
    EXPECT_NEAR(r.to(3, 'Z'), 5, 1e-9);
    EXPECT_NEAR(r.to(4, 'Y'), 1, 1e-9);
    EXPECT_EQ(
        r.report.messages.warnings,
        std::vector<std::string>{
            "probes touch at their targets, because nothing defines their contact: use a cell (--cell), a "
            "plane (--probe z=-3.2), or a script (on_probe); with --probe none they never touch"});
}

TEST(Probe, AddsNoMoveAfterProbing) {
    for (const std::string probe : {"G38.3 Z-5", "G38.3 X5", "G38.5 X5"}) {
        const Outcome r = run_ngc("G21 F50\n" + probe + "\nG2 X15 R20\nM2\n");
        ASSERT_EQ(r.moves.size(), 2U) << r.message();
        EXPECT_EQ(r.moves[1].info.kind, simulation::MoveKind::arc_cw);
        EXPECT_NEAR(r.to(1, 'X'), 15, 1e-9);
    }
}

TEST(Probe, StopsAtPlaneOnEachAxis) {
    for (const char axis : {'x', 'y', 'z'}) {
        const std::string letter(1, static_cast<char>(axis - 'a' + 'A'));
        const Outcome r = run_ngc("G21 F3000\nG0 X50 Y50 Z-20\nG38.2 " + letter +
                                      "200\n(debug,%.6f#5061 #5062 "
                                      "#5063 #5070)\nM2\n",
                                  at_plane(axis, 100));
        const double stop = 100 + braking_mm(kF3000_mm_s);
        EXPECT_NEAR(r.to(r.moves.size() - 1, letter[0]), stop, 1e-6) << letter << r.message();
        const std::string trip = axis == 'x'   ? "100.000000 50.000000 -20.000000"
                                 : axis == 'y' ? "50.000000 100.000000 -20.000000"
                                               : "50.000000 50.000000 100.000000";
        EXPECT_EQ(debug_texts(r), trip + " 1.000000\n");
    }
}

// Z of the machine is Z of the program, and the offsets: the tool's end is at the plane in machine
// coordinates.
TEST(Probe, PlaneIsInMachineCoordinatesOfTcp) {
    const Outcome r = run_ngc(
        "G21 F60\nG10 L2 P1 Z2 R30\nG43.1 Z50\nG0 Z0\nG38.2 Z-20\n(debug,%.4f#5063)\nG43.1 Z60\n"
        "G38.5 Z9\n(debug,%.4f#5063)\nM2\n",
        at_plane('z', -3.2));
    EXPECT_EQ(debug_texts(r), "-5.2000\n-5.2000\n");
}

TEST(Probe, LeavesPlaneAfterContact) {
    const Outcome r = run_ngc(
        "G21 F600\nG38.2 Z-20\nG38.4 Z5\n(debug,%.6f#5063 #5070)\nG38.3 Z-1\n(debug,%.1f#5063 #5070)\nM2\n",
        at_plane('z', -3.2));
    EXPECT_EQ(debug_texts(r), "-3.200000 1.000000\n-1.0 0.0\n");
    EXPECT_NEAR(r.to(1, 'Z'), -3.2 + braking_mm(10), 1e-6);
}

TEST(Probe, RejectsExpectedContactStateAtStart) {
    const std::string touched = "G21 F600\nG38.2 Z-20\n";
    expect_alarm(run_ngc(touched + "G38.2 Z-30\nM2\n", at_plane('z', -3)), 3,
                 {"G38.2 moves to a contact, but the probe already has contact at the start"});
    expect_alarm(run_ngc(touched + "G0 Z5\nG38.4 Z9\nM2\n", at_plane('z', -3)), 4,
                 {"G38.4 moves away from a contact, but the probe has no contact at the start"});
    const Outcome r = run_ngc(touched + "G38.3 Z-30\n(debug,%.1f#5070)\nM2\n", at_plane('z', -3));
    EXPECT_EQ(debug_texts(r), "1.0\n");
    EXPECT_EQ(r.moves.size(), 1U);
}

TEST(Probe, RejectsMissingContactWithoutSurface) {
    const Conditions nothing = on_built_in({.kind = ProbeSurface::Kind::none});
    expect_alarm(run_ngc("G21 F600\nG38.2 Z-20\nM2\n", nothing), 2,
                 {"G38.2 has reached its end, but the probe has not made contact"});
    expect_alarm(run_ngc("G21 F600\nG38.4 Z-20\nM2\n", nothing), 2,
                 {"G38.4 has reached its end, but the probe has not lost contact"});
    const Outcome r = run_ngc(
        "G21 F600\nG38.3 Z-20\n(debug,%.1f#5063 #5070)\nG38.5 Z0\n(debug,%.1f#5063 "
        "#5070)\nM2\n",
        nothing);
    EXPECT_EQ(debug_texts(r), "-20.0 0.0\n0.0 0.0\n");
    EXPECT_TRUE(r.report.messages.warnings.empty());
}

TEST(Probe, StartsFromStandstill) {
    Conditions setup = at_plane('z', -3);
    setup.machine.controller.planner = rrs::PlannerKind::look_ahead;
    const Outcome r = run_ngc("G21 F3000 G64\nG1 X50\nG38.2 Z-100\nG1 X100\nM2\n", setup);
    ASSERT_EQ(r.moves.size(), 3U) << r.message();
    EXPECT_NEAR(r.to(0, 'X'), 50, 1e-9);
    EXPECT_NEAR(r.to(0, 'Z'), 0, 1e-9);
    EXPECT_NEAR(r.to(1, 'Z'), -3 - braking_mm(kF3000_mm_s), 1e-6);
    EXPECT_NEAR(r.seconds(1), 3 / kF3000_mm_s + 1.5 * kF3000_mm_s / kAcceleration_mm_s2, 1e-6);
    for (const motion::Segment& segment : r.segments) EXPECT_FALSE(segment.superimposed);
}

TEST(Probe, ContinuesFromStopPositionInSubroutineLoop) {
    const Outcome r = run_ngc(
        "o1 sub\n#2=0\no2 while [#2 LT 3]\nG91 G38.2 X50\nG0 X-10\n#2=[#2+1]\no2 endwhile\no1 endsub\n"
        "G20 F40\nG21\no1 call\n(debug,%.4f#5061)\nM2\n",
        at_plane('x', 30));
    EXPECT_EQ(debug_texts(r), "30.0000\n");
    EXPECT_EQ(r.moves.size(), 6U);
}

TEST(Probe, RejectsProbingDuringCompensation) {
    Conditions setup = ngc_conditions();
    expect_alarm(run_ngc("G21 F50 T1 M6\nG41 G1 X5\nG38.2 X20\nM2\n", setup), 3, {"G38.2"});
}

TEST(Probe, RejectsInvalidWords) {
    expect_alarm(run_ngc("G21 F50\nG38.2\nM2\n"), 2, {"G38.2"});
    expect_alarm(run_ngc("G21 F50\nG38.2 X0\nM2\n"), 2, {"begins at its end"});
    expect_alarm(run_ngc("G21\nG38.2 X5\nM2\n"), 2, {"feed"});
    expect_alarm(run_ngc("G21 G93\nG38.2 X5 F2\nM2\n"), 2, {"G94"});
}

}  // namespace
}  // namespace gsim::script::probe_test
