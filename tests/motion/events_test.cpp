// Events on the path: a time or a distance from reaching a target.

#include <map>

#include "tests/motion/planner_under_test.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::events_test {
namespace {

using rrs::Status;

class Events : public AnyPlanner {
  protected:
    Events() {
        planner().SetCartesianPositionSpeed(100);
        planner().SelectMotionType(rrs::MotionType::linear);
        planner().SetInterpolationTime(0.01);
    }
    static PlannerSetup setup() {
        PlannerSetup setup = gantry_setup();
        for (JointSetup& joint : setup.joints) joint.max_acceleration = 1000;
        setup.path.max_acceleration_mm_s2 = kUnlimited;
        return setup;
    }
    rrs::Shell& planner() { return ready_.planner; }
    Status to(double x_mm) { return ready_.to(joint_pos({x_mm, 0, 0, 0, 0})); }
    /// Steps to the end: when each event came true.
    std::map<int, double> run() {
        std::map<int, double> times_s;
        Status status = Status::RRS_SUCCESS;
        while (status != Status::RRS_NEED_MORE_DATA) {
            const double from_s = ready_.time_s;
            const Step step = ready_.step();
            status = step.status;
            int id = 0;
            double time_s = 0;
            for (int i = 0; planner().GetEvent(i, id, time_s) == Status::RRS_SUCCESS; ++i) {
                EXPECT_LE(time_s, step.elapsed_s);
                EXPECT_EQ(times_s.count(id), 0U) << "twice";
                times_s[id] = from_s + time_s;
            }
        }
        return times_s;
    }

    ReadyShell ready_{make(setup()), joint_pos({0, 0, 0, 0, 0})};
};

INSTANTIATE_TEST_SUITE_P(Ways, Events, all_ways(), way_name);

// 100 mm at 100 mm/s with 1000 mm/s2: 1.1 s, and 2.2 s for both.
TEST_P(Events, OccurAtTimeRelativeToTarget) {
    to(100);
    to(200);
    planner().DefineEvent(1, 1, 0);
    planner().DefineEvent(2, 1, -0.25);
    planner().DefineEvent(3, 1, 0.333);
    planner().DefineEvent(4, 2, -2.0);
    planner().DefineEvent(5, 99, 0);
    const auto times_s = run();
    ASSERT_EQ(times_s.size(), 4U);
    EXPECT_NEAR(times_s.at(1), 1.1, 1e-9);
    EXPECT_NEAR(times_s.at(2), 0.85, 1e-9);
    EXPECT_NEAR(times_s.at(3), 1.433, 1e-9);
    EXPECT_NEAR(times_s.at(4), 0.2, 1e-9);
}

TEST_P(Events, OccurAtDistanceFromTarget) {
    to(100);
    to(200);
    planner().DefinePathEvent(1, 1, -50);
    planner().DefinePathEvent(2, 2, -150);
    planner().DefinePathEvent(3, 1, 50);
    planner().DefinePathEvent(4, 1, 0);
    planner().DefinePathEvent(5, 2, 30);
    const auto times_s = run();
    ASSERT_EQ(times_s.size(), 4U) << "the way ends before the fifth";
    EXPECT_NEAR(times_s.at(1), 0.55, 1e-9);
    EXPECT_NEAR(times_s.at(2), 0.55, 1e-9);
    EXPECT_NEAR(times_s.at(3), 1.65, 1e-9);
    EXPECT_NEAR(times_s.at(4), 1.1, 1e-9);
    to(300);
    EXPECT_NEAR(run().at(5), 2.2 + 0.05 + 0.3, 1e-9) << "30 mm into the next move";
}

TEST_P(Events, OccurInNextStepIfTimeHasPassed) {
    to(100);
    run();
    planner().DefineEvent(1, 1, 0);
    to(200);
    planner().DefineEvent(2, 2, -50);
    const auto times_s = run();
    EXPECT_EQ(times_s.count(1), 0U) << "its target had been reached before it was defined";
    EXPECT_NEAR(times_s.at(2), 2.2 - 50, 1e-9) << "in the first step after it was known, but when it was";
}

TEST_P(Events, CanBeCancelledAndReplaced) {
    to(100);
    planner().DefineEvent(1, 1, 0);
    planner().DefineEvent(2, 1, 0);
    planner().DefineEvent(2, 1, -0.1);
    EXPECT_EQ(planner().CancelEvent(1), Status::RRS_SUCCESS);
    EXPECT_EQ(planner().CancelEvent(1), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner().DefineEvent(3, 1, kUnlimited), Status::RRS_INVALID_PARAMETER);
    const auto times_s = run();
    ASSERT_EQ(times_s.size(), 1U);
    EXPECT_NEAR(times_s.at(2), 1.0, 1e-9);
}

TEST_P(Events, WaitWhileMotionIsStopped) {
    to(100);
    planner().DefinePathEvent(1, 1, -40);
    planner().DefineEvent(2, 1, 0);
    planner().SetInterpolationTime(0.5);
    ready_.step();           // at 45 mm
    planner().StopMotion();  // it stops at 50 mm
    EXPECT_TRUE(run().empty());
    planner().ContinueMotion();
    const auto times_s = run();
    EXPECT_NEAR(times_s.at(1), 0.6 + 0.05 + 0.1, 1e-9) << "at 60 mm: 5 mm and 0.1 s are the ramp's";
    EXPECT_NEAR(times_s.at(2), 0.6 + trapezoid_s(50, 100, 1000), 1e-9);
}

/// Returns controllers with buffered targets: the look-ahead's window, LinuxCNC's blends.
PlannerSetup holding_setup(rrs::PlannerKind kind) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = kind;
    setup.controller.corners.continuous = rrs::CornerRule::velocity_step;
    for (JointSetup& joint : setup.joints) joint.max_speed_step = 5;
    setup.controller.position_loop.servo_period_s = 0.001;
    return setup;
}

