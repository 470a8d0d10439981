// A move is a value: the planner's result does not depend on earlier targets, selections or settings, but on
// the robot's position.
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "motion/services/default_planner.h"
#include "tests/motion/machines.h"

namespace gsim::motion::whole_moves_test {
namespace {

struct StoredSegments final : SegmentSink {
    void on_segment(const Segment& segment) override { segments.push_back(segment); }
    std::vector<Segment> segments;
};

Move line_to(rrs::TargetId id, const rrs::JointPos& joints, double speed_mm_s) {
    Move move;
    move.target_id = id;
    move.goal.joints = joints;
    move.move_parameters.position_speed_mm_s = speed_mm_s;
    return move;
}

class CompleteMoves : public testing::Test {
  protected:
    double number(double min, double max) { return std::uniform_real_distribution(min, max)(random); }
    bool chance() { return random() % 2 == 0; }

    rrs::JointPos place() {
        const double x = number(100, 900);
        const double y = number(100, 900);
        return joint_pos({x, y, number(100, 500), 0, 0});
    }

    Move any_move() {
        const double speed_mm_s = number(1, 200);
        Move move = line_to(++id, place(), speed_mm_s);
        if (chance()) move.type = rrs::MotionType::joint;
        move.move_parameters.rapid = chance();
        if (chance()) move.move_parameters.position_acceleration_mm_s2 = number(100, 1000);
        if (chance()) move.move_parameters.motion_time_s = number(1, 20);
        if (chance()) {
            auto ramps = std::make_shared<ProgrammedRamps>(5);
            ramps->accelerations.setConstant(number(50, 500));
            move.move_parameters.ramps = ramps;
        }
        return move;
    }

    /// Uses modes of services, and targets that they enqueue.
    void use_services(PlannerShell& shell) {
        shell.SetCartesianPositionSpeed(number(1, 300));
        shell.SetRapid(chance());
        shell.SelectMotionType(chance() ? rrs::MotionType::linear : rrs::MotionType::joint);
        shell.SetOverrideSpeed(number(10, 150));
        shell.SetRampMode(chance() ? rrs::RampMode::linear : rrs::RampMode::machine);
        shell.SetMotionTime(number(1, 9));
        shell.SetPathMode(rrs::PathMode::exact_path, 0, 0);
    }

    std::mt19937 random{7};
    rrs::TargetId id = 0;
};

TEST_F(CompleteMoves, DoNotDependOnPreviousCalls) {
    StoredSegments after;
    DefaultPlanner used(gantry_setup(), &after);
    used.Initialize();
    rrs::JointPos at = joint_pos({500, 500, 300, 0, 0});
    ASSERT_TRUE(used.set_position({at, std::nullopt}));
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        use_services(used);
        const Move move = any_move();
        ASSERT_TRUE(used.Planner::enqueue(move));
        used.flush();

        StoredSegments standalone;
        motion::Planner fresh(gantry_setup(), &standalone);
        ASSERT_TRUE(fresh.set_position({at, std::nullopt}));
        ASSERT_TRUE(fresh.enqueue(move));
        fresh.flush();
        ASSERT_EQ(standalone.segments.size(), 1U);
        const Segment& one = after.segments.back();
        const Segment& other = standalone.segments.back();
        ASSERT_EQ(one.duration_s, other.duration_s);
        ASSERT_EQ(one.end, other.end);
        ASSERT_EQ(one.limited_by, other.limited_by);
        at = one.end;
    }
}

// Each side keeps its selections: the program's move in between changes none of the client's.
TEST_F(CompleteMoves, LeaveServiceModesUnchanged) {
    const rrs::JointPos near = joint_pos({500, 500, 300, 0, 0});
    const rrs::JointPos far = joint_pos({900, 500, 300, 0, 0});
    const auto duration_s = [&](bool moves_between) {
        StoredSegments kept;
        DefaultPlanner planner(gantry_setup(), &kept);
        planner.Initialize();
        EXPECT_TRUE(planner.set_position({near, std::nullopt}));
        planner.SelectMotionType(rrs::MotionType::linear);
        planner.SetCartesianPositionSpeed(12.5);
        if (moves_between) {
            EXPECT_TRUE(planner.Planner::enqueue(line_to(1, far, 100)));
            EXPECT_TRUE(planner.Planner::enqueue(line_to(2, near, 150)));
        }
        EXPECT_EQ(planner.SetNextTarget(3, rrs::TargetParam::end, rrs::CartPos::Identity(), far, {}, 0),
                  rrs::Status::RRS_SUCCESS);
        planner.flush();
        return kept.segments.back().duration_s;
    };
    EXPECT_GT(duration_s(false), 400 / 12.5);
    EXPECT_EQ(duration_s(true), duration_s(false));
}

}  // namespace
}  // namespace gsim::motion::whole_moves_test
