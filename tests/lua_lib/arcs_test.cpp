// Arcs in all forms that a program can use (thesis, Appendix D); every value is worked out by hand.

#include <cmath>
#include <numbers>

#include "tests/lua_lib/run.h"

namespace gsim::script::arcs_test {
namespace {

constexpr double kPi = std::numbers::pi;

// The run moves by one arc last: its centre, its length, and its end.
void expect_arc(const Outcome& r, std::array<double, 3> center, double length_mm, std::array<double, 3> end) {
    ASSERT_TRUE(r.completed()) << r.message() << r.lua;
    expect_end(r, end[0], end[1], end[2]);
    const simulation::RecordedMove& move = r.moves.back();
    ASSERT_TRUE(move.arc) << r.lua;
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(move.arc->center[i], center[static_cast<std::size_t>(i)], 1e-6) << "XYZ"[i] << r.lua;
    EXPECT_NEAR(move.length_mm, length_mm, 1e-6) << r.lua;
}

TEST(Arcs, MoveByCentreInBothDirections) {
    expect_arc(run("F1000 G0 X100 Y100\nG3 X90 Y110 I-10\n"), {90, 100, 0}, 10 * kPi / 2, {90, 110, 0});
    expect_arc(run("F1000 G0 X100 Y100\nG2 X90 Y110 I-10\n"), {90, 100, 0}, 10 * kPi * 1.5, {90, 110, 0});
    // Chords that the thesis has special cases for: upright and level ones.
    expect_arc(run("F1000 G0 X100 Y100\nG3 Y120 J10\n"), {100, 110, 0}, 10 * kPi, {100, 120, 0});
    expect_arc(run("F1000 G0 X100 Y100\nG2 X120 I10\n"), {110, 100, 0}, 10 * kPi, {120, 100, 0});
}

TEST(Arcs, PassOnCorrectSide) {
    // Half a circle from (100,100) to (120,100): clockwise over the top, counterclockwise below.
    const Outcome over = run("F1000 G0 X100 Y100\nG2 X120 I10\n");
    EXPECT_NEAR(over.segments.back().position_at(over.segments.back().duration_s / 2)[1], 110, 1e-6);
    const Outcome below = run("F1000 G0 X100 Y100\nG3 X120 I10\n");
    EXPECT_NEAR(below.segments.back().position_at(below.segments.back().duration_s / 2)[1], 90, 1e-6);
}

TEST(Arcs, MoveInZxAndYzPlanes) {
    // ZX: Z is the first axis and X the second, so counterclockwise leads from +Z to +X.
    expect_arc(run("F1000 G18 G0 X100 Z110\nG3 X110 Z100 K-10\n"), {100, 0, 100}, 10 * kPi / 2,
               {110, 0, 100});
    expect_arc(run("F1000 G18 G0 X100 Z110\nG2 X110 Z100 K-10\n"), {100, 0, 100}, 15 * kPi, {110, 0, 100});
    expect_arc(run("F1000 G19 G0 Y110 Z100\nG3 Y100 Z110 J-10\n"), {0, 100, 100}, 10 * kPi / 2,
               {0, 100, 110});
    expect_arc(run("F1000 G19 G0 Y110 Z100\nG2 Y100 Z110 J-10\n"), {0, 100, 100}, 15 * kPi, {0, 100, 110});
    expect_arc(run("F1000 G18 G0 X100 Z110\nG3 X110 Z100 R10\n"), {100, 0, 100}, 10 * kPi / 2, {110, 0, 100});
    EXPECT_EQ(run("F1000 G18 G0 X100 Z110\nG3 X110 Z100 R10\n").moves.back().info.normal,
              simulation::plane_normal(Plane::zx));
    EXPECT_EQ(run("F1000 G19 G0 Y110 Z100\nG2 Y100 Z110 J-10\n").moves.back().info.kind,
              simulation::MoveKind::arc_cw);
}

TEST(Arcs, RadiusSignSelectsShortOrLongArc) {
    const std::string start = "F1000 G0 X100 Y100\n";
    expect_arc(run(start + "G3 X90 Y110 R10\n"), {90, 100, 0}, 10 * kPi / 2, {90, 110, 0});
    expect_arc(run(start + "G3 X90 Y110 R-10\n"), {100, 110, 0}, 15 * kPi, {90, 110, 0});
    expect_arc(run(start + "G2 X90 Y110 R10\n"), {100, 110, 0}, 10 * kPi / 2, {90, 110, 0});
    expect_arc(run(start + "G2 X90 Y110 R-10\n"), {90, 100, 0}, 15 * kPi, {90, 110, 0});
    expect_arc(run(start + "G2 X120 R10\n"), {110, 100, 0}, 10 * kPi, {120, 100, 0});
}

TEST(Arcs, AcceptAngleWithCentreOrEnd) {
    const std::string start = "F1000 G0 X100 Y100\n";
    const double c = 10 * std::cos(kPi / 6), s = 10 * std::sin(kPi / 6);
    expect_arc(run(start + "G3 I-10 AR=30\n"), {90, 100, 0}, 10 * kPi / 6, {90 + c, 100 + s, 0});
    expect_arc(run(start + "G2 I-10 AR=30\n"), {90, 100, 0}, 10 * kPi / 6, {90 + c, 100 - s, 0});
    expect_arc(run(start + "G3 I-10 AR=270\n"), {90, 100, 0}, 15 * kPi, {90, 90, 0});
    expect_arc(run(start + "G3 X90 Y110 AR=90\n"), {90, 100, 0}, 5 * kPi, {90, 110, 0});
    expect_arc(run(start + "G3 X90 Y110 AR=270\n"), {100, 110, 0}, 15 * kPi, {90, 110, 0});
    expect_arc(run(start + "G2 X90 Y110 AR=90\n"), {100, 110, 0}, 5 * kPi, {90, 110, 0});
    expect_arc(run(start + "G2 X120 AR=180\n"), {110, 100, 0}, 10 * kPi, {120, 100, 0});
}

TEST(Arcs, FullCircleReturnsToStart) {
    expect_arc(run("F1000 G0 X100 Y100\nG2 I10\n"), {110, 100, 0}, 20 * kPi, {100, 100, 0});
    expect_arc(run("F1000 G0 X100 Y100\nG3 X100 Y100 I0 J-10\n"), {100, 90, 0}, 20 * kPi, {100, 100, 0});
    expect_arc(run("F1000 G0 X100 Y100\nG3 I-10 AR=360\n"), {90, 100, 0}, 20 * kPi, {100, 100, 0});
    EXPECT_EQ(run("F1000 G0 X100 Y100\nG2 I10\n").moves.back().info.turns, 1);
}

TEST(Arcs, HelixLengthIncludesHeight) {
    const double length = std::hypot(20 * kPi, 30);
    expect_arc(run("F1000 G0 X100 Y100 Z5\nG3 Z35 I-10\n"), {90, 100, 5}, length, {100, 100, 35});
    const Outcome r = run("F1000 G0 X100 Y100 Z5\nG3 Z35 I-10\n");
    const motion::Segment& helix = r.segments.back();
    EXPECT_NEAR(helix.position_at(helix.duration_s / 2)[0], 80, 1e-6);  // halfway round, halfway up
    EXPECT_NEAR(helix.position_at(helix.duration_s / 2)[2], 20, 1e-6);
}

TEST(Arcs, AcceptInchesAndIncrements) {
    expect_arc(run("G20 F40 G0 X4 Y4\nG91 G3 X-1 Y1 I-1\n"), {76.2, 101.6, 0}, 25.4 * kPi / 2,
               {76.2, 127, 0});
    expect_arc(run("G20 F40 G0 X4 Y4\nG3 X3 Y5 R1\n"), {76.2, 101.6, 0}, 25.4 * kPi / 2, {76.2, 127, 0});
}

TEST(Arcs, CentreIsRelativeToStartInEachFrame) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 50}, {'Y', 60}};
    expect_arc(run("F1000 G0 X50 Y40\nG3 X40 Y50 I-10\n", setup), {90, 100, 0}, 5 * kPi, {90, 110, 0});
    expect_arc(run("F1000 G0 X50 Y40\nG53 G3 X90 Y110 I-10\n", setup), {90, 100, 0}, 5 * kPi, {90, 110, 0});
}

