// G43.4 in programs, and moves to poses on machines with a TCP that slides alone do not carry.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::tip_control_test {
namespace {

using Eigen::Vector3d;

Conditions on(const std::string& machine) {
    Conditions conditions;
    conditions.machine =
        machine::load_machine(tests::source_path("samples/machines/") + machine + ".toml").value();
    return with_tools(conditions);
}

/// Returns the TCP of a tool of that length, in the work.
Vector3d tip_after(const Outcome& r, std::size_t n, const Vector3d& tcp_mm = Vector3d::Zero()) {
    return machine::make_kinematics(r.machine)->forward(r.moves.at(n).end) * tcp_mm;
}

TEST(ProgrammedTcpControl, EqualsG43AtRotaryZero) {
    const std::string moves = "G0 X10 Y20 Z90\nG1 X30 Y25 Z80 F600\nG2 X40 Y35 I10 J0\nM30\n";
    for (const std::string machine : {"mill-table-table", "mill-head-table"}) {
        const Outcome with = run("G43.4 H2\n" + moves, on(machine));
        const Outcome without = run("G43 H2\n" + moves, on(machine));
        ASSERT_TRUE(with.completed()) << with.message();
        ASSERT_EQ(with.moves.size(), without.moves.size());
        for (std::size_t i = 0; i < with.moves.size(); ++i) {
            EXPECT_LT((with.moves[i].end - without.moves[i].end).cwiseAbs().maxCoeff(), 1e-9) << i;
            EXPECT_NEAR(with.moves[i].length_mm, without.moves[i].length_mm, 1e-6);
        }
    }
}

TEST(ProgrammedTcpControl, KeepsZonesOfG43) {
    const std::string part = "G0 X10 Y20 Z90\nG22 X100 Y100 Z70 I-100 J-100 K0\nG1 Z60 F600\nM30\n";
    for (const std::string machine : {"mill-table-table", "mill-head-table"}) {
        const Outcome with = run("G43.4 H2\n" + part, on(machine));
        const Outcome without = run("G43 H2\n" + part, on(machine));
        expect_alarm(with, 4, {"enters the zone", "Z70.0000"});
        EXPECT_EQ(with.message(), without.message());
        EXPECT_NEAR(with.report.cycle_time_s, without.report.cycle_time_s, 1e-9);
    }
    // With the head turned the box is still one of the axes.
    const Outcome turned =
        run("G43.4 H2\nG0 X10 Y20 Z130 B30\nG22 X900 Y900 Z70 I-900 J-900 K0\nG1 Z80 F600\nM30\n",
            on("mill-head-table"));
    expect_alarm(turned, 4, {"enters the zone", "axis Z"});
    ASSERT_FALSE(turned.segments.empty());
    const double z = turned.to(turned.moves.size() - 1, 'Z');
    EXPECT_NEAR(z, 70 + 25, 1e-6);
}

TEST(PoseMoves, CurrentPoseTakesNoTime) {
    for (const auto planner : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        Conditions arm = on("arm6");
        arm.machine.controller.planner = planner;
        const std::string pose = "{x=600, y=150, z=10, yaw=180}\n";
        const Outcome r = run_lua("F(600) MoveJoint" + pose + "MoveLinear" + pose + "MoveJoint" + pose, arm);
        ASSERT_TRUE(r.completed()) << r.message();
        EXPECT_NEAR(r.report.cycle_time_s, r.seconds(0), 1e-6);
    }
}

TEST(ProgrammedTcpControl, RotaryAxesKeepTcpPosition) {
    const Outcome r =
        run("G0 X10 Y20 Z90\nG43.4 H2\nG0 A-30 C40\nG1 A-50 C-60 F1000\nM30\n", on("mill-table-table"));
    ASSERT_TRUE(r.completed()) << r.message();
    const auto kinematics = machine::make_kinematics(r.machine);
    const Vector3d tool =
        -25 * (kinematics->forward(r.moves[0].end).linear().transpose() * Vector3d::UnitZ());
    for (std::size_t i = 1; i < r.moves.size(); ++i)
        EXPECT_LT((tip_after(r, i, tool) - tip_after(r, 0, tool)).norm(), 1e-9) << i;
    EXPECT_NEAR(r.to(2, 'C'), -60, 1e-9);
    EXPECT_EQ(r.moves[2].length_mm, 0);
}

TEST(ProgrammedTcpControl, WorkOffsetsAndIncrementsApplyToTcp) {
    const Outcome r = run("G43.4 H0\nG92 X0 Y0 Z0\nG1 B30 C20 F1000\nG91 X5 Y-3 Z-7\nG90 X0 Y0 Z0\nM30\n",
                          on("mill-head-table"));
    ASSERT_TRUE(r.completed()) << r.message();
    const Vector3d first = tip_after(r, 0);
    EXPECT_LT((tip_after(r, 1) - first - Vector3d(5, -3, -7)).norm(), 1e-9);
    EXPECT_LT((tip_after(r, 2) - first).norm(), 1e-9);
    EXPECT_NEAR(r.moves[1].length_mm, std::sqrt(25 + 9 + 49), 1e-9);
}

// As calibration finds machines: coordinates are square though the slides are not.
TEST(ProgrammedTcpControl, SlightlySkewedSlidesMakeSquareParts) {
    Conditions crooked = on("mill-head-table");
    crooked.machine.axes.at(1).frame = machine::Frame{.roll_deg = -0.03, .yaw_deg = 0.02};
    const Outcome r =
        run("G43.4 H0\nG92 X0 Y0 Z0\nG1 B30 C20 F1000\nG91 X5 Y-3 Z-7\nG90 X0 Y0 Z0\nM30\n", crooked);
    ASSERT_TRUE(r.completed()) << r.message();
    const Vector3d first = tip_after(r, 0);
    const Vector3d step = tip_after(r, 1) - first;
    // The slide of Y leans out of the plane of X and Y by 0.02 degrees: that plane is the part's.
    const double tilt_rad = 0.02 * std::acos(-1.0) / 180;
    const Vector3d y(0, std::cos(tilt_rad), std::sin(tilt_rad)),
        z(0, -std::sin(tilt_rad), std::cos(tilt_rad));
    EXPECT_LT((step - (5 * Vector3d::UnitX() - 3 * y - 7 * z)).norm(), 1e-6) << step.transpose();
    EXPECT_LT((tip_after(r, 2) - first).norm(), 1e-9);
    crooked.machine.axes.at(1).frame->roll_deg = 2;
    expect_alarm(run("G43.4 H0\nG1 X1 F100\n", crooked), "X, Y and Z at right angles");
}

TEST(ProgrammedTcpControl, EndsWithG49AndRejectsAxisPositions) {
    const Outcome r = run("G43.4 H1\nG1 B30 C20 F1000\nG49\nG53 G0 X1 Y2 Z300\nM30\n", on("mill-head-table"));
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.to(1, 'X'), 1, 1e-9);
    EXPECT_NEAR(r.to(1, 'Z'), 300, 1e-9);
    for (const std::string word : {"G53 G0 X1", "G28 X1", "G30 Z1"})
        expect_alarm(run("G43.4 H1\n" + word + "\n", on("mill-head-table")), "G43.4");
    expect_alarm(run("G43.4 H1\nG1 X0 F100\n", on("arm6")), "X, Y and Z");
}

