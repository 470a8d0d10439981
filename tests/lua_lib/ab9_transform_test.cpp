// Mirror image, scaling and part rotation of the 9/Series, alone and together. The zero point is moved to
// X500 Y500 Z100 so that both signs fit into the machine.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_transform_test {
namespace {

constexpr double kPi = std::numbers::pi;

// Ends the run at this point of the work coordinate system.
void expect_at(const std::string& lua, double x, double y, double z = 0) {
    expect_end(run_lua("F(6000.0) G52{x=500, y=500, z=100} G0{x=0, y=0, z=0}\n" + lua), 500 + x, 500 + y,
               100 + z);
}

void expect_refused(const std::string& lua, const std::vector<std::string>& texts) {
    expect_alarm(run_lua(lua), 1, texts);
}

TEST(Mirror, ReflectsAboutGivenCoordinate) {
    expect_at("G51_1{x=0} G1{x=20, y=5}", -20, 5);
    expect_at("G51_1{x=10} G1{x=20, y=5}", 0, 5);
    expect_at("G51_1{x=10} G51_1{y=0} G1{x=20, y=5}", 0, -5);  // they add up
    expect_at("G51_1{x=10, y=0} G50_1{x=0} G1{x=20, y=5}", 20, -5);
    expect_at("G51_1{x=10, y=0} G50_1() G1{x=20, y=5}", 20, 5);
    expect_at("G20() G51_1{x=1} G1{x=2, y=0}", 0, 0);
}

TEST(Mirror, ReversesArcDirection) {
    const Outcome r =
        run_lua("F(6000.0) G52{x=500, y=500, z=100} G1{x=0, y=0, z=0} G51_1{x=0} G2{x=20, y=0, i=10}");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.back().info.kind, simulation::MoveKind::arc_ccw);
    EXPECT_NEAR(r.moves.back().length_mm, 10 * kPi, 1e-9);
    EXPECT_NEAR(r.moves.back().arc->center[0], 490, 1e-9);
    expect_end(r, 480, 500, 100);
    // Twice mirrored is turned by half a turn: the sense is back.
    EXPECT_EQ(run_lua("F(6000.0) G52{x=500, y=500} G1{x=0, y=0} G51_1{x=0, y=0} G2{x=20, y=0, i=10}")
                  .moves.back()
                  .info.kind,
              simulation::MoveKind::arc_cw);
}

TEST(Scaling, AcceptsOneFactorOrThree) {
    expect_at("G14_1{p=2} G1{x=20, y=5, z=1}", 40, 10, 2);
    expect_at("G14{p=0.5} G1{x=20, y=5}", 10, 2.5);
    expect_at("G14_1{p=2, x=10, y=1} G1{x=20, y=5}", 30, 9);
    expect_at("G14_1{i=2, j=3} G1{x=20, y=5, z=1}", 40, 15, 1);
    expect_at("G14_1{p=2, j=3} G1{x=20, y=5, z=1}", 40, 15, 2);  // a factor of its own precedes P
}

TEST(Scaling, EitherBareCodeCancelsScaling) {
    expect_at("G14_1{p=2} G14() G1{x=20, y=5}", 20, 5);
    expect_at("G14_1{p=2} G14_1() G1{x=20, y=5}", 20, 5);
    expect_at("G14{p=2} G14_1() G1{x=20, y=5}", 20, 5);
    expect_at("G14() G1{x=20, y=5}", 20, 5);
}

TEST(Scaling, ScalesIncrementsArcsAndRadii) {
    expect_at("G1{x=10, y=0} G14_1{p=2} G91() G1{x=5}", 20, 0);
    const std::string start = "F(6000.0) G52{x=500, y=500} G1{x=0, y=0} G14_1{p=2} ";
    EXPECT_NEAR(run_lua(start + "G2{x=20, y=0, i=10}").moves.back().length_mm, 20 * kPi, 1e-9);
    EXPECT_NEAR(run_lua(start + "G2{x=20, y=0, r=10}").moves.back().length_mm, 20 * kPi, 1e-9);
    expect_refused("F(6000.0) G14_1{i=2} G2{x=20, y=0, i=10}", {"ellipse"});
}

