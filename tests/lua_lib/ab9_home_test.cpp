// Home positions and the skip function.

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_home_test {
namespace {

const std::string kAway = "F(6000.0) G0{x=100, y=100, z=50}\n";

TEST(HomePositions, G29MovesOnlyNamedAxes) {
    // Y has moved since; the intermediate point is for X alone.
    const Outcome r = run_lua(kAway + "G28{x=120} G0{y=30}\nG29{x=10}");
    expect_end(r, 10, 30, 50);
    ASSERT_EQ(r.moves.size(), 6U);
    EXPECT_NEAR(r.to(4, 'X'), 120, 1e-9);
    EXPECT_NEAR(r.to(4, 'Y'), 30, 1e-9);
}

TEST(HomePositions, IncrementOfG29StartsAtIntermediatePoint) {
    expect_end(run_lua(kAway + "G28{x=120} G91() G29{x=5}"), 125, 100, 50);
}

TEST(HomePositions, RejectsUndefinedPosition) {
    expect_alarm(run_lua(kAway + "G30{x=10}"), 2, {"P2", "home position 2 is not defined"});
    expect_alarm(run_lua(kAway + "G30{p=4}"), 2, {"home position 4"});
    expect_alarm(run_lua(kAway + "G30{p=5, x=0}"), 2, {"2 to 4", "5"});
    expect_alarm(run_lua(kAway + "G30{p=1, x=0}"), 2, {"2 to 4", "1"});
}

TEST(SkipFunction, ReachesItsEndWithoutSignal) {
    const Outcome r = run_lua(kAway + "G31{x=150}\nG0{y=v[5061], z=v[5062]}");
    expect_end(r, 150, 150, 100);
    EXPECT_EQ(r.moves.at(1).info.kind, simulation::MoveKind::probe);
}

TEST(SkipFunction, StopsAfterScriptSignal) {
    const std::string probe_script = "on_probe(function(from, to) return 0.25 end) ";
    const double braking_mm = 100.0 * 100 / (2 * kAcceleration_mm_s2);  // from F6000
    expect_end(run_lua(probe_script + kAway + "G31{x=200}"), 125 + braking_mm, 100, 50);
    expect_end(run_lua(probe_script + kAway + "G52{x=10} G31{x=190} G0{y=v[5061]}"), 125 + braking_mm, 115,
               50);
}

TEST(SkipFunction, StopsAfterProbeContact) {
    Conditions setup;
    setup.probe = {.kind = simulation::ProbeSurface::Kind::plane, .axis = 0, .at_mm = 130};
    expect_end(run_lua(kAway + "F(600) G31{x=200} G0{y=v[5061]}", setup),
               130 + 10.0 * 10 / (2 * kAcceleration_mm_s2), 130, 50);
    setup.probe = {.kind = simulation::ProbeSurface::Kind::none};
    expect_end(run_lua(kAway + "G31{x=200} G0{y=v[5061]}", setup), 200, 200, 50);
}

TEST(SkipFunction, RejectsMissingTargetAndEarlyResult) {
    expect_alarm(run_lua("G31()"), 1, {"[word-missing]", "G31", "axis words"});
    expect_alarm(run_lua("v[1]=v[5061]"), 1, {"before the first G31"});
}

}  // namespace
}  // namespace gsim::script::ab9_home_test