class PendingTargetEvents : public testing::TestWithParam<rrs::PlannerKind> {
  protected:
    PendingTargetEvents() {
        planner().SetCartesianPositionSpeed(60);
        planner().SelectMotionType(rrs::MotionType::linear);
        planner().SelectFlybyMode(true);
        planner().SetInterpolationTime(0.004);
    }
    DefaultPlanner& planner() { return ready_.planner; }
    /// A zigzag: targets 1, 2, 3, ...
    void enqueue(int count) {
        for (int i = 0; i < count; ++i) {
            const double x_mm = 3.0 * static_cast<double>(ready_.id + 1);
            ASSERT_EQ(ready_.to(joint_pos({x_mm, ready_.id % 2 == 0 ? 2.0 : 0, 0, 0, 0})),
                      Status::RRS_SUCCESS);
        }
    }
    Status step() {
        rrs::JointPos joints;
        rrs::CartPos pose;
        const double from_s = planner().timeline().step_time_s();
        const Status status = planner().GetNextStep(joints, pose, elapsed_s_);
        int id = 0;
        double time_s = 0;
        for (int i = 0; planner().GetEvent(i, id, time_s) == Status::RRS_SUCCESS; ++i) {
            latest_s_ = std::min(latest_s_, time_s);
            EXPECT_LE(time_s, elapsed_s_);
            EXPECT_TRUE(times_s_.emplace(id, from_s + time_s).second) << "twice";
        }
        return status;
    }
    void run() {
        while (step() != Status::RRS_NEED_MORE_DATA) {
        }
    }
    /// When a target was reached, by the segments that left.
    double reached_s(rrs::TargetId id) const {
        for (const Segment& segment : ready_.collector.segments) {
            if (segment.target_id == id && segment.reaches_target) return segment.end_s();
        }
        ADD_FAILURE() << "target " << id << " is not reached";
        return 0;
    }
    /// Returns when the tool was `distance_mm` short of a target.
    double before_s(rrs::TargetId id, double distance_mm) const {
        const std::vector<Segment>& segments = ready_.collector.segments;
        const auto reaches = [&](const Segment& s) { return s.target_id == id && s.reaches_target; };
        for (auto i = std::find_if(segments.begin(), segments.end(), reaches);; --i) {
            if (i->length_mm < distance_mm) {
                distance_mm -= i->length_mm;
                continue;
            }
            double low = 0, high = i->duration_s;
            for (int k = 0; k < 60; ++k) {
                const double middle = (low + high) / 2;
                const double remaining = i->length_mm * (1 - i->master.at(middle).s / i->master.length());
                (remaining > distance_mm ? low : high) = middle;
            }
            return i->start_s + high;
        }
    }

