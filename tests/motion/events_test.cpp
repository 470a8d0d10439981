// Events on the way: a time or a way from reaching a target.

#include <map>

#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion {
namespace {

using rrs::Status;

class Events : public testing::Test {
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
    DefaultPlanner& planner() { return ready_.planner; }
    Status to(double x_mm) { return ready_.to(joint_pos({x_mm, 0, 0, 0, 0})); }
    /// Steps to the end: when each event came true.
    std::map<int, double> run() {
        std::map<int, double> times_s;
        Status status = Status::RRS_SUCCESS;
        while (status != Status::RRS_NEED_MORE_DATA) {
            const double from_s = planner().step_time_s();
            rrs::JointPos joints;
            rrs::CartPos pose;
            double elapsed_s = 0;
            status = planner().GetNextStep(joints, pose, elapsed_s);
            int id = 0;
            double time_s = 0;
            for (int i = 0; planner().GetEvent(i, id, time_s) == Status::RRS_SUCCESS; ++i) {
                EXPECT_LE(time_s, elapsed_s);
                EXPECT_EQ(times_s.count(id), 0U) << "twice";
                times_s[id] = from_s + time_s;
            }
        }
        return times_s;
    }

    ReadyPlanner ready_{setup(), joint_pos({0, 0, 0, 0, 0})};
};

// 100 mm at 100 mm/s with 1000 mm/s2: 1.1 s, and 2.2 s for both.
TEST_F(Events, ByTime) {
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

TEST_F(Events, ByWay) {
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

TEST_F(Events, OfThePastComeTrueAtOnce) {
    to(100);
    run();
    planner().DefineEvent(1, 1, 0);
    to(200);
    planner().DefineEvent(2, 2, -50);
    const auto times_s = run();
    EXPECT_EQ(times_s.count(1), 0U) << "its target had been reached before it was defined";
    EXPECT_NEAR(times_s.at(2), 1.1, 1e-9);
}

TEST_F(Events, AreTakenBackAndReplaced) {
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

TEST_F(Events, WaitForAStop) {
    to(100);
    planner().DefinePathEvent(1, 1, -40);
    planner().DefineEvent(2, 1, 0);
    planner().SetInterpolationTime(0.5);
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    planner().GetNextStep(joints, pose, elapsed_s);  // at 45 mm
    planner().StopMotion();                          // it stands at 50 mm
    EXPECT_TRUE(run().empty());
    planner().ContinueMotion();
    const auto times_s = run();
    EXPECT_NEAR(times_s.at(1), 0.6 + 0.05 + 0.1, 1e-9) << "at 60 mm: 5 mm and 0.1 s are the ramp's";
    EXPECT_NEAR(times_s.at(2), 0.6 + trapezoid_s(50, 100, 1000), 1e-9);
}

}  // namespace
}  // namespace gsim::motion
