// Robot-neutral moves: the pose at the end, by forward kinematics, is the pose that was asked for.

#include <numbers>

#include <fmt/format.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::neutral_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadPerDeg = kPi / 180;

// The tool's pose at the end of a move.
rrs::CartPos pose_after(const Outcome& r, std::size_t n) {
    return machine::make_kinematics(r.machine)->forward(r.moves.at(n).end);
}

// Compares with x, y, z in mm and roll, pitch, yaw in deg.
void expect_pose(const rrs::CartPos& got, std::array<double, 6> expected_value) {
    kinematics::Rpy rpy{expected_value[0], expected_value[1], expected_value[2]};
    rpy.roll_rad = expected_value[3] * kRadPerDeg;
    rpy.pitch_rad = expected_value[4] * kRadPerDeg;
    rpy.yaw_rad = expected_value[5] * kRadPerDeg;
    const rrs::CartPos pose = kinematics::pose_from_rpy(rpy);
    EXPECT_LT((got.matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-6) << got.matrix() << "\nwanted\n"
                                                                          << pose.matrix();
}

// Returns the roll, pitch and yaw of poses that the two rotary axes reach exactly, from the machine's own
// kinematics.
std::array<double, 6> reachable(double x, double y, double z, double b_deg, double c_deg) {
    rrs::JointPos joints(5);
    joints << x, y, z, b_deg * kRadPerDeg, c_deg * kRadPerDeg;
    const kinematics::Rpy rpy =
        kinematics::rpy_from_pose(machine::make_kinematics(built_in_machine())->forward(joints));
    return {rpy.x_mm,
            rpy.y_mm,
            rpy.z_mm,
            rpy.roll_rad / kRadPerDeg,
            rpy.pitch_rad / kRadPerDeg,
            rpy.yaw_rad / kRadPerDeg};
}

std::string text(const std::array<double, 6>& pose) {
    return fmt::format("{{x={:.12f}, y={:.12f}, z={:.12f}, roll={:.12f}, pitch={:.12f}, yaw={:.12f}}}",
                       pose[0], pose[1], pose[2], pose[3], pose[4], pose[5]);
}

TEST(NeutralMoves, LinearMovesReachPose) {
    const auto first = reachable(100, 200, 50, 0, 0);
    const auto second = reachable(300, 250, 150, 40, 30);
    const Outcome r = run_lua("F(6000)\nMoveLinear" + text(first) + "\nMoveLinear" + text(second));
    ASSERT_TRUE(r.completed()) << r.message();
    ASSERT_EQ(r.moves.size(), 2U);
    expect_pose(pose_after(r, 0), first);
    expect_pose(pose_after(r, 1), second);
    EXPECT_EQ(r.moves[1].info.kind, simulation::MoveKind::linear);
    EXPECT_NEAR(r.moves[1].length_mm, std::sqrt(200 * 200 + 50 * 50 + 100 * 100), 1e-6);
    EXPECT_NEAR(
        r.seconds(0),
        std::max(trapezoid_s(std::sqrt(100 * 100 + 200 * 200 + 50 * 50), 100, kAcceleration_mm_s2), 0.0),
        1e-6);
    EXPECT_EQ(r.moves[1].info.location.line, 3U);
}

TEST(NeutralMoves, JointMovesMoveAllJointsTogether) {
    const auto pose = reachable(300, 600, 150, 40, 30);
    const Outcome r = run_lua("MoveJoint" + text(pose));
    ASSERT_TRUE(r.completed()) << r.message();
    expect_pose(pose_after(r, 0), pose);
    // The slowest joint rules: B with 40 deg at 20 deg/s2.
    const double slowest =
        std::max(trapezoid_s(600, 508, kAcceleration_mm_s2), trapezoid_s(40, 90, kTurn_deg_s2));
    EXPECT_NEAR(r.seconds(0), slowest, 1e-6);
    const motion::Segment& move = r.segments.back();
    // All joints start and arrive together, by laws that are symmetric in time: half of the path at half
    // time.
    const rrs::JointPos middle = move.position_at(move.duration_s / 2);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(middle[i], (move.start[i] + move.end[i]) / 2, 1e-9);
}

TEST(NeutralMoves, CircularMovesPassViaPoint) {
    const auto start = reachable(100, 100, 100, 0, 0);
    const auto via = reachable(110, 110, 100, 0, 0);
    const auto to = reachable(120, 100, 100, 0, 0);
    const Outcome r = run_lua("F(3000) MoveLinear" + text(start) + "\nMoveCircular{via=" + text(via) +
                              ", to=" + text(to) + "}");
    ASSERT_TRUE(r.completed()) << r.message();
    expect_pose(pose_after(r, 1), to);
    EXPECT_NEAR(r.moves[1].length_mm, 10 * kPi, 1e-6);
    const motion::Segment& arc = r.segments.back();
    EXPECT_NEAR(arc.position_at(arc.duration_s / 2)[0], 110, 1e-6);
    EXPECT_NEAR(arc.position_at(arc.duration_s / 2)[1], 110, 1e-6);
}

TEST(NeutralMoves, PosesIgnoreWorkFramesAndUnits) {
    const auto pose = reachable(100, 200, 50, 0, 0);
    const Outcome r = run_lua("G20() G91() G52{x=5.0} F(100) MoveLinear" + text(pose));
    ASSERT_TRUE(r.completed()) << r.message();
    expect_pose(pose_after(r, 0), pose);
}

TEST(NeutralMoves, RejectsPoseOutOfRangeAndMissingFeed) {
    const auto far = reachable(5000, 200, 50, 0, 0);
    expect_alarm(run_lua("F(100)\nMoveLinear" + text(far)), 2, {"axis X", "5000"});
    expect_alarm(run_lua("\nMoveLinear" + text(reachable(100, 200, 50, 0, 0))), 2, {"no feed"});
}

Conditions with_machine(const std::string& name) {
    Conditions conditions;
    conditions.machine = machine::load_machine(tests::source_path("samples/machines/") + name).value();
    return conditions;
}

TEST(NeutralMoves, PosesOfMillAreRelativeToWork) {
    const Outcome r = run_lua("F(1000)\nMoveLinear{x=50, y=20, z=60, roll=30, yaw=-40}",
                              with_machine("mill-table-table.toml"));
    ASSERT_TRUE(r.completed()) << r.message();
    expect_pose(pose_after(r, 0), {50, 20, 60, 30, 0, -40});
    EXPECT_NEAR(r.to(0, 'C'), 30, 1e-9);
    EXPECT_NEAR(r.to(0, 'A'), -40, 1e-9);
}

TEST(NeutralMoves, ArmReachesPosesAndReportsUnreachableOnes) {
    const Conditions arm = with_machine("arm6.toml");
    const Outcome r = run_lua("MoveJoint{x=500, y=100, z=300, pitch=150}", arm);
    ASSERT_TRUE(r.completed()) << r.message();
    expect_pose(pose_after(r, 0), {500, 100, 300, 0, 150, 0});
    EXPECT_TRUE(r.report.messages.warnings.empty());
    expect_alarm(run_lua("\nMoveJoint{x=3000}", arm), 2, {"The pose is out of reach", " mm and ", "aligned"});
}

// The wrist of the arm straight.
TEST(NeutralMoves, WarnsAboutSingularPoseWithLineAndAxes) {
    Conditions arm = with_machine("arm6.toml");
    for (machine::Axis& axis : arm.machine.axes) {
        if (axis.letter == 'V') axis.home = 0;
    }
    const rrs::CartPos pose =
        machine::make_kinematics(arm.machine)->forward(machine::home_position(arm.machine));
    const kinematics::Rpy rpy = kinematics::rpy_from_pose(pose);
    const Outcome r = run_lua("\nMoveJoint" + text({rpy.x_mm, rpy.y_mm, rpy.z_mm, rpy.roll_rad / kRadPerDeg,
                                                    rpy.pitch_rad / kRadPerDeg, rpy.yaw_rad / kRadPerDeg}),
                              arm);
    ASSERT_EQ(r.report.messages.warnings.size(), 1U);
    EXPECT_EQ(r.report.messages.warnings[0],
              "part.lua:2: the pose is singular: axes U and W are aligned and can turn against each other "
              "without moving the tool");
}

TEST(NeutralMoves, RejectsPoseIfMachineHasNoInverse) {
    Conditions conditions;
    conditions.machine.inverse = machine::InverseKind::none;
    const Outcome r = run_lua("F(100)\nMoveLinear{x=1}", conditions);
    EXPECT_EQ(r.report.status, simulation::RunStatus::alarm);
    EXPECT_EQ(r.line(), 2U);
    EXPECT_FALSE(r.message().empty());
}

}  // namespace
}  // namespace gsim::script::neutral_test
