// Groups of axes with moves to poses: an arm on a track in front of a turntable, compared with geometry.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::groups_test {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kRadPerDeg = kPi / 180;
constexpr Eigen::Index kTrack = 0;  // joints of arm6-cell.toml
constexpr Eigen::Index kTable = 7;
constexpr double kTableAcceleration_deg_s2 = 200;
constexpr double kTrackAcceleration_mm_s2 = 2000;
constexpr double kOffWay_mm = 1.05e-3;  // tcp_tolerance_mm
const Vector3d kTableAxis_mm(0, -600, -300);

const std::string kToTheRim = "MoveJoint{x=200, y=0, z=10, yaw=180}\n";

Conditions in_the_cell(rrs::PlannerKind planner = rrs::PlannerKind::rest_to_rest) {
    Conditions conditions;
    conditions.machine = machine::load_machine(tests::source_path("samples/machines/arm6-cell.toml")).value();
    conditions.machine.controller.planner = planner;
    return conditions;
}

/// A run with its joints at any time.
class GroupRun {
  public:
    explicit GroupRun(const std::string& lua, const Conditions& conditions = in_the_cell())
        : run(run_lua(lua, conditions)), kinematics(machine::make_kinematics(run.machine)) {}

    motion::JointState at(double t_s) const {
        const auto next = std::upper_bound(run.segments.begin(), run.segments.end(), t_s,
                                           [](double t, const motion::Segment& s) { return t < s.end_s(); });
        const motion::Segment& segment = next == run.segments.end() ? run.segments.back() : *next;
        return segment.at(t_s - segment.start_s);
    }
    /// Returns the TCP on the work.
    Vector3d tcp(const rrs::JointPos& joints) const { return kinematics->forward(joints).translation(); }
    /// Returns the TCP in the world.
    Vector3d tip_in_world(const rrs::JointPos& joints) const {
        return kinematics->chain().tool_frames(joints).back().translation();
    }
    /// Calls `look` with the state at a thousand times of a move.
    template <typename Visitor>
    void in_move(std::size_t n, const Visitor& look) const {
        const auto& move = run.moves.at(n);
        for (int i = 0; i <= 1000; ++i) look(at(move.start_s + (move.end_s - move.start_s) * i / 1000));
    }

    Outcome run;
    std::shared_ptr<const kinematics::Kinematics> kinematics;
};

double off_line(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d displacement = (to - from).normalized();
    return (point - from - displacement * displacement.dot(point - from)).norm();
}

void expect_limits_held(const GroupRun& r) {
    const motion::PlannerSetup setup = simulation::make_planner_setup(r.run.machine);
    constexpr double kWindow_s = 0.01;
    const double end_s = r.run.segments.back().end_s();
    for (double t = 0; t + kWindow_s < end_s; t += end_s / 2000) {
        const motion::JointState now = r.at(t), later = r.at(t + kWindow_s);
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const motion::JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
            ASSERT_LE(std::abs(now.velocity[joint]), limits.max_speed * (1 + 1e-9)) << joint << " at " << t;
            ASSERT_LE(std::abs(later.velocity[joint] - now.velocity[joint]) / kWindow_s,
                      limits.max_acceleration * 1.05)
                << joint << " at " << t;
        }
    }
}

// A quarter of a round seam: the table turns under the stationary tool. The point under it moves at F.
TEST(GroupMoves, TableTurnsUnderStationaryTool) {
    for (const auto planner : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        const GroupRun r(
            "F(1200)\n" + kToTheRim +
                "MoveCircular{via={x=141.4213562373095, y=-141.4213562373095, z=10, roll=-45, yaw=180},\n"
                "  to={x=0, y=-200, z=10, roll=-90, yaw=180, turntable={z=90}}}\n",
            in_the_cell(planner));
        ASSERT_TRUE(r.run.completed()) << r.run.message();
        const double speed_deg_s = 20.0 / 200 / kRadPerDeg;
        EXPECT_NEAR(r.run.seconds(1), 90 / speed_deg_s + speed_deg_s / kTableAcceleration_deg_s2, 1e-6);
        EXPECT_NEAR(r.run.moves[1].length_mm, 100 * kPi, 1e-6);
        const rrs::JointPos stand = r.run.moves[0].end;
        r.in_move(1, [&](const motion::JointState& state) {
            for (Eigen::Index joint = 0; joint < kTable; ++joint)
                EXPECT_NEAR(state.position[joint], stand[joint], 1e-8) << joint;
            const Vector3d under = r.tcp(state.position);
            EXPECT_NEAR(std::hypot(under.x(), under.y()), 200, kOffWay_mm);
        });
        const auto& move = r.run.moves[1];
        EXPECT_NEAR(r.at((move.start_s + move.end_s) / 2).velocity[kTable] * 200, 20, 1e-9);
    }
}

