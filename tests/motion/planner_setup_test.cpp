#include "motion/planner/planner_setup.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"

namespace gsim::motion::planner_setup_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <typename Change>
std::string trouble_after(Change change) {
    PlannerSetup setup = gantry_setup();
    change(setup);
    return setup.validate().value_or("");
}

TEST(PlannerSetup, GantryIsValid) {
    EXPECT_EQ(trouble_after([](PlannerSetup&) {}), "");
    EXPECT_EQ(gantry_setup().role(1), JointRole::position);
    EXPECT_EQ(gantry_setup().role(4), JointRole::rotary);
}

TEST(PlannerSetup, ErrorNamesFieldAndValue) {
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[2].min = 700; }),
              "The range of joint 2 is from 700 to 609.6; min must not be above max.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[1].max_speed = 0; }),
              "max_speed of joint 1 is 0; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[1].max_acceleration = kNan; }),
              "max_acceleration of joint 1 is nan; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.path.max_feed_mm_s = -1; }),
              "max_feed_mm_s of the path is -1; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) {
                  s.position_joints = {0, 1, 3};
              }),
              "Position joint 3 is revolute; it must be prismatic.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) {
                  s.position_joints = {0, 1, 1};
              }),
              "Joint 1 is used for more than one of x, y, z.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) {
                  s.position_joints = {0, 1, 5};
              }),
              "Position joint 5 does not exist; joints are 0 to 4.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints.clear(); }),
              "There are 0 joints; a planner accepts 1 to 16.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints.pop_back(); }),
              "The kinematics have 5 joints but the planner has 4.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.kinematics.reset(); }), "The kinematics are missing.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.arc_tolerance_mm = kNan; }),
              "arc_tolerance_mm is nan; it must be 0 or greater.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[1].max_jerk = 0; }),
              "max_jerk of joint 1 is 0; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[1].max_speed_step = -1; }),
              "max_speed_step of joint 1 is -1; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.joints[1].step = kNan; }),
              "step of joint 1 is nan; it must be 0 or greater.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.controller.blocks.look_ahead = 0; }),
              "look_ahead_blocks of the controller is 0; it must be at least 1.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.controller.ramps.centripetal_share = 0; }),
              "centripetal_share of the controller is 0; it must be greater than 0 (infinity: "
              "curves do not slow the motion).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.controller.corners.speed_step_s = 0; }),
              "speed_step_s of the controller is 0; it must be greater than 0 (infinity for no limit).");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.controller.position_loop.settle_s = -1; }),
              "settle_s of the controller is -1; it must be 0 or greater.");
    EXPECT_EQ(trouble_after([](PlannerSetup& s) { s.queue_capacity = 1; }),
              "queue_capacity is 1; it must be at least 2.");
}

TEST(PlannerSetup, PlannerThrowsErrorMessage) {
    PlannerSetup setup = gantry_setup();
    setup.kinematics.reset();
    try {
        const DefaultPlanner planner(setup);
        FAIL() << "no exception";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "The kinematics are missing.");
    }
}

}  // namespace
}  // namespace gsim::motion::planner_setup_test
