// Path modes, constant surface speed, and M codes of the user.

#include <cmath>
#include <numbers>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_modes_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(PathModes, WarnOnceOfMissingEffect) {
    EXPECT_EQ(run_lua("G61() G9()").report.messages.warnings.size(), 0U);
    EXPECT_EQ(run_lua("G62() G62()").report.messages.warnings.size(), 1U);
    EXPECT_EQ(run_lua("G62() G63() G64() G62() G63() G64()").report.messages.warnings.size(), 2U);
}

TEST(Spindle, ConstantSurfaceSpeedFollowsRadius) {
    // 100 m/min at 0.5 mm a turn; halfway from X100 to X50 the radius is 75 mm.
    const Outcome r = run_lua("G95() F(0.5) G96() S(100) G0{x=100} G1{x=50} G1{z=10} G97() S(300) G1{x=40}");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    EXPECT_NEAR(r.moves[1].info.feed_per_min, 0.5 * 100e3 / (2 * kPi * 75), 1e-6);
    EXPECT_NEAR(r.moves[2].info.feed_per_min, 0.5 * 100e3 / (2 * kPi * 50), 1e-6);
    EXPECT_NEAR(r.moves[3].info.feed_per_min, 0.5 * 300, 1e-9);
}

TEST(Spindle, FacingTimeFollowsVaryingSpeed) {
    // dt = 2 pi x dx / (F v) from X200 to X100 at 0.1 mm and 200 m/min; ramps at both ends add little.
    const Outcome r = run_lua("G95() F(0.1) G96() S(200) G0{x=200} G1{x=100}");
    EXPECT_NEAR(r.seconds(1), 60 * kPi * (200.0 * 200 - 100 * 100) / (0.1 * 200e3), 0.01);
}

TEST(Spindle, G50LimitsSpeed) {
    const Outcome r = run_lua("G95() F(0.5) G50{s=500} G96() S(100) G0{x=20} G1{x=0}");
    EXPECT_NEAR(r.moves.at(1).info.feed_per_min, 0.5 * 500, 1e-9);
    EXPECT_NEAR(run_lua("G95() F(0.5) G50{s=500} S(900) G1{x=10}").moves.at(0).info.feed_per_min, 250, 1e-9);
    expect_alarm(run_lua("G95() F(0.5) G96() S(100) G52{x=10}\nG1{x=10} G1{x=-10}"), 2, {"X0", "G50 S"});
    expect_alarm(run_lua("G50()"), 1, {"G50", "G14.1"});
}

TEST(MachineSwitches, AreReportedAsEvents) {
    EXPECT_EQ(run_lua("M7() M19() M49() M48()").events(),
              "coolant_2_on spindle_orient overrides_off overrides_on");
}

TEST(UserCodes, DefinedCodeRuns) {
    expect_end(run_lua("M[101] = function(words) G0{x=words.p} end M[101]{p=4}"), 4, 0, 0);
    expect_end(run_lua("M[101] = function(words) G0{x=words.p or 9} end M[101]()"), 9, 0, 0);
    expect_end(run_lua("M[101] = function() G0{x=1} end M[101] = function() G0{x=2} end M[101]()"), 2, 0, 0);
}

TEST(UserCodes, RejectsUndefinedAndInvalidCodes) {
    expect_alarm(run_lua("\nM[123]{p=1}"), 2, {"M123", "M[123] = function(words)"});
    expect_alarm(run_lua("M[101] = 5"), 1, {"[script]", "M[101]", "needs a function"});
    expect_alarm(run_lua("M[3] = function() end"), 1, {"M3", "controller itself"});
    expect_alarm(run_lua("M[1.5] = function() end"), 1, {"integer", "1.5"});
    expect_alarm(run_lua("M[101] = function() end\nM[101](5)"), 2, {"in braces"});
}

}  // namespace
}  // namespace gsim::script::ab9_modes_test