// On the table the TCP's path is a line, whatever the table does meanwhile; it turns evenly along it.
TEST(GroupMoves, CoordinatedLineIsStraightOnTable) {
    for (const auto planner : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        const GroupRun r(
            "F(3000)\n" + kToTheRim + "MoveLinear{x=120, y=80, z=10, yaw=180, turntable={z=-60}}\n",
            in_the_cell(planner));
        ASSERT_TRUE(r.run.completed()) << r.run.message();
        const Vector3d from(200, 0, 10), to(120, 80, 10);
        EXPECT_NEAR(r.run.moves[1].length_mm, (to - from).norm(), 1e-6);
        r.in_move(1, [&](const motion::JointState& state) {
            const Vector3d tcp = r.tcp(state.position);
            EXPECT_LT(off_line(tcp, from, to), kOffWay_mm);
            const double share = (tcp - from).norm() / (to - from).norm();
            EXPECT_NEAR(state.position[kTable] / kRadPerDeg, -60 * share, 1e-2);
        });
        EXPECT_LT((r.tcp(r.run.moves[1].end) - to).norm(), 1e-6);
        EXPECT_NEAR(r.run.to(1, 'Z'), -60, 1e-9);
        expect_limits_held(r);
    }
}

// In the world the tool moves straight to the future position of the point on the table; both arrive
// together.
TEST(GroupMoves, SynchronousLineIsStraightInWorld) {
    const GroupRun r("F(3000)\n" + kToTheRim +
                     "group('turntable').synchronous()\n"
                     "MoveLinear{x=120, y=80, z=10, roll=-60, yaw=180, turntable={z=60}}\n");
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    const Vector3d from = kTableAxis_mm + Vector3d(200, 0, 10);
    const Vector3d to = kTableAxis_mm + Eigen::AngleAxisd(kPi / 3, Vector3d::UnitZ()) * Vector3d(120, 80, 10);
    EXPECT_NEAR(r.run.moves[1].length_mm, (to - from).norm(), 1e-6) << "of the tool's own way";
    r.in_move(1, [&](const motion::JointState& state) {
        const Vector3d tcp = r.tip_in_world(state.position);
        EXPECT_LT(off_line(tcp, from, to), kOffWay_mm);
        EXPECT_NEAR(state.position[kTable] / kRadPerDeg, 60 * (tcp - from).norm() / (to - from).norm(), 1e-2);
    });
    EXPECT_LT((r.tcp(r.run.moves[1].end) - Vector3d(120, 80, 10)).norm(), 1e-6);
    expect_limits_held(r);
}

// The track carries the arm away below a stationary TCP; the feed is then the track's.
TEST(GroupMoves, TrackMovesBelowStationaryTcp) {
    const GroupRun r("F(600)\n" + kToTheRim + "MoveLinear{x=200, y=0, z=10, yaw=180, track={x=300}}\n");
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    EXPECT_NEAR(r.run.to(1, 'X'), 300, 1e-9);
    r.in_move(1, [&](const motion::JointState& state) {
        EXPECT_LT((r.tcp(state.position) - Vector3d(200, 0, 10)).norm(), kOffWay_mm);
    });
    EXPECT_GE(r.run.seconds(1), 300 / 10.0 + 10 / kTrackAcceleration_mm_s2 - 1e-9);
    EXPECT_LE(r.run.seconds(1), 300 / 10.0 + 0.1);
    expect_limits_held(r);
}

// The arm is stationary on its base, and the track alone carries the TCP: in closed form.
TEST(GroupMoves, TrackCarriesStationaryArm) {
    const GroupRun r("F(6000)\n" + kToTheRim + "MoveLinear{x=-200, y=0, z=10, yaw=180, track={x=-400}}\n");
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    EXPECT_NEAR(r.run.seconds(1), 400 / 100.0 + 100 / kTrackAcceleration_mm_s2, 1e-6);
    const rrs::JointPos stand = r.run.moves[0].end;
    r.in_move(1, [&](const motion::JointState& state) {
        for (Eigen::Index joint = kTrack + 1; joint < kTable; ++joint)
            EXPECT_NEAR(state.position[joint], stand[joint], 1e-8) << joint;
    });
}