TEST(Arcs, AreModal) {
    expect_arc(run("F1000 G0 X100 Y100\nG3 X90 Y110 I-10\nX80 Y100 J-10\n"), {90, 100, 0}, 5 * kPi,
               {80, 100, 0});
}

TEST(Arcs, StayModalAcrossPolarModeAndCycle) {
    expect_arc(run("F1000 G0 X100 Y100\nG3 X90 Y110 I-10\nG16\nG15\nX80 Y100 J-10\n"), {90, 100, 0}, 5 * kPi,
               {80, 100, 0});
    expect_arc(run("F1000 G0 X100 Y0\nG16\nG3 X100 Y90 I-100\n"), {0, 0, 0}, 50 * kPi, {0, 100, 0});
    expect_arc(run("F1000 G0 X100 Y100 Z100\nG2 X90 Y110 I-10\nG81 X90 Y110 Z95 R100\nG16\nG80\nG15\n"
                   "X80 Y100 J-10\n"),
               {90, 100, 100}, 15 * kPi, {80, 100, 100});
}

TEST(Arcs, ReportSameErrorsInLuaAndCore) {
    for (const std::string shape : {"", "G16\n"}) {
        const std::string start = "F1000 G0 X100 Y0\n" + shape;
        const std::uint32_t line = shape.empty() ? 2 : 3;
        expect_alarm(run(start + "G2 X100 Y90 I10 R10\n"), line, {"not by both"});
        expect_alarm(run(start + "G2 X100 Y90 K10\n"), line,
                     {"[word-out-of-place]", "K is not a centre word", "I and J"});
        expect_alarm(run(start + "G2 X100 Y90 R10\n"), line,
                     {"R is 10.000000 mm", shape.empty() ? "45.000000 mm" : "70.710678 mm"});
    }
}