    ReadyPlanner ready_{holding_setup(GetParam()), joint_pos({0, 0, 0, 0, 0})};
    std::map<int, double> times_s_;
    double latest_s_ = kUnlimited;
    double elapsed_s_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Models, PendingTargetEvents,
                         testing::Values(rrs::PlannerKind::look_ahead, rrs::PlannerKind::linuxcnc,
                                         rrs::PlannerKind::klipper),
                         [](const auto& model) {
                             const bool linuxcnc = model.param == rrs::PlannerKind::linuxcnc;
                             const bool klipper = model.param == rrs::PlannerKind::klipper;
                             return linuxcnc ? "linuxcnc" : klipper ? "klipper" : "look_ahead";
                         });

TEST_P(PendingTargetEvents, OccurInTheirStep) {
    enqueue(40);
    planner().DefineEvent(1, 20, -0.4);
    planner().DefineEvent(2, 40, -0.3);
    planner().DefineEvent(3, 39, 0.01);
    planner().DefinePathEvent(4, 38, -12);
    run();
    ASSERT_EQ(times_s_.size(), 4U);
    EXPECT_NEAR(times_s_.at(1), reached_s(20) - 0.4, 1e-9);
    EXPECT_NEAR(times_s_.at(2), reached_s(40) - 0.3, 1e-9);
    EXPECT_NEAR(times_s_.at(3), reached_s(39) + 0.01, 1e-9);
    EXPECT_NEAR(times_s_.at(4), before_s(38, 12), 1e-6);
    EXPECT_GE(latest_s_, 0);
}

/// Targets come as the queue has space for them; an event precedes its target by more than is planned.
TEST_P(PendingTargetEvents, PlanTargetStreamAsFarAsEventNeeds) {
    enqueue(4);
    planner().DefineEvent(1, 4, -0.1);
    for (int i = 0; i < 2; ++i) step();
    enqueue(10);
    run();
    EXPECT_NEAR(times_s_.at(1), reached_s(4) - 0.1, 1e-9);
    EXPECT_GE(latest_s_, 0);
}

TEST_P(PendingTargetEvents, KeepTimeIfKnownTooLate) {
    enqueue(30);
    planner().DefineEvent(1, 10, 0.02);
    planner().DefineEvent(2, 12, -0.02);
    planner().DefinePathEvent(3, 14, -7);
    planner().DefineEvent(4, 31, -0.5);
    planner().flush();
    const double flushed_s = planner().timeline().step_time_s();
    step();
    ASSERT_EQ(times_s_.size(), 3U);
    EXPECT_NEAR(times_s_.at(1), reached_s(10) + 0.02, 1e-9);
    EXPECT_NEAR(times_s_.at(2), reached_s(12) - 0.02, 1e-9);
    EXPECT_NEAR(times_s_.at(3), before_s(14, 7), 1e-6);
    enqueue(1);
    run();
    EXPECT_NEAR(times_s_.at(4), reached_s(31) - 0.5, 1e-9);
    EXPECT_LT(times_s_.at(4), flushed_s);
}

}  // namespace
}  // namespace gsim::motion::events_test