TEST(GroupMoves, SynchronousTrackKeepsLineOfArm) {
    const GroupRun r("F(3000)\n" + kToTheRim +
                     "group('track').synchronous()\nMoveLinear{x=150, y=60, z=60, yaw=180, track={x=250}}\n");
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    const auto on_base = [&](const rrs::JointPos& joints) {
        return Vector3d(r.tip_in_world(joints) - joints[kTrack] * Vector3d::UnitX());
    };
    const Vector3d from = on_base(r.run.moves[0].end), to = on_base(r.run.moves[1].end);
    EXPECT_LT((r.tcp(r.run.moves[1].end) - Vector3d(150, 60, 60)).norm(), 1e-6);
    r.in_move(1, [&](const motion::JointState& state) {
        EXPECT_LT(off_line(on_base(state.position), from, to), kOffWay_mm);
    });
}

// A ring in four quarters under a stationary torch, and a seam along the rail with a stationary arm.
TEST(GroupMoves, SampleMatchesGeometry) {
    std::ifstream file(tests::source_path("samples/cell/seam.lua"));
    const GroupRun r(std::string(std::istreambuf_iterator<char>(file), {}));
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    ASSERT_EQ(r.run.moves.size(), 8U);
    const double speed_deg_s = 20.0 / 200 / kRadPerDeg;
    for (const std::size_t quarter : {2, 3, 4, 5}) {
        EXPECT_NEAR(r.run.seconds(quarter), 90 / speed_deg_s + speed_deg_s / kTableAcceleration_deg_s2, 1e-6);
        EXPECT_LT((r.tip_in_world(r.run.moves[quarter].end) - kTableAxis_mm - Vector3d(200, 0, 10)).norm(),
                  1e-6);
    }
    EXPECT_NEAR(r.run.to(5, 'Z'), 360, 1e-9);
    EXPECT_NEAR(r.run.seconds(6), 400 / 100.0 + 100 / kTrackAcceleration_mm_s2, 1e-6);
    EXPECT_NEAR(r.run.to(7, 'Z'), 0, 1e-9);
    EXPECT_GE(r.run.seconds(7), 360 / 120.0 + 120 / kTableAcceleration_deg_s2 - 1e-9) << "the table governs";
}

TEST(GroupMoves, MovesToPosesKeepGroupPositions) {
    const GroupRun r(
        kToTheRim +
        "MoveJoint{x=150, y=20, z=40, yaw=180, track={x=100}, turntable={z=30}}\n"
        "F(3000) MoveLinear{x=100, y=20, z=60, yaw=180}\nMoveJoint{x=200, y=0, z=20, yaw=170}\n");
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    EXPECT_LT((r.tcp(r.run.moves[1].end) - Vector3d(150, 20, 40)).norm(), 1e-6);
    for (const std::size_t move : {1, 2, 3}) {
        EXPECT_NEAR(r.run.to(move, 'X'), 100, 1e-12) << move;
        EXPECT_NEAR(r.run.to(move, 'Z'), 30, 1e-12) << move;
    }
    r.in_move(2, [&](const motion::JointState& state) { EXPECT_NEAR(state.position[kTrack], 100, 1e-12); });
}

TEST(GroupMoves, InverseKeepsGroupJoints) {
    const auto kinematics = machine::make_kinematics(in_the_cell().machine);
    EXPECT_EQ(kinematics->fixed_joints(), (std::vector<int>{kTrack, kTable}));
    const rrs::JointPos home = machine::home_position(in_the_cell().machine);
    for (int i = 0; i < 20; ++i) {
        rrs::JointPos joints = home;
        for (Eigen::Index joint = 0; joint < joints.size(); ++joint)
            joints[joint] += 0.02 * i * std::sin(joint + i);
        joints[kTrack] = 40.0 * i - 300;
        joints[kTable] = 0.3 * i;
        rrs::JointPos near = home;
        near[kTrack] = joints[kTrack];
        near[kTable] = joints[kTable];
        const auto found = kinematics->inverse(kinematics->forward(joints), near);
        ASSERT_TRUE(found) << found.error();
        EXPECT_EQ((*found)[kTrack], joints[kTrack]);
        EXPECT_EQ((*found)[kTable], joints[kTable]);
        EXPECT_TRUE(kinematics->forward(*found).isApprox(kinematics->forward(joints), 1e-8));
    }
}

