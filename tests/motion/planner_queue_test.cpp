#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/planner_under_test.h"

namespace gsim::motion::planner_queue_test {
namespace {

using rrs::CartPos;
using rrs::Status;

const rrs::JointPos kStart = joint_pos({500, 500, 300, 0, 0});

std::vector<rrs::TargetId> ids(const std::vector<Segment>& segments) {
    std::vector<rrs::TargetId> result;
    for (const Segment& segment : segments) result.push_back(segment.target_id);
    return result;
}

// Enqueues lines, an arc, a joint move, moves without length and dwells.
void put_program(rrs::Shell& planner) {
    planner.SelectMotionType(rrs::MotionType::linear);
    planner.SetCartesianPositionSpeed(80);
    enqueue(planner, joint_pos({600, 500, 300, 0.4, 0}), 1);
    enqueue(planner, joint_pos({600, 500, 300, 0.4, 0}), 2);
    planner.SetNextArcTarget(3, {600, 550, 0}, Eigen::Vector3d::UnitZ(), 3 * kPi, CartPos::Identity(),
                             joint_pos({600, 600, 300, 0.4, 0.2}));
    planner.SetNextRest(4, 0.1234);
    planner.SelectMotionType(rrs::MotionType::joint);
    enqueue(planner, joint_pos({500, 400, 100, 0, 0}), 5);
    planner.SetRestParameter(0.05);
    enqueue(planner, joint_pos({500, 400, 200, 0, 0}), 6);
    planner.SetNextRest(7, 0);
}

// Queue as services alone show it. A sink for segments is no service, so those tests use the planner in
// process (PlannerQueue).
class QueueServices : public AnyPlanner {
  protected:
    static std::unique_ptr<rrs::Shell> ready(const PlannerSetup& setup) {
        auto planner = make(setup);
        planner->Initialize();
        planner->SetInitialPosition(CartPos::Identity(), kStart, "");
        return planner;
    }
};

INSTANTIATE_TEST_SUITE_P(Ways, QueueServices, all_ways(), way_name);

TEST(PlannerQueue, EmitsSegmentsOnceInOrderWithoutGaps) {
    ReadyPlanner at(gantry_setup(), kStart);
    put_program(at.planner);
    EXPECT_TRUE(at.collector.segments.empty());
    at.planner.flush();
    at.planner.flush();
    const auto& segments = at.collector.segments;
    EXPECT_EQ(ids(segments), (std::vector<rrs::TargetId>{1, 2, 3, 4, 5, 6, 6, 7}));
    EXPECT_EQ(segments[3].kind, SegmentKind::rest);
    EXPECT_EQ(segments[3].duration_s, 0.1234);
    EXPECT_EQ(segments[6].kind, SegmentKind::rest);
    EXPECT_EQ(segments[6].duration_s, 0.05);
    EXPECT_EQ(segments[3].position_at(0.05), segments[3].start);
    double clock = 0;
    rrs::JointPos position = kStart;
    for (const Segment& segment : segments) {
        EXPECT_EQ(segment.start_s, clock);
        EXPECT_EQ(segment.start, position);
        clock = segment.end_s();
        position = segment.end;
    }
    EXPECT_EQ(clock, at.planner.time_s());
    EXPECT_EQ(position, at.planner.position());
    EXPECT_EQ(at.planner.timeline().step_time_s(), clock);
}

TEST_P(QueueServices, StepsAreSamplesOfSegments) {
    ReadyPlanner flushed(gantry_setup(), kStart);
    put_program(flushed.planner);
    flushed.planner.flush();
    const auto& segments = flushed.collector.segments;
    const auto stepped = ready(gantry_setup());
    put_program(*stepped);
    stepped->SetInterpolationTime(0.0137);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0, clock = 0;
    std::size_t remaining = 0;
    for (;;) {
        const Status status = stepped->GetNextStep(joints, pose, elapsed);
        if (status == Status::RRS_NEED_MORE_DATA) break;
        clock += elapsed;
        ASSERT_LE(elapsed, 0.0137 + 1e-12);
        std::size_t passed = remaining;
        while (passed < segments.size() && segments[passed].end_s() <= clock + 1e-9) ++passed;
        ASSERT_EQ(status == Status::RRS_TARGET_REACHED, passed > remaining) << "at " << clock;
        remaining = passed;
        const bool at_end = remaining == segments.size();
        const rrs::JointPos expected =
            at_end ? segments.back().end
                   : segments[remaining].position_at(clock - segments[remaining].start_s);
        ASSERT_LT((joints - expected).norm(), 1e-9) << "at " << clock;
        ASSERT_LT((pose.translation() - joints.head<3>()).norm(), 1e-9);
        rrs::TargetId id = 0;
        ASSERT_EQ(stepped->GetTargetOfLastStep(id), Status::RRS_SUCCESS);
        const bool in_next = !at_end && clock > segments[remaining].start_s + 1e-9;
        ASSERT_EQ(id, segments[in_next ? remaining : remaining - 1].target_id) << "at " << clock;
    }
    EXPECT_EQ(elapsed, 0);
    EXPECT_EQ(joints, segments.back().end);
    EXPECT_NEAR(clock, flushed.planner.time_s(), 1e-9);
    EXPECT_EQ(remaining, segments.size());
}

rrs::TargetId current_target(rrs::Shell& planner) {
    rrs::TargetId id = 0;
    EXPECT_EQ(planner.GetCurrentTargetId(id), Status::RRS_SUCCESS);
    return id;
}

TEST_P(QueueServices, CurrentTargetIsNextToReach) {
    ReadyPlanner flushed(gantry_setup(), kStart);
    put_program(flushed.planner);
    flushed.planner.flush();
    const auto& segments = flushed.collector.segments;
    const auto stepped = ready(gantry_setup());
    EXPECT_EQ(current_target(*stepped), -1) << "nothing has been put";
    put_program(*stepped);
    EXPECT_EQ(current_target(*stepped), 1) << "no step has been made";
    stepped->SetInterpolationTime(0.0137);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0, clock = 0;
    std::size_t remaining = 0, reported = 0;
    while (stepped->GetNextStep(joints, pose, elapsed) != Status::RRS_NEED_MORE_DATA) {
        clock += elapsed;
        while (remaining < segments.size() && segments[remaining].end_s() <= clock + 1e-9) ++remaining;
        const rrs::TargetId ahead = remaining == segments.size() ? -1 : segments[remaining].target_id;
        ASSERT_EQ(current_target(*stepped), ahead) << "at " << clock;
        ++reported;
    }
    EXPECT_GT(reported, 100U);
    EXPECT_EQ(current_target(*stepped), -1) << "all targets are reached";
    rrs::TargetId last = 0;
    stepped->GetTargetOfLastStep(last);
    EXPECT_EQ(last, 7) << "which is where the motion came from";
}

TEST_P(QueueServices, CurrentTargetAfterReachingTargetIsNextOne) {
    const auto planner = ready(gantry_setup());
    planner->SetNextRest(1, 0.02);
    planner->SetNextRest(2, 0.02);
    planner->SetInterpolationTime(0.02);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0;
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_TARGET_REACHED);
    rrs::TargetId last = 0;
    planner->GetTargetOfLastStep(last);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(current_target(*planner), 2);
}

TEST_P(QueueServices, CurrentTargetOfStoppedMotionRemainsUntilCancel) {
    const auto planner = ready(gantry_setup());
    planner->SelectMotionType(rrs::MotionType::linear);
    planner->SetCartesianPositionSpeed(80);
    enqueue(*planner, joint_pos({600, 500, 300, 0, 0}), 4);
    enqueue(*planner, joint_pos({700, 500, 300, 0, 0}), 5);
    planner->SetInterpolationTime(0.5);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0;
    planner->GetNextStep(joints, pose, elapsed);
    EXPECT_EQ(planner->StopMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(current_target(*planner), 4) << "while it brakes";
    step_to_end(*planner, 0.01);
    EXPECT_EQ(current_target(*planner), 4) << "while it stands";
    EXPECT_EQ(planner->CancelMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(current_target(*planner), -1);
}

TEST_P(QueueServices, CurrentTargetIsKnownBeforePlanning) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = rrs::PlannerKind::look_ahead;
    const auto planner = ready(setup);
    planner->SelectMotionType(rrs::MotionType::linear);
    planner->SetCartesianPositionSpeed(80);
    enqueue(*planner, joint_pos({600, 500, 300, 0, 0}), 8);
    enqueue(*planner, joint_pos({700, 500, 300, 0, 0}), 9);
    EXPECT_EQ(current_target(*planner), 8);
    step_to_end(*planner, 0.01);
    EXPECT_EQ(current_target(*planner), -1);
}

TEST(PlannerQueue, EmitsSegmentsAsStepsPassThem) {
    ReadyPlanner at(gantry_setup(), kStart);
    put_program(at.planner);
    at.planner.SetInterpolationTime(0.0137);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0, clock = 0;
    std::size_t remaining = 0;
    for (;;) {
        const Status status = at.planner.GetNextStep(joints, pose, elapsed);
        if (status == Status::RRS_NEED_MORE_DATA) break;
        clock += elapsed;
        ASSERT_NEAR(clock, at.planner.timeline().step_time_s(), 1e-9);
        const std::size_t passed = at.collector.segments.size();
        ASSERT_EQ(status == Status::RRS_TARGET_REACHED, passed > remaining);
        remaining = passed;
    }
    EXPECT_EQ(at.planner.timeline().step_time_s(), at.planner.time_s());
    EXPECT_EQ(ids(at.collector.segments), (std::vector<rrs::TargetId>{1, 2, 3, 4, 5, 6, 6, 7}));
}

TEST_P(QueueServices, LastStepTakesRemainingTime) {
    const auto planner = ready(gantry_setup());
    planner->SetNextRest(1, 0.025);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0;
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_SUCCESS);
    EXPECT_DOUBLE_EQ(elapsed, 0.01);
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_TARGET_REACHED);
    EXPECT_DOUBLE_EQ(elapsed, 0.005);
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_NEED_MORE_DATA);
}

