// Moves of the TCP in the work frame with curved paths of the joints: TCP control of 5-axis mills, and
// Cartesian targets of an arm.

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"
#include "motion/path/tool_path.h"
#include "motion/services/default_planner.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/build_files/build_files.h"

namespace gsim::motion::tool_moves_test {
namespace {

using Eigen::Vector3d;
using rrs::JointPos;
using rrs::PlannerKind;
using rrs::Status;
using testing::HasSubstr;

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr double kRounding_mm = 1e-6;

PlannerSetup sample(const std::string& name, PlannerKind planner = PlannerKind::rest_to_rest) {
    machine::Machine machine =
        machine::load_machine(tests::source_path("samples/machines/") + name + ".toml").value();
    machine.controller.planner = planner;
    machine.controller.corners.continuous = rrs::CornerRule::velocity_step;
    return simulation::make_planner_setup(machine);
}

JointPos joints_of(const std::vector<double>& mm_and_deg, const PlannerSetup& setup) {
    JointPos joints(setup.joint_count());
    int i = 0;
    for (const double value : mm_and_deg) {
        joints[i] = setup.role(i) == JointRole::rotary ? value * kRadPerDeg : value;
        ++i;
    }
    return joints;
}

class StoredSegments : public SegmentSink {
  public:
    void on_segment(const Segment& segment) override { segments.push_back(segment); }
    double end_s() const { return segments.empty() ? 0 : segments.back().end_s(); }
    JointState at(double t_s) const {
        const auto next = std::upper_bound(segments.begin(), segments.end(), t_s,
                                           [](double t, const Segment& one) { return t < one.end_s(); });
        const Segment& segment = next == segments.end() ? segments.back() : *next;
        return segment.at(t_s - segment.start_s);
    }

    std::vector<Segment> segments;
};

/// A planner of a sample machine, and what it has planned.
struct ToolRun {
    ToolRun(PlannerSetup machine, const JointPos& start) : setup(std::move(machine)), planner(setup, &kept) {
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), start, "");
        planner.SelectMotionType(rrs::MotionType::linear);
    }
    Status to(const JointPos& joints) {
        return planner.SetNextTarget(++id, rrs::TargetParam::end, rrs::CartPos::Identity(), joints, "", 0);
    }
    Vector3d tcp(const JointPos& joints) const { return setup.kinematics->forward(joints) * tcp_mm; }
    void control_tip(const Vector3d& tcp) {
        tcp_mm = tcp;
        ASSERT_EQ(planner.SetTipControl(true, tcp), Status::RRS_SUCCESS) << message();
    }
    std::string message() {
        std::string text;
        planner.GetMessage(text);
        return text;
    }

    PlannerSetup setup;
    StoredSegments kept;
    DefaultPlanner planner;
    Vector3d tcp_mm = Vector3d::Zero();
    rrs::TargetId id = 0;
};

double distance_to_line(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d displacement = (to - from).normalized();
    return (point - from - displacement * displacement.dot(point - from)).norm();
}

/// Expects that speeds hold at any instant. Accelerations hold over a time in which some parts pass, because
/// speeds jump a little between two of them.
void expect_limits_held(const ToolRun& run, double window_s = 0.01) {
    const double step_s = run.kept.end_s() / 2000;
    for (double t = 0; t + window_s < run.kept.end_s(); t += step_s) {
        const JointState now = run.kept.at(t);
        const JointState later = run.kept.at(t + window_s);
        for (int joint = 0; joint < run.setup.joint_count(); ++joint) {
            const JointSetup& limits = run.setup.joints[static_cast<std::size_t>(joint)];
            ASSERT_LE(std::abs(now.velocity[joint]), limits.max_speed * (1 + 1e-9)) << joint << " at " << t;
            ASSERT_LE(std::abs(later.velocity[joint] - now.velocity[joint]) / window_s,
                      limits.max_acceleration * 1.05)
                << joint << " at " << t;
        }
    }
}

struct Case {
    std::string machine;
    std::vector<double> start;
    std::vector<double> end;
};

void PrintTo(const Case& one, std::ostream* out) {
    *out << one.machine;
}

class TcpControlMoves : public testing::TestWithParam<std::tuple<Case, PlannerKind>> {
  protected:
    TcpControlMoves()
        : run(sample(std::get<0>(GetParam()).machine, std::get<1>(GetParam())),
              joints_of(std::get<0>(GetParam()).start, setup())) {
        run.control_tip({3, -4, -60});
    }
    static const PlannerSetup& setup() {
        static PlannerSetup kept;
        kept = sample(std::get<0>(GetParam()).machine);
        return kept;
    }
    JointPos end() const { return joints_of(std::get<0>(GetParam()).end, run.setup); }