// Returns the position of an independently moving table after a time, at 120 deg/s and 200 deg/s2.
double table_deg_after(double t_s, double way_deg) {
    const double ramp_s = 120.0 / 200, total_s = way_deg / 120 + ramp_s;
    if (t_s >= total_s) return way_deg;
    if (t_s > total_s / 2) return way_deg - table_deg_after(total_s - t_s, way_deg);
    return t_s < ramp_s ? 100 * t_s * t_s : 120 * (t_s - ramp_s / 2);
}

const std::string kByItself = "local t = group 'turntable' t.independent()\n";

// The tool moves along the same path as without the table; neither waits for the other one.
TEST(GroupMoves, IndependentTableTurnsDuringToolMoves) {
    for (const auto planner : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        // The table is at its end: the tool is at the rim again, and moves up from there.
        const std::string moves =
            "F(600)\nMoveLinear{x=0, y=-199, z=11, roll=-90, yaw=180}\n"
            "MoveLinear{x=0, y=-150, z=60, roll=-90, yaw=180}\n";
        const GroupRun r(kByItself + kToTheRim + "t.move{z=90}\n" + moves + "t.wait()\n",
                         in_the_cell(planner));
        ASSERT_TRUE(r.run.completed()) << r.run.message();
        ASSERT_EQ(r.run.moves.size(), 3U) << "nothing waits: the table stands before";
        const double start_s = r.run.moves[1].start_s;
        for (int i = 0; i <= 3000; ++i) {
            const double t_s = i * 0.001;
            const motion::JointState state = r.at(start_s + t_s);
            EXPECT_NEAR(state.position[kTable] / kRadPerDeg, table_deg_after(t_s, 90), 1e-6) << t_s;
        }
        const Vector3d from = kTableAxis_mm + Vector3d(200, 0, 10);
        const Vector3d to = kTableAxis_mm + Vector3d(150, 0, 60);
        for (const std::size_t move : {1, 2}) {
            r.in_move(move, [&](const motion::JointState& state) {
                EXPECT_LT(off_line(r.tip_in_world(state.position), from, to), kOffWay_mm);
            });
        }
        EXPECT_LT((r.tip_in_world(r.run.moves[2].end) - to).norm(), 1e-6);
        expect_limits_held(r);
        const GroupRun without(
            kToTheRim + "MoveJoint{x=0, y=-200, z=10, roll=-90, yaw=180, turntable={z=90}}\n" + moves,
            in_the_cell(planner));
        for (const std::size_t move : {1, 2})
            EXPECT_NEAR(r.run.seconds(move), without.run.seconds(move + 1), 1e-9);
        ASSERT_EQ(r.run.report.events.size(), 1U);
        EXPECT_EQ(r.run.report.events[0].kind, "group");
        EXPECT_EQ(r.run.report.events[0].detail, "turntable to Z90, 1.35 s");
        EXPECT_NEAR(r.run.report.events[0].t_s, start_s, 1e-9);
    }
}

TEST(GroupMoves, WaitsForIndependentGroupOnlyIfNeeded) {
    const double turn_s = 180 / 120.0 + 120 / 200.0;
    const GroupRun waits(kByItself + "t.move{z=180}\nt.wait()\n");
    ASSERT_TRUE(waits.run.completed()) << waits.run.message();
    EXPECT_NEAR(waits.run.report.times.dwell_s, turn_s, 1e-9);
    EXPECT_NEAR(waits.run.to(0, 'Z'), 180, 1e-9);
    const GroupRun ends(kByItself + "t.move{z=180}\n");
    EXPECT_NEAR(ends.run.report.cycle_time_s, turn_s, 1e-9) << "the run ends when it stands";
    const GroupRun leads(kByItself + "t.move{z=180}\nG0{z=0}\n");
    EXPECT_NEAR(leads.run.report.cycle_time_s, 2 * turn_s, 1e-9);
    const GroupRun passes(kByItself + "t.move{z=180}\nG0{x=-100}\nt.wait()\n");
    EXPECT_NEAR(passes.run.report.cycle_time_s, turn_s, 1e-9) << "the track does not wait";
    const GroupRun other(kByItself +
                         "t.move{z=180}\nlocal k = group 'track' k.independent() k.move{x=300}\n");
    EXPECT_NEAR(other.run.report.cycle_time_s, turn_s + 2 * std::sqrt(300 / kTrackAcceleration_mm_s2), 1e-9);
}