TEST(PlannerQueue, EmitsOldestSegmentIfQueueIsFull) {
    PlannerSetup setup = gantry_setup();
    setup.queue_capacity = 4;
    ReadyPlanner at(setup, kStart);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(at.to(joint_pos({500.0 + i % 7, 500, 300, 0, 0})), Status::RRS_SUCCESS);
        ASSERT_EQ(at.collector.segments.size(), static_cast<std::size_t>(std::max(0, i - 3)));
    }
    at.planner.flush();
    ASSERT_EQ(at.collector.segments.size(), 1000U);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(at.collector.segments[static_cast<std::size_t>(i)].target_id, i + 1);
}

TEST_P(QueueServices, FullQueueWithoutSinkRejectsTargets) {
    PlannerSetup setup = gantry_setup();
    setup.queue_capacity = 2;
    const auto planner = ready(setup);
    EXPECT_EQ(planner->SetNextRest(1, 1), Status::RRS_SUCCESS);
    planner->SetRestParameter(1);
    EXPECT_EQ(enqueue(*planner, kStart, 2), Status::RRS_QUEUE_FULL);
    planner->SetRestParameter(0);
    EXPECT_EQ(planner->SetNextRest(2, 1), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SetNextRest(3, 1), Status::RRS_QUEUE_FULL);
    EXPECT_EQ(message(*planner), "2 targets are pending; call GetNextStep before setting more.");
    planner->SetInterpolationTime(1);
    rrs::JointPos joints;
    CartPos pose;
    double elapsed = 0;
    EXPECT_EQ(planner->GetNextStep(joints, pose, elapsed), Status::RRS_TARGET_REACHED);
    EXPECT_EQ(planner->SetNextRest(3, 1), Status::RRS_SUCCESS);
    EXPECT_DOUBLE_EQ(step_to_end(*planner, 1).time_s, 2);
}

