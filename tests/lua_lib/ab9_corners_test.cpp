// Chamfers, corner radii and angles of lines; every point is worked out by hand.

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_corners_test {
namespace {

constexpr double kPi = std::numbers::pi;

// From X100 Y100, at 6000 mm/min; the lines begin on line 2.
Outcome corners(const std::string& lua) {
    return run_lua("F(6000.0) G0{x=100, y=100}\n" + lua);
}

void expect_to(const Outcome& r, std::size_t n, double x, double y) {
    ASSERT_LT(n, r.moves.size()) << r.message();
    EXPECT_NEAR(r.to(n, 'X'), x, 1e-6) << n << r.lua;
    EXPECT_NEAR(r.to(n, 'Y'), y, 1e-6) << n << r.lua;
}

TEST(Corners, ChamferEndsLieAtItsLengthFromCorner) {
    const Outcome r = corners("chamfer(2) G1{x=110}\nG1{y=110}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    expect_to(r, 1, 108, 100);
    expect_to(r, 2, 110, 102);
    expect_to(r, 3, 110, 110);
    EXPECT_EQ(r.moves[2].info.location.line, 2U);
    EXPECT_EQ(r.moves[3].info.location.line, 3U);
}

TEST(Corners, RadiusIsTangentToBothMoves) {
    const Outcome r = corners("corner(2) G1{x=110}\ncorner(3) G1{y=110}\nG1{x=100}");
    ASSERT_EQ(r.moves.size(), 6U) << r.message();
    expect_to(r, 1, 108, 100);
    expect_to(r, 2, 110, 102);
    EXPECT_EQ(r.moves[2].info.kind, simulation::MoveKind::arc_ccw);
    EXPECT_NEAR(r.moves[2].arc->center[0], 108, 1e-9);
    EXPECT_NEAR(r.moves[2].arc->center[1], 102, 1e-9);
    EXPECT_NEAR(r.moves[2].length_mm, kPi, 1e-9);
    expect_to(r, 3, 110, 107);
    expect_to(r, 4, 107, 110);
    expect_to(r, 5, 100, 110);
    EXPECT_EQ(corners("corner(2) G1{x=110}\nG1{y=90}").moves.at(2).info.kind, simulation::MoveKind::arc_cw);
}

TEST(Corners, RoundsCornerOfLineAndArc) {
    // The quarter circle of radius 10 about X100 Y100 begins at right angles to the line; the rounding
    // touches the line from above at distance 2 and the circle from inside: its centre is 8 from the centre
    // of the circle.
    const Outcome r = corners("corner(2) G1{x=110}\nG3{x=100, y=110, i=-10}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    const double cx = 100 + std::sqrt(60.0);
    expect_to(r, 1, cx, 100);
    EXPECT_NEAR(r.moves[2].arc->center[0], cx, 1e-6);
    EXPECT_NEAR(r.moves[2].arc->center[1], 102, 1e-6);
    expect_to(r, 2, 100 + 10 * std::sqrt(60.0) / 8, 102.5);
    expect_to(r, 3, 100, 110);
}

TEST(Corners, RoundsCornerOfTwoArcs) {
    const Outcome r = corners("corner(1) G3{x=110, y=110, j=10}\nG3{x=120, y=120, j=10}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    // Both tangents at the rounding's ends agree with its own: its centre is on the spokes through its ends.
    const auto& arc = *r.moves[2].arc;
    EXPECT_NEAR(std::hypot(arc.center[0] - 100, arc.center[1] - 110), 11, 1e-6);
    EXPECT_NEAR(std::hypot(arc.center[0] - 110, arc.center[1] - 120), 11, 1e-6);
    EXPECT_EQ(r.moves[2].info.kind, simulation::MoveKind::arc_cw);
    expect_to(r, 3, 120, 120);
}

TEST(Corners, ChamferLengthOnArcIsChordLength) {
    const Outcome r = corners("chamfer(2) G3{x=110, y=110, j=10}\nG1{x=100}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    EXPECT_NEAR(std::hypot(r.to(1, 'X') - 110, r.to(1, 'Y') - 110), 2, 1e-6);
    EXPECT_NEAR(std::hypot(r.to(1, 'X') - 100, r.to(1, 'Y') - 110), 10, 1e-6);
    expect_to(r, 2, 108, 110);
}

TEST(Corners, FollowPlaneUnitsAndScale) {
    const Outcome r = run_lua("G18() F(6000.0) G14_1{p=2} corner(1) G1{z=10}\nG1{x=10}");
    ASSERT_EQ(r.moves.size(), 3U) << r.message();
    EXPECT_NEAR(r.to(0, 'Z'), 18, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 2, 1e-9);
    EXPECT_EQ(simulation::main_plane(r.moves[1].info.normal), Plane::zx);
    EXPECT_NEAR(run_lua("G20() F(600.0) chamfer(0.1) G1{x=1}\nG1{y=1}").to(0, 'X'), 0.9 * 25.4, 1e-9);
}

TEST(Corners, ProcessSwitchesAfterCorner) {
    const Outcome r = corners("corner(2) G1{x=110} M8()\nG1{y=110}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    EXPECT_FALSE(r.moves[2].info.process_on);
    EXPECT_TRUE(r.moves[3].info.process_on);
}

TEST(Corners, InverseTimeMoveKeepsItsSpeed) {
    const Outcome r = corners("G93() F(60.0) corner(10) G1{x=200}\nF(60.0) G1{y=200}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    EXPECT_NEAR(r.seconds(1), 0.9, 1e-6);
    EXPECT_GE(r.seconds(2), 10 * kPi / 2 / 100);  // it stops at both ends
    EXPECT_LT(r.seconds(2), 0.5);
    EXPECT_NEAR(r.seconds(3), 0.9, 1e-6);
}

TEST(Corners, IgnoresCornerBetweenCollinearMoves) {
    const Outcome r = corners("corner(2) G1{x=110}\nG1{x=120}");
    ASSERT_EQ(r.moves.size(), 3U) << r.message();
    expect_to(r, 1, 110, 100);
}

TEST(Corners, RejectsTooLargeCornerAndReversal) {
    expect_alarm(corners("corner(12) G1{x=110}\nG1{y=110}"), 3,
                 {",R of 12 mm", "does not fit", "10.0000 mm"});
    expect_alarm(corners("chamfer(5) G1{x=110}\nG1{y=103}"), 3, {",C of 5 mm", "3.0000 mm"});
    expect_alarm(corners("corner(5) G1{x=110}\ncorner(6) G1{y=110}\nG1{x=90}"), 4, {"does not fit"});
    expect_alarm(corners("corner(1) G1{x=110}\nG1{x=100}"), 3, {"[corner]", ",R", "reverses the direction"});
}

TEST(Corners, RejectsCornerWithoutNextMoveAndInvalidWords) {
    expect_alarm(corners("corner(1) G1{x=110}\nG0{y=110}"), 3, {",R", "a rapid follows"});
    expect_alarm(corners("chamfer(1) G1{x=110}\nM2()"), 3, {",C", "none follows"});
    expect_alarm(corners("corner(1) G1{x=110}\nG1{z=10}"), 3, {",R", "along Z too"});
    expect_alarm(corners("corner(1) G1()"), 2, {"[corner]", ",R", "without a move"});
    expect_alarm(corners("corner(1) G1{x=100}"), 2, {"[corner]", ",R", "without a move"});
    expect_alarm(corners("corner(1) G0{x=110}"), 2, {"not to G0"});
    expect_alarm(corners("corner(1) chamfer(1) G1{x=110}"), 2, {"not both"});
    expect_alarm(corners("corner(-1) G1{x=110}"), 2, {"0 or more"});
}

// Any corner of two lines: the rounding meets both at the same distance from the corner and is tangent to
// them.
TEST(Corners, RadiusIsTangentToRandomLines) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-3, 3), heading(-kPi, kPi), size(0.5, 5);
    for (int n = 0; n < 100; ++n) {
        const double a = heading(random), turn = angle(random), radius = size(random);
        if (std::abs(turn) < 0.05) continue;
        const double cx = 500 + 100 * std::cos(a), cy = 500 + 100 * std::sin(a);
        const std::string lua = fmt::format(
            "F(6000.0) G0{{x=500, y=500}} corner({:.12f}) G1{{x={:.12f}, y={:.12f}}} G1{{x={:.12f}, "
            "y={:.12f}}}",
            radius, cx, cy, cx + 100 * std::cos(a + turn), cy + 100 * std::sin(a + turn));
        const double reach = radius * std::tan(std::abs(turn) / 2);
        const Outcome r = run_lua(lua);
        if (reach > 100) {
            EXPECT_FALSE(r.completed()) << lua;
            continue;
        }
        ASSERT_EQ(r.moves.size(), 4U) << lua << r.message();
        EXPECT_NEAR(std::hypot(r.to(1, 'X') - cx, r.to(1, 'Y') - cy), reach, 1e-6) << lua;
        EXPECT_NEAR(std::hypot(r.to(2, 'X') - cx, r.to(2, 'Y') - cy), reach, 1e-6) << lua;
        EXPECT_NEAR(r.moves[2].length_mm, radius * std::abs(turn), 1e-6) << lua;
        EXPECT_EQ(r.moves[2].info.kind == simulation::MoveKind::arc_ccw, turn > 0) << lua;
    }
}

TEST(LineAngles, DetermineOtherCoordinate) {
    expect_end(corners("line_angle(45) G1{x=110}"), 110, 110, 0);
    expect_end(corners("line_angle(30) G1{y=110}"), 100 + 10 / std::tan(kPi / 6), 110, 0);
    expect_end(corners("G91() line_angle(45) G1{x=-10}"), 90, 90, 0);
    expect_end(corners("line_angle(-45) G0{x=110}"), 110, 90, 0);
    expect_alarm(corners("line_angle(90) G1{x=110}"), 2, {",A90", "does not change X"});
    expect_alarm(corners("line_angle(45) G1{x=110, y=110}"), 2, {"X and Y"});
}

TEST(LineAngles, TwoAnglesDetermineIntersection) {
    const Outcome r = corners("line_angle(45) G1()\nline_angle(-45) G1{x=120, y=100}");
    ASSERT_EQ(r.moves.size(), 3U) << r.message();
    expect_to(r, 1, 110, 110);
    expect_to(r, 2, 120, 100);
    EXPECT_EQ(r.moves[1].info.location.line, 2U);
    EXPECT_EQ(r.moves[2].info.location.line, 3U);
    const Outcome rounded = corners("line_angle(45) corner(1) G1()\nline_angle(-45) G1{x=120, y=100}");
    ASSERT_EQ(rounded.moves.size(), 4U) << rounded.message();
    EXPECT_NEAR(rounded.moves[2].length_mm, kPi / 2, 1e-6);
}

TEST(LineAngles, RejectsAngleWithoutIntersection) {
    expect_alarm(corners("line_angle(45) G1()\nG1{x=110}"), 3, {"next block with ,A"});
    expect_alarm(corners("line_angle(45) G1()\nG2{x=110, i=5}"), 3, {"next block with ,A"});
    expect_alarm(corners("line_angle(45) G1()\nM2()"), 3, {"next block with ,A"});
    expect_alarm(corners("line_angle(45) G1()\nline_angle(225) G1{x=110, y=105}"), 3, {"parallel"});
    expect_alarm(corners("line_angle(1) G2{x=110, i=5}"), 2, {"straight"});
}

}  // namespace
}  // namespace gsim::script::ab9_corners_test