TEST(GroupMoves, SCurveOfIndependentGroupEndsAtStandstill) {
    Conditions conditions = in_the_cell();
    conditions.machine.controller.ramps.limit_jerk = true;
    conditions.machine.axes[kTable].max_jerk = 1000;
    const GroupRun r(kByItself + "t.move{z=180}\nG0{x=900}\nG4{p=10}\n", conditions);
    ASSERT_TRUE(r.run.completed()) << r.run.message();
    const double turn_s = 180 / 120.0 + 120 / 200.0 + 200 / 1000.0;
    EXPECT_NEAR(r.at(turn_s).position[kTable] / kRadPerDeg, 180, 1e-6);
    EXPECT_LT(r.at(turn_s - 0.05).position[kTable] / kRadPerDeg, 180 - 1e-4);
    EXPECT_NEAR(r.at(turn_s + 1).position[kTable] / kRadPerDeg, 180, 1e-9);
}

TEST(GroupMoves, ScriptSetsMotionOfGroup) {
    const GroupRun r(
        "local g = group 'turntable'\nprint(g.motion())\ng.synchronous()\n"
        "assert(g.motion() == 'synchronous')\ng.coordinated()\nassert(g.motion() == 'coordinated')\n"
        "g.independent()\nassert(g.motion() == 'independent')\n");
    EXPECT_TRUE(r.run.completed()) << r.run.message();
}

TEST(GroupMoves, RejectsInvalidGroupUse) {
    const auto said = [](const std::string& lua) { return run_lua(lua, in_the_cell()); };
    expect_alarm(said("F(600)\nMoveLinear{x=1, table={z=1}}"), 2,
                 {"MoveLinear", "not 'table'", "its groups are: track, turntable"});
    expect_alarm(said("F(600)\nMoveLinear{x=1, turntable={c=1}}"), 2,
                 {"the group 'turntable' has no axis 'c'", "its axes: z"});
    expect_alarm(said("F(600) MoveLinear{x=1, turntable=90}"), "a table of its axes (z): turntable");
    expect_alarm(said("F(600) MoveLinear{x=1, turntable={z='1'}}"), "the group 'turntable' is not a number");
    expect_alarm(said("group 'turntabel'"), "did you mean 'turntable'?");
    expect_alarm(said("F(600) " + kToTheRim + "MoveLinear{x=2200, z=10, yaw=180, track={x=2000}}"),
                 "axis X would be at 2000 mm, outside its range -1000 .. 1000");
    expect_alarm(said("MoveJoint{x=2200, z=10, yaw=180, track={x=2000}}"),
                 "axis X would be at 2000 mm, outside its range -1000 .. 1000");
    expect_alarm(said("F(600) MoveCircular{via={x=1, track={x=1}}, to={x=2}}"),
                 "the group 'track' must be given in 'to'");
    expect_alarm(said("group('turntable').move{z=1}"), "group(\"turntable\").independent() before");
    expect_alarm(said(kByItself + "F(600) MoveLinear{x=1, turntable={z=1}}"), 2,
                 {"'turntable' is independent", "group(\"turntable\").move{...}"});
    expect_alarm(said("local k = group 'track' k.independent()\nk.move{x=2000}"), 2, {"2000"});
    expect_alarm(said(kByItself + "t.move(90)"), 2, {"a table of its axes (z): turntable"});
    Conditions rounds = in_the_cell(rrs::PlannerKind::look_ahead);
    rounds.machine.controller.corners.continuous = rrs::CornerRule::smooth_blend;
    expect_alarm(run_lua(kByItself + "t.move{z=90}", rounds), "a controller that rounds corners");
    expect_alarm(run_lua("group 'table'"), "groups are defined by tables [[group]] of the machine file");
}

// If a closed inverse finds all axes, words move those of groups, and G43.4 coordinates them.
TEST(GroupMoves, WordsMoveTableOfMill) {
    Conditions conditions;
    conditions.machine =
        machine::load_machine(tests::source_path("samples/machines/mill-table-table.toml")).value();
    conditions.machine.groups.push_back({"table", {3, 4}});
    EXPECT_TRUE(run_lua("F(600) G1{x=10, c=20}", conditions).completed());
    expect_alarm(run_lua("group('table').coordinated()", conditions), "G43.4 coordinates all axes");
    expect_alarm(run_lua("F(600) MoveLinear{z=100, table={c=20}}", conditions),
                 "the group 'table'; move them by words such as G1");
}

}  // namespace
}  // namespace gsim::script::groups_test
