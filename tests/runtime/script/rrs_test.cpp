// The controller's services as scripts call them.

#include <numbers>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::rrs_test {
namespace {

// Runs a script with asserts that must hold.
Outcome expect_true(const std::string& script) {
    Outcome r = run_lua(script);
    EXPECT_TRUE(r.completed()) << r.line() << ": " << r.message() << "\n" << script;
    return r;
}

TEST(Services, EachReturnsStatus) {
    const char* frame = "{{1,0,0,0},{0,1,0,0},{0,0,1,0},{0,0,0,1}}";
    for (const std::string& call :
         std::vector<std::string>{"Initialize()",
                                  "Reset()",
                                  "Terminate()",
                                  "GetMessage()",
                                  fmt::format("GetInverseKinematics({})", frame),
                                  "GetForwardKinematics({0,0,0,0,0})",
                                  "GetCellFrame('table')",
                                  fmt::format("ModifyCellFrame('table', {})", frame),
                                  "SelectWorkFrames('a', 'b')",
                                  "SelectTargetType('joint')",
                                  "SelectTrajectoryMode(1)",
                                  "SetInitialPosition({1,2,3,0,0})",
                                  "SetNextTarget({1,2,3,0,0})",
                                  "SetNextNamedTarget({1,2,3,0,0}, 'p1')",
                                  "GetNextStep()",
                                  "SetInterpolationTime(0.1)",
                                  "SelectMotionType('linear')",
                                  "SelectOrientationInterpolationMode(1)",
                                  "SelectDominantInterpolation('position')",
                                  "SetJointSpeeds(0.5)",
                                  "SetJointAccelerations(0.5)",
                                  "SetJointJerks(1)",
                                  "SetCartesianPositionSpeed(10)",
                                  "SetCartesianOrientationSpeed(1)",
                                  "SetCartesianPositionAcceleration(10)",
                                  "SetCartesianOrientationAcceleration(1)",
                                  "SetOverrideSpeed(100)",
                                  "SetOverrideAcceleration(100)",
                                  "SelectFlybyMode(false)",
                                  "SelectFlybyCriteria(1)",
                                  "SetFlybyCriteriaParameter(1, 1, 1)",
                                  "CancelFlybyCriteria(1)",
                                  "SelectPointAccuracy(1)",
                                  "SetPointAccuracyParameter(1, 1)",
                                  "SetMotionTime(1)",
                                  "SetRestParameter(1)",
                                  "StopMotion()",
                                  "ContinueMotion()",
                                  "CancelMotion()",
                                  "GetCurrentTargetId()",
                                  "DefineEvent(1, 1, 0)",
                                  "CancelEvent(1)",
                                  "GetEvent(1)",
                                  "SelectTracking(1, true)",
                                  "SetConveyorPosition(1, 1)",
                                  "SetObjectSpeed(1)",
                                  fmt::format("SetObjectNextTarget({})", frame),
                                  "GetNextObjectStep()"}) {
        expect_true(
            fmt::format("local s = rrs.{}\nassert(math.type(s) == 'integer', 'no status')\n"
                        "assert(rrs.status_name(s):sub(1, 4) == 'RRS_')",
                        call));
    }
}

TEST(Services, UnsupportedOnesReturnMinusTwo) {
    for (const char* call : {"Reset()", "Terminate()", "SelectTrajectoryMode(1)"})
        expect_true(fmt::format("assert(rrs.{} == -2)", call));
    expect_true("assert(rrs.status_name(-2) == 'RRS_SERVICE_NOT_SUPPORTED')");
}

TEST(Services, CancelledMotionLetsProgramContinue) {
    const Outcome r = expect_true(R"(
assert(rrs.ContinueMotion() == -4)
assert(rrs.SelectMotionType("linear") == 0)
assert(rrs.SetCartesianPositionSpeed(100) == 0)
assert(rrs.SetNextTarget({100, 0, 0, 0, 0}) == 0)
assert(rrs.DefineEvent(1, 1, 0) == 0)
assert(rrs.StopMotion() == 0)
assert(rrs.SetNextTarget({200, 0, 0, 0, 0}) == -12)
assert(rrs.CancelMotion() == 0)
assert(rrs.SetNextTarget({0, 50, 0, 0, 0}) == 0)
)");
    expect_end(r, 0, 50, 0);
}

TEST(Services, TargetsMoveMachine) {
    const Outcome r = expect_true(R"(
assert(rrs.SelectTargetType("joint") == 0)
assert(rrs.SelectMotionType("linear") == 0)
assert(rrs.SetCartesianPositionSpeed(100) == 0)
assert(rrs.SetNextTarget({100, 0, 0, 0, 0}) == 0)
assert(rrs.SetNextNamedTarget({100, 50, 0, 0, 0}, "corner") == 0)
)");
    ASSERT_EQ(r.moves.size(), 2U);
    EXPECT_NEAR(r.seconds(0), trapezoid_s(100, 100, kAcceleration_mm_s2), 1e-9);
    EXPECT_EQ(r.moves[0].info.location.line, 5U);
    expect_end(r, 100, 50, 0);
}

TEST(Services, SelectGreatCircleOrientation) {
    const Outcome r = expect_true(R"(
assert(rrs.SelectOrientationInterpolationMode(7) == -4)
assert(rrs.SelectOrientationInterpolationMode(1) == 0)
assert(rrs.SelectMotionType("linear") == 0)
assert(rrs.SetCartesianPositionSpeed(100) == 0)
assert(rrs.SetNextTarget({100, 0, 0, 1, 0.5}) == -6)  -- from the upright tool
assert(rrs.SetNextTarget({100, 0, 0, 1, 0}) == 0)
assert(rrs.SetNextTarget({0, 0, 0, 1, 0.5}) == 0)
assert(rrs.SetRapid(true) == 0)
assert(rrs.SetNextTarget({100, 0, 0, 0, 0}) == 0)  -- by the joint angles
)");
    ASSERT_EQ(r.moves.size(), 3U);
    expect_end(r, 100, 0, 0);
}

TEST(Services, AlternateWithWords) {
    // The selections of a script do not change what a word means, and a word continues from the end of a
    // target.
    const Outcome r = expect_true(R"(F(6000) G1{x=100.0}
rrs.SetCartesianPositionSpeed(10)
rrs.SelectMotionType("joint")
assert(rrs.SetNextTarget({200, 0, 0, 0, 0}) == 0)
G91() G1{x=100.0}
)");
    expect_end(r, 300, 0, 0);
    EXPECT_NEAR(r.seconds(2), trapezoid_s(100, 100, kAcceleration_mm_s2), 1e-9);
}

/// Returns the time of the second of two targets, after a word or without it.
double second_target_s(const std::string& word,
                       const std::string& speed = "rrs.SetCartesianPositionSpeed(100)") {
    const Outcome r = run_lua("rrs.SelectTargetType(\"joint\") rrs.SelectMotionType(\"linear\") " + speed +
                              "\nassert(rrs.SetNextTarget({200, 0, 0, 0, 0}) == 0)\n" + word +
                              "\nassert(rrs.SetNextTarget({200, 300, 0, 0, 0}) == 0)\n");
    EXPECT_TRUE(r.completed()) << word << ": " << r.message();
    return r.moves.empty() ? 0 : r.seconds(r.moves.size() - 1);
}

TEST(Services, KeepModesAfterEachMovingWord) {
    for (const char* word :
         {"", "G0{y=100}", "F(500) G1{y=100}", "F(500) G2{y=100, r=50}", "G93() F(2) G1{y=100} G94()",
          "F(500) G1{x=200, y=100} G0{z=0} move{y=100}", "G0{y=100} G28{z=0} G0{y=100}",
          "F(500) CIP{y=100, i1=250, j1=50}", "F(90) G1{b=20} G1{b=0} G0{y=100}",
          "F(500) MoveLinear{x=200, y=100}", "MoveJoint{x=200, y=100}",
          "F(500) MoveCircular{via={x=250, y=50}, to={x=200, y=100}}",
          "F(500) S(100) G95() F(1) G1{y=100} G94()"}) {
        const double from = word[0] == '\0' ? 300 : 200;
        EXPECT_NEAR(second_target_s(word), trapezoid_s(from, 100, kAcceleration_mm_s2), 1e-9) << word;
    }
    // Rapid is a mode of the services, if they have selected it.
    EXPECT_NEAR(second_target_s("F(500) G1{y=100}", "rrs.SetRapid(true)"),
                trapezoid_s(200, 508, kAcceleration_mm_s2), 1e-9);
}

TEST(Services, TargetsAfterWordUseModesOfServices) {
    const Outcome r = expect_true(R"(
G0{x=10.0}
assert(rrs.SelectTargetType("joint") == 0)
assert(rrs.SelectMotionType("linear") == 0)
assert(rrs.SetCartesianPositionSpeed(100) == 0)
assert(rrs.SetNextNamedTarget({200, 0, 0, 0, 0}, "P1") == 0)
assert(rrs.SetNextNamedTarget({200, 200, 0, 0, 0}, "P2") == 0)
)");
    EXPECT_NEAR(r.seconds(2), trapezoid_s(200, 100, kAcceleration_mm_s2), 1e-9);
    expect_true(
        "F(500) G1{x=10.0}\nrrs.SelectMotionType(\"linear\")\n"
        "assert(rrs.status_name(rrs.SetNextTarget({20, 0, 0, 0, 0})) == \"RRS_ZERO_SPEED\")");
    const Outcome joint = expect_true("F(500) G1{x=10.0}\nassert(rrs.SetNextTarget({110, 0, 0, 0, 0}) == 0)");
    EXPECT_NEAR(joint.seconds(1), trapezoid_s(100, 508, kAcceleration_mm_s2), 1e-9)
        << "joint motion is the default";
}

TEST(Services, MoveOnCircleByViaAndEnd) {
    const Outcome r = expect_true(R"(
rrs.SelectTargetType("joint")
assert(rrs.SetInitialPosition({100, 100, 0, 0, 0}) == 0)
rrs.SelectMotionType("circular")
rrs.SetCartesianPositionSpeed(50)
assert(rrs.SetNextTarget({110, 110, 0, 0, 0}, "via") == 0)
assert(rrs.SetNextTarget({120, 100, 0, 0, 0}) == 0)
)");
    ASSERT_EQ(r.moves.size(), 1U);
    EXPECT_NEAR(r.moves[0].length_mm, 10 * std::numbers::pi, 1e-6);
}

TEST(Services, RejectWithMessageAndRunContinues) {
    const Outcome r = expect_true(R"(
rrs.SelectTargetType("joint") rrs.SelectMotionType("linear") rrs.SetCartesianPositionSpeed(50)
assert(rrs.SetNextTarget({9999, 0, 0, 0, 0}) == -7)
local status, message = rrs.GetMessage()
assert(status == 0 and #message > 0)
assert(rrs.SetCartesianPositionSpeed(-1) == -4)
G0{x=5.0}
)");
    expect_end(r, 5, 0, 0);
    EXPECT_EQ(r.moves.size(), 1U);
}

TEST(Services, RejectInitialPositionDuringRun) {
    const Outcome r =
        expect_true("G0{x=5.0}\nassert(rrs.SetInitialPosition({100, 0, 0, 0, 0}) < 0)\nG0{y=5.0}\n");
    expect_end(r, 5, 5, 0);
}

TEST(Services, ForwardAndInverseKinematicsAgree) {
    expect_true(R"(
local status, pose = rrs.GetForwardKinematics({300, 400, 200, 0.5, 0.25})
assert(status == 0 and #pose == 4 and #pose[1] == 4)
assert(math.abs(pose[1][4] - 300) < 1e-9 and math.abs(pose[2][4] - 400) < 1e-9 and math.abs(pose[3][4] - 200) < 1e-9)
assert(pose[4][1] == 0 and pose[4][4] == 1)
local again, joints = rrs.GetInverseKinematics(pose, {0, 0, 0, 0.4, 0.2})
assert(again == 0)
for i, wanted in ipairs({300, 400, 200, 0.5, 0.25}) do assert(math.abs(joints[i] - wanted) < 1e-9) end
assert(rrs.GetInverseKinematics(pose) == 0)
)");
}

TEST(Services, GetNextStepReturnsSteps) {
    const Outcome r = run_lua(R"(
rrs.SelectTargetType("joint") rrs.SelectMotionType("linear") rrs.SetCartesianPositionSpeed(100)
rrs.SetInterpolationTime(0.1)
rrs.SetNextTarget({100, 0, 0, 0, 0})
local last, seconds, status, joints, pose, elapsed = -1, 0
repeat
  status, joints, pose, elapsed = rrs.GetNextStep()
  assert(status >= 0 and joints[1] >= last and pose[1][4] == joints[1] and elapsed >= 0)
  last, seconds = joints[1], seconds + elapsed
until status ~= 0
assert(status == 2 and last == 100)  -- RRS_TARGET_REACHED
assert(math.abs(seconds - (100 / 100 + 100 / 490.33)) < 1e-9, seconds)
assert(rrs.GetNextStep() == 1)  -- RRS_NEED_MORE_DATA
)");
    EXPECT_TRUE(r.completed()) << r.line() << ": " << r.message();
}

TEST(Services, BadArgumentsAreScriptErrors) {
    for (const char* call :
         {"SetNextTarget()", "SetNextTarget({1,2})", "SetNextTarget({1,2,3,4,{}})", "SetNextTarget({{1}})",
          "SetNextTarget({1,2,3,0,0}, 'middle')", "GetForwardKinematics({})", "GetInverseKinematics({1,2,3})",
          "SelectMotionType('spiral')", "SelectMotionType(5)", "SetJointSpeeds({1})",
          "SetCartesianPositionSpeed()", "SelectTargetType()", "GetCellFrame()", "DefineEvent('a')"}) {
        const Outcome r = run_lua(std::string("\nrrs.") + call);
        EXPECT_EQ(r.report.status, simulation::RunStatus::alarm) << call;
        EXPECT_EQ(r.line(), 2U) << call << ": " << r.message();
    }
}

TEST(Services, RejectNonFiniteValues) {
    for (const char* call :
         {"SetCartesianPositionSpeed(0/0)", "SetNextTarget({0/0,0,0,0,0})", "SetMotionTime(1/0)",
          "SetOverrideSpeed(0/0)", "SetJointSpeeds(0/0)", "SetInterpolationTime(-1)", "SetRestParameter(0/0)",
          "SetInitialPosition({0/0,0,0,0,0})", "GetForwardKinematics({0/0,0,0,0,0})"})
        expect_true(fmt::format("local s = rrs.{} assert(s < 0, s)", call));
}

}  // namespace
}  // namespace gsim::script::rrs_test