TEST_P(QueueServices, NewInitialPositionClearsQueue) {
    const auto planner = ready(gantry_setup());
    enqueue(*planner, joint_pos({600, 500, 300, 0, 0}));
    const rrs::JointPos corner = joint_pos({0, 0, 0, 0, 0});
    EXPECT_EQ(planner->SetInitialPosition(CartPos::Identity(), corner, ""), Status::RRS_SUCCESS);
    const Stepped stepped = step_to_end(*planner, 0.01);
    EXPECT_EQ(stepped.time_s, 0);
    EXPECT_EQ(stepped.joints, corner);
}

TEST(PlannerQueue, NewInitialPositionEmitsQueuedSegments) {
    ReadyPlanner at(gantry_setup(), kStart);
    at.to(joint_pos({600, 500, 300, 0, 0}));
    const double end_s = at.planner.time_s();
    EXPECT_EQ(at.planner.SetInitialPosition(CartPos::Identity(), joint_pos({0, 0, 0, 0, 0}), ""),
              Status::RRS_SUCCESS);
    EXPECT_EQ(at.collector.segments.size(), 1U);
    at.to(joint_pos({1, 0, 0, 0, 0}));
    EXPECT_EQ(at.last().start, joint_pos({0, 0, 0, 0, 0}));
    EXPECT_EQ(at.last().start_s, end_s);
}