TEST(ProgrammedTcpControl, SupportsRs274ngc) {
    Conditions ngc = on("mill-head-table");
    ngc.options.dialect = "rs274ngc";
    const Outcome r = run("T1 M6\nG43.4\nG1 B30 C20 F1000\nG49\nM2\n", ngc);
    ASSERT_TRUE(r.completed()) << r.message();
    const auto kinematics = machine::make_kinematics(r.machine);
    const Vector3d tool =
        -10 * (kinematics->forward(rrs::JointPos::Zero(5)).linear().transpose() * Vector3d::UnitZ());
    const Vector3d home = kinematics->forward(machine::home_position(r.machine)) * tool;
    EXPECT_LT((tip_after(r, 0, tool) - home).norm(), 1e-9);
}

TEST(ProgrammedTcpControl, ReportsAxisAndBlockOfPathOutOfRange) {
    expect_alarm(run("G0 X240\nG43.4 H0\nG1 X240 Y0 A0 C0 F1000\nG1 C180 F5000\n", on("mill-table-table")), 4,
                 {"axis Y", "past its limit"});
}

TEST(PoseMoves, ArmFollowsLinesAndCirclesInSpace) {
    const Outcome r = run_lua(
        "F(6000)\nMoveJoint{x=500, y=100, z=200, pitch=150}\nMoveLinear{x=450, y=250, z=300, pitch=160, "
        "yaw=10}\n"
        "MoveCircular{via={x=430, y=270, z=300, pitch=160, yaw=10}, to={x=410, y=250, z=300, pitch=160, "
        "yaw=10}}",
        on("arm6"));
    ASSERT_TRUE(r.completed()) << r.message();
    ASSERT_EQ(r.moves.size(), 3U);
    EXPECT_NEAR(r.moves[1].length_mm, std::hypot(50, 150, 100), 1e-6);
    const auto kinematics = machine::make_kinematics(r.machine);
    const Vector3d from(500, 100, 200);
    const Vector3d displacement = Vector3d(-50, 150, 100).normalized();
    const Vector3d center(430, 250, 300);
    for (const motion::Segment& segment : r.segments) {
        const Vector3d tcp = kinematics->forward(segment.position_at(segment.duration_s / 2)).translation();
        const Vector3d off = tcp - from;
        if (segment.target_id == 2) {
            EXPECT_LT((off - displacement * displacement.dot(off)).norm(), 0.0011);
        }
        if (segment.target_id == 3) {
            EXPECT_NEAR((tcp - center).norm(), 20, 0.0011);
        }
    }
}

TEST(PoseMoves, ReportBlockOfUnreachablePose) {
    expect_alarm(run_lua("F(6000)\nMoveJoint{x=500, y=100, z=200, pitch=150}\nMoveLinear{x=5000, y=0, z=0}",
                         on("arm6")),
                 3, {"The tool cannot follow its path at X"});
}

}  // namespace
}  // namespace gsim::script::tip_control_test