TEST(Arcs, PassThroughIntermediatePoint) {
    // (100,100) -> (110,110) -> (120,100) is half a circle about (110,100).
    expect_arc(run("F1000 G0 X100 Y100\nCIP X120 Y100 I1=110 J1=110\n"), {110, 100, 0}, 10 * kPi,
               {120, 100, 0});
    expect_arc(run("F1000 G0 X100 Y100\nG91 CIP X20 I1=10 J1=10\n"), {110, 100, 0}, 10 * kPi, {120, 100, 0});
    expect_arc(run("F1000 G0 X100 Y100 Z100\nCIP X120 I1=110 K1=110\n"), {110, 100, 100}, 10 * kPi,
               {120, 100, 100});
    // In a plane that leans by 45 degrees: the via point is as far to the side as it is up.
    const Outcome r =
        run("F1000 G0 X100 Y100 Z100\nCIP X120 I1=110 J1=107.0710678118655 K1=107.0710678118655\n");
    expect_arc(r, {110, 100, 100}, 10 * kPi, {120, 100, 100});
}

TEST(Arcs, PassThroughPointInMachineFrame) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 50}};
    expect_arc(run("F1000 G53 G0 X100 Y100\nG53 CIP X120 Y100 I1=110 J1=110\n", setup), {110, 100, 0},
               10 * kPi, {120, 100, 0});
}

TEST(Arcs, RejectsIntermediatePointOnChord) {
    const Outcome r = run("F1000 G0 X100 Y100\nCIP X120 Y100 I1=110 J1=100\n");
    EXPECT_EQ(r.report.status, simulation::RunStatus::alarm);
    EXPECT_EQ(r.line(), 2U);
}

TEST(Arcs, ReportBothRadiiOfImpossibleArc) {
    expect_alarm(run("F1000 G0 X100 Y100\nG2 X130 I10\n"), 2, {"10.000000 mm", "20.000000 mm"});
    expect_alarm(run("F1000 G0 X100 Y100\nG2 X130 R10\n"), 2, {"10.000000 mm", "15.000000 mm"});
    expect_alarm(run("F1000 G0 X100 Y100\nG2 X100.02 I0 J0\n"), 2, {"no radius"});
}

TEST(Arcs, RadiusErrorWithinToleranceKeepsProgrammedEnd) {
    expect_end(run("F1000 G0 X100 Y100\nG3 X90 Y110.03 I-10\n"), 90, 110.03, 0);
}

TEST(Arcs, RejectsContradictoryWords) {
    const std::string start = "F1000 G0 X100 Y100\n";
    expect_alarm(run(start + "G2 X120 I10 R10\n"), 2, {"not by both"});
    expect_alarm(run(start + "G2 X120 K10\n"), 2,
                 {"[word-out-of-place]", "K is not a centre word", "I and J"});
    expect_alarm(run(start + "G2 X120 Y100 I10 AR=90\n"), 2, {"not both"});
    expect_alarm(run(start + "G2 I10 AR=0\n"), 2, {"AR="});
    expect_alarm(run(start + "G2 I10 AR=361\n"), 2, {"AR="});
    expect_alarm(run(start + "G2 X100 Y100 R10\n"), 2, {"full circle", "R"});
    expect_alarm(run(start + "G2\nX120\n"), 3, {"centre"});
}

}  // namespace
}  // namespace gsim::script::arcs_test