TEST(PlannerQueue, EmitsSegmentOnceIfSinkThrows) {
    class Thrower : public SegmentSink {
      public:
        void on_segment(const Segment&) override {
            ++taken;
            throw std::runtime_error("enough");
        }
        int taken = 0;
    };
    Thrower sink;
    DefaultPlanner planner(gantry_setup(), &sink);
    planner.Initialize();
    planner.SetInitialPosition(CartPos::Identity(), kStart, "");
    planner.SetNextRest(1, 1);
    EXPECT_THROW(planner.flush(), std::runtime_error);
    EXPECT_NO_THROW(planner.flush());
    EXPECT_EQ(sink.taken, 1);
}

/// Dwells, joint motions and new starts of a controller that counts steps begin at the end of the last line:
/// on the grid of the steps, off the programmed position.
TEST(PlannerQueue, MoveStartsAtRoundedEndOfPreviousLine) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = rrs::PlannerKind::look_ahead;
    setup.controller.corners.continuous = rrs::CornerRule::junction_deviation;
    setup.controller.curves.arc_chord_tolerance_mm = 0.002;
    for (JointSetup& joint : setup.joints) joint.step = 1.0 / 250;
    ReadyPlanner ready(setup, kinematics::joint_pos({1.0013, 0, 0, 0, 0}));
    ready.planner.SetCartesianPositionSpeed(50);
    std::mt19937 random(81);
    std::uniform_real_distribution<double> place(1, 9);
    for (int i = 0; i < 60; ++i) {
        ready.planner.SelectMotionType(i % 5 == 3 ? rrs::MotionType::joint : rrs::MotionType::linear);
        ASSERT_EQ(ready.to(kinematics::joint_pos({place(random), place(random), place(random), 0, 0})),
                  rrs::Status::RRS_SUCCESS)
            << ready.message();
        if (i % 3 == 0) ready.planner.SetNextRest(1000 + i, 0.1);
    }
    ready.planner.flush();
    const std::vector<Segment>& segments = ready.collector.segments;
    for (std::size_t i = 1; i < segments.size(); ++i)
        ASSERT_LT((segments[i].start - segments[i - 1].end_position()).norm(), 1e-12) << i;
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    ready.planner.GetNextStep(joints, pose, elapsed_s);
    EXPECT_EQ(joints, segments.back().end_position());
}

/// 508 mm/s are the speed of the axis, 254 mm/s that of the path.
TEST(PlannerQueue, ReportsTooShortMotionTimes) {
    for (const auto kind :
         {rrs::PlannerKind::look_ahead, rrs::PlannerKind::linuxcnc, rrs::PlannerKind::klipper}) {
        PlannerSetup setup = gantry_setup();
        setup.controller.planner = kind;
        ReadyPlanner ready(setup, joint_pos({0, 0, 0, 0, 0}));
        ready.planner.SelectMotionType(rrs::MotionType::linear);
        ready.planner.SetMotionTime(1);
        EXPECT_EQ(ready.to(joint_pos({200, 0, 0, 0, 0})), Status::RRS_SUCCESS) << ready.message();
        ready.planner.SetMotionTime(1);
        EXPECT_EQ(ready.to(joint_pos({600, 0, 0, 0, 0})), Status::RRS_MOTION_TIME_RAISED);
        EXPECT_NE(ready.message().find("at least 1.57"), std::string::npos) << ready.message();
        ready.planner.SetMotionTime(2);
        EXPECT_EQ(ready.to(joint_pos({200, 0, 0, 0, 0})), Status::RRS_SUCCESS) << ready.message();
    }
}

}  // namespace
}  // namespace gsim::motion::planner_queue_test