    ToolRun run;
};

TEST_P(TcpControlMoves, TcpFollowsLineAtFeed) {
    const Vector3d from = run.tcp(run.planner.position());
    const Vector3d to = run.tcp(end());
    run.planner.SetCartesianPositionSpeed(5);
    ASSERT_EQ(run.to(end()), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    EXPECT_TRUE(run.planner.position().isApprox(end(), 1e-12));
    ASSERT_GT(run.kept.segments.size(), 10U);
    double length_mm = 0;
    for (const Segment& segment : run.kept.segments) {
        EXPECT_EQ(segment.target_id, 1);
        length_mm += segment.length_mm;
    }
    EXPECT_NEAR(length_mm, (to - from).norm(), 1e-6);
    const double end_s = run.kept.end_s();
    constexpr double kStep_s = 1e-3;
    int at_feed = 0;
    for (int i = 0; i < 5000; ++i) {
        const double t = end_s * i / 5000;
        const Vector3d current = run.tcp(run.kept.at(t).position);
        ASSERT_LE(distance_to_line(current, from, to), 0.001 + kRounding_mm) << t;
        const Vector3d next = run.tcp(run.kept.at(std::min(t + kStep_s, end_s)).position);
        const double speed = (next - current).norm() / kStep_s;
        ASSERT_LE(speed, 5 * 1.02) << t;
        if (speed > 5 * 0.98) ++at_feed;
    }
    EXPECT_GT(at_feed, 4500);
    expect_limits_held(run);
}

TEST_P(TcpControlMoves, JointLimitsReduceFeed) {
    run.planner.SetCartesianPositionSpeed(1e4);
    ASSERT_EQ(run.to(end()), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    expect_limits_held(run);
}

TEST_P(TcpControlMoves, RotaryAxesTurnAboutTcp) {
    JointPos target = run.planner.position();
    const Vector3d tcp = run.tcp(target);
    for (int joint = 0; joint < run.setup.joint_count(); ++joint)
        if (run.setup.role(joint) == JointRole::rotary) target[joint] = end()[joint];
    target = solve_slides(run.setup, target, run.tcp_mm, tcp).value();
    run.planner.SetCartesianOrientationSpeed(0.1);
    ASSERT_EQ(run.to(target), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    double turned = 0;
    for (int i = 0; i <= 2000; ++i) {
        const JointState state = run.kept.at(run.kept.end_s() * i / 2000);
        ASSERT_LE((run.tcp(state.position) - tcp).norm(), 0.001 + kRounding_mm) << i;
        double rate = 0;
        for (int joint = 0; joint < run.setup.joint_count(); ++joint)
            if (run.setup.role(joint) == JointRole::rotary) rate = std::hypot(rate, state.velocity[joint]);
        turned = std::max(turned, rate);
    }
    EXPECT_NEAR(turned, 0.1, 1e-6);
    for (const Segment& segment : run.kept.segments) EXPECT_EQ(segment.length_mm, 0);
}

TEST_P(TcpControlMoves, TcpFollowsArc) {
    const Vector3d from = run.tcp(run.planner.position());
    const Vector3d center = from + Vector3d(0, 20, 0);
    JointPos target = end();  // a half circle about Z of the work, while the axes turn
    target = solve_slides(run.setup, target, run.tcp_mm, from + Vector3d(0, 40, 0)).value();
    run.planner.SetCartesianPositionSpeed(10);
    ASSERT_EQ(run.planner.SetNextArcTarget(1, center, Vector3d::UnitZ(), std::numbers::pi,
                                           rrs::CartPos::Identity(), target),
              Status::RRS_SUCCESS)
        << run.message();
    run.planner.flush();
    for (int i = 0; i <= 2000; ++i) {
        const Vector3d tcp = run.tcp(run.kept.at(run.kept.end_s() * i / 2000).position);
        ASSERT_NEAR((tcp - center).norm(), 20, 0.001 + kRounding_mm) << i;
        ASSERT_NEAR(tcp.z(), from.z(), 0.001 + kRounding_mm) << i;
        ASSERT_GE(tcp.x(), from.x() - 0.001) << i;  // counter-clockwise from the nearest point in Y
    }
    expect_limits_held(run);
}

INSTANTIATE_TEST_SUITE_P(
    Machines, TcpControlMoves,
    testing::Combine(
        testing::Values(Case{"mill-table-table", {20, -30, 150, -10, 20}, {60, 40, 200, -55, 130}},
                        Case{"mill-head-table", {20, -30, 150, 10, 20}, {60, 40, 200, 60, -100}},
                        Case{"gantry-offset-head", {900, 800, 300, 10, 20}, {1000, 900, 350, 90, -40}}),
        testing::Values(PlannerKind::rest_to_rest, PlannerKind::look_ahead, PlannerKind::linuxcnc)));

TEST(ToolMoves, InverseTimeFeedIsTimeOfCompletePath) {
    const PlannerSetup setup = sample("mill-table-table", PlannerKind::look_ahead);
    ToolRun run(setup, joints_of({20, -30, 150, -10, 20}, setup));
    run.control_tip(Vector3d::Zero());
    run.planner.SetMotionTime(30);
    ASSERT_EQ(run.to(joints_of({60, 40, 200, -55, 130}, setup)), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    EXPECT_NEAR(run.kept.end_s(), 30, 0.1);
}

TEST(ToolMoves, MovesInOneDirectionContinueWithoutStop) {
    const PlannerSetup setup = sample("mill-head-table", PlannerKind::look_ahead);
    ToolRun run(setup, joints_of({20, -30, 150, 10, 20}, setup));
    run.control_tip(Vector3d::Zero());
    run.planner.SetPathMode(rrs::PathMode::continuous, 0, 0);
    run.planner.SetCartesianPositionSpeed(5);
    const JointPos start = run.planner.position();
    const JointPos end = joints_of({60, 40, 200, 60, 60}, setup);
    const Vector3d from = run.tcp(start);
    const Vector3d to = run.tcp(end);
    const JointPos middle = solve_slides(setup, (start + end) / 2, run.tcp_mm, (from + to) / 2).value();
    ASSERT_EQ(run.to(middle), Status::RRS_SUCCESS);
    ASSERT_EQ(run.to(end), Status::RRS_SUCCESS);
    run.planner.flush();
    EXPECT_NEAR(run.kept.end_s(), (to - from).norm() / 5, 0.2);
    double slowest = 5;
    for (const Segment& segment : run.kept.segments)
        if (segment.target_id == 2 && segment.start_s < run.kept.end_s() / 2 + 1)
            slowest = std::min(slowest, segment.master.start_speed());
    EXPECT_GT(slowest, 4.9);
}

TEST(ToolMoves, RejectTcpControlWithoutThreeSlides) {
    const PlannerSetup setup = sample("arm6");
    ToolRun run(setup, joints_of({0, 45, -45, 0, 30, 0}, setup));
    EXPECT_EQ(run.planner.SetTipControl(true, Vector3d::Zero()), Status::RRS_MODE_NOT_SUPPORTED);
    EXPECT_EQ(run.planner.SetTipControl(false, Vector3d::Zero()), Status::RRS_SUCCESS);
}

TEST(ToolMoves, RejectPathOutOfRange) {
    const PlannerSetup setup = sample("mill-table-table");
    ToolRun run(setup, joints_of({0, 0, 100, 0, 0}, setup));
    run.control_tip(Vector3d::Zero());
    run.planner.SetCartesianPositionSpeed(50);
    JointPos end = joints_of({0, 0, 100, 0, 180}, setup);  // the ends are alike, the middle is 3 m off
    end = solve_slides(setup, end, Vector3d::Zero(), run.tcp(run.planner.position())).value();
    EXPECT_EQ(run.to(end), Status::RRS_SUCCESS);  // on the axis of the table no joint has to move
    JointPos start = joints_of({200, 0, 100, 0, 0}, setup);
    ToolRun far(setup, start);
    far.control_tip({300, 0, 0});
    far.planner.SetCartesianPositionSpeed(50);
    end = solve_slides(setup, joints_of({200, 0, 100, 0, 90}, setup), far.tcp_mm, far.tcp(start)).value();
    EXPECT_EQ(far.to(end), Status::RRS_JOINT_LIMIT);
}

class ArmMoves : public testing::TestWithParam<PlannerKind> {
  protected:
    ArmMoves() : setup(sample("arm6", GetParam())), run(setup, joints_of({10, 45, -60, 20, 40, 10}, setup)) {
        run.planner.SelectTargetType(rrs::TargetType::cartesian);
        run.planner.SelectMotionType(rrs::MotionType::linear);
        run.planner.SetCartesianPositionSpeed(50);
        start = setup.kinematics->forward(run.planner.position());
    }
    Status to(const rrs::CartPos& pose, rrs::TargetParam param = rrs::TargetParam::end) {
        return run.planner.SetNextTarget(++run.id, param, pose, JointPos(), "", 0);
    }

    PlannerSetup setup;
    ToolRun run;
    rrs::CartPos start;
};

TEST_P(ArmMoves, TcpFollowsLineAndToolTurnsEvenly) {
    rrs::CartPos end = start;
    end.translation() += Vector3d(-120, 150, 80);
    end.rotate(Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()));
    ASSERT_EQ(to(end), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    const double length_mm = (end.translation() - start.translation()).norm();
    int at_feed = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double t = run.kept.end_s() * i / 2000;
        const rrs::CartPos pose = setup.kinematics->forward(run.kept.at(t).position);
        const Vector3d tcp = pose.translation();
        ASSERT_LE(distance_to_line(tcp, start.translation(), end.translation()), 0.001 + kRounding_mm) << i;
        const double share = (tcp - start.translation()).norm() / length_mm;
        const Eigen::Quaterniond turned =
            Eigen::Quaterniond(start.linear()).slerp(share, Eigen::Quaterniond(end.linear()));
        ASSERT_LE(turned.angularDistance(Eigen::Quaterniond(pose.linear())), 2e-4) << i;
        const Vector3d next =
            setup.kinematics->forward(run.kept.at(std::min(t + 1e-3, run.kept.end_s())).position)
                .translation();
        ASSERT_LE((next - tcp).norm() / 1e-3, 50 * 1.02);
        if ((next - tcp).norm() / 1e-3 > 50 * 0.98) ++at_feed;
    }
    EXPECT_GT(at_feed, 1700);
    EXPECT_TRUE(setup.kinematics->forward(run.planner.position()).isApprox(end, 1e-9));
    expect_limits_held(run);
}

TEST_P(ArmMoves, TcpFollowsArcThroughPoint) {
    rrs::CartPos via = start;
    rrs::CartPos end = start;
    via.translation() += Vector3d(-30, 30, 0);
    end.translation() += Vector3d(-60, 0, 0);
    run.planner.SelectMotionType(rrs::MotionType::circular);
    ASSERT_EQ(to(via, rrs::TargetParam::via), Status::RRS_SUCCESS) << run.message();
    ASSERT_EQ(to(end), Status::RRS_SUCCESS) << run.message();
    run.planner.flush();
    const Vector3d center = start.translation() + Vector3d(-30, 0, 0);
    for (int i = 0; i <= 1000; ++i) {
        const JointPos joints = run.kept.at(run.kept.end_s() * i / 1000).position;
        ASSERT_NEAR((setup.kinematics->forward(joints).translation() - center).norm(), 30,
                    0.001 + kRounding_mm);
    }
    expect_limits_held(run);
}

TEST_P(ArmMoves, JointLimitsReduceFeedNearSingularity) {
    ToolRun near(setup, joints_of({0, 45, -60, 0, 2, 0}, setup));  // the wrist is almost straight
    near.planner.SelectTargetType(rrs::TargetType::cartesian);
    near.planner.SelectMotionType(rrs::MotionType::linear);
    near.planner.SetCartesianPositionSpeed(200);
    rrs::CartPos end = setup.kinematics->forward(near.planner.position());
    end.translation() += Vector3d(0, 100, 0);
    ASSERT_EQ(near.planner.SetNextTarget(1, rrs::TargetParam::end, end, JointPos(), "", 0),
              Status::RRS_SUCCESS)
        << near.message();
    near.planner.flush();
    expect_limits_held(near, 0.03);
}

TEST_P(ArmMoves, ReportPathOutOfReach) {
    rrs::CartPos end = start;
    end.translation() += Vector3d(2000, 0, 0);
    EXPECT_EQ(to(end), Status::RRS_NO_SOLUTION);
    EXPECT_THAT(run.message(), HasSubstr("The tool cannot follow its path at X"));
}

INSTANTIATE_TEST_SUITE_P(Planners, ArmMoves,
                         testing::Values(PlannerKind::rest_to_rest, PlannerKind::look_ahead));

}  // namespace
}  // namespace gsim::motion::tool_moves_test