TEST(Scaling, RejectsMissingOrZeroFactor) {
    expect_refused("G14_1{x=5}", {"G14.1", "P", "I, J, K"});
    expect_refused("G14{p=0}", {"[frame]", "G14", "must not be 0"});
    expect_refused("G14{p=2, q=1}", {"'q' is not a word of G14"});
}

TEST(Rotation, IsCounterclockwiseAboutCentre) {
    expect_at("G68{x=10, y=0, r=90} G1{x=20, y=0}", 10, 10);
    expect_at("G68{r=90} G1{x=20, y=0}", 0, 20);
    expect_at("G68{r=-90} G1{x=20, y=0, z=3}", 0, -20, 3);
    expect_at("G68{r=90} G69() G1{x=20, y=0}", 20, 0);
    const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
    expect_at("G68{r=30} G1{x=20, y=5}", 20 * c - 5 * s, 20 * s + 5 * c);
}

TEST(Rotation, UsesActivePlane) {
    expect_at("G18() G68{r=90} G1{x=0, y=0, z=10}", 10, 0, 0);  // from +Z to +X
    expect_at("G19() G68{r=90} G1{x=0, y=10, z=0}", 0, 0, 10);  // from +Y to +Z
    expect_refused("G68{z=5, r=90}", {"[frame]", "G68", "Z is not an axis", "X and Y"});
    expect_refused("G68{x=5}", {"needs R"});
}

TEST(Rotation, AddsUpInIncrementalMode) {
    expect_at("G68{r=30} G91() G68{r=60} G90() G1{x=20, y=0}", 0, 20);
    expect_at("G68{x=10, y=0, r=45} G91() G68{r=45} G90() G1{x=20, y=0}", 10, 10);  // the centre stays
    expect_at("G68{r=30} G68{r=90} G1{x=20, y=0}", 0, 20);
}

TEST(Rotation, AppliesToItsWorkCoordinateSystem) {
    const std::string rotated = "G68{r=90} G55() G1{x=20, y=0} ";
    expect_at(rotated, 20, 0);
    expect_at(rotated + "G54() G1{x=20, y=0}", 0, 20);
}

TEST(Rotation, RotatesIncrements) {
    expect_at("G1{x=10, y=0} G68{r=90} G91() G1{x=5}", 10, 5);
}

// p' = R(S(M(p))), the centres being points of the program: the order in which they are programmed does not
// matter.
TEST(Transforms, MirrorThenScaleThenRotateInAnyProgramOrder) {
    const std::string codes[] = {"G51_1{x=0} ", "G14_1{i=2, j=3, x=1} ", "G68{x=2, y=1, r=90} "};
    const int orders[][3] = {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}};
    const auto scaled = [](double x, double y) { return std::pair{2 * (-x + 1) - 1, 3 * y}; };
    const auto [cx, cy] = scaled(2, 1);
    const auto [x, y] = scaled(3, 4);
    for (const auto& order : orders) {
        std::string lua;
        for (const int i : order) lua += codes[i];
        expect_at(lua + "G1{x=3, y=4}", cx - (y - cy), cy + (x - cx));
    }
}

TEST(Transforms, CauseNoMotion) {
    EXPECT_TRUE(run_lua("G51_1{x=5} G14_1{p=2} G68{r=45} G69() G14() G50_1()").moves.empty());
}

TEST(Transforms, DoNotAffectMachineCoordinates) {
    expect_end(run_lua("F(6000.0) G51_1{x=0} G68{r=90} G53() G1{x=30, y=40}"), 30, 40, 0);
}

}  // namespace
}  // namespace gsim::script::ab9_transform_test
