// Fly-by criteria, point accuracy and the interpolation of orientation, as services select them.

#include "tests/motion/planner_under_test.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::flyby_test {
namespace {

using rrs::PlannerKind;
using rrs::Status;

PlannerSetup make_setup(PlannerKind kind) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = kind;
    setup.controller.position_loop.servo_period_s = kind == PlannerKind::linuxcnc ? 0.001 : 0;
    return setup;
}

/// Speed at which a right corner is passed.
double corner_speed(ReadyPlanner& ready) {
    const std::size_t first = ready.collector.segments.size();
    const rrs::JointPos at = ready.planner.position();
    ready.to(at + joint_pos({100, 0, 0, 0, 0}));
    ready.to(at + joint_pos({100, 100, 0, 0, 0}));
    ready.planner.flush();
    return ready.collector.segments.at(first).master.end_speed();
}

TEST(Flyby, SelectedCriterionSetsCornerSpeed) {
    ReadyPlanner ready(make_setup(PlannerKind::look_ahead), joint_pos({0, 0, 0, 0, 0}));
    DefaultPlanner& planner = ready.planner;
    planner.SelectMotionType(rrs::MotionType::linear);
    planner.SetCartesianPositionSpeed(200);
    planner.SelectFlybyMode(true);
    EXPECT_EQ(corner_speed(ready), 0) << "the machine's own rule";
    EXPECT_EQ(planner.SetFlybyCriteriaParameter(1, -1, 12), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.SelectFlybyCriteria(1), Status::RRS_SUCCESS);
    EXPECT_NEAR(corner_speed(ready), 12, 1e-9);
    EXPECT_EQ(planner.SetFlybyCriteriaParameter(1, 1, 7), Status::RRS_SUCCESS);
    EXPECT_NEAR(corner_speed(ready), 7, 1e-9) << "of the slower joint";
    EXPECT_EQ(planner.SetFlybyCriteriaParameter(2, -1, 0.1), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.SelectFlybyCriteria(2), Status::RRS_SUCCESS);
    // Half of the right angle, with the acceleration of two joints together across the corner.
    const double half_sine = std::sqrt(0.5);
    const double acceleration = 490.33 * std::sqrt(2);
    EXPECT_NEAR(corner_speed(ready), std::sqrt(acceleration * 0.1 * half_sine / (1 - half_sine)), 1e-9);
    EXPECT_EQ(planner.CancelFlybyCriteria(1), Status::RRS_INVALID_PARAMETER) << "not in force";
    EXPECT_EQ(planner.CancelFlybyCriteria(2), Status::RRS_SUCCESS);
    EXPECT_EQ(corner_speed(ready), 0);
}

class FlybyServices : public AnyPlanner {};
INSTANTIATE_TEST_SUITE_P(Ways, FlybyServices, all_ways(), way_name);

TEST_P(FlybyServices, RejectModesUnsupportedByController) {
    for (const auto kind : {PlannerKind::rest_to_rest, PlannerKind::look_ahead, PlannerKind::linuxcnc}) {
        ReadyShell ready(make(make_setup(kind)), joint_pos({0, 0, 0, 0, 0}));
        const auto expected_status = [&](bool has) {
            return has ? Status::RRS_SUCCESS : Status::RRS_MODE_NOT_SUPPORTED;
        };
        for (const int criterion : {1, 2, 3}) {
            const bool has = kind == (criterion == 3 ? PlannerKind::linuxcnc : PlannerKind::look_ahead);
            EXPECT_EQ(ready.planner.SetFlybyCriteriaParameter(criterion, -1, 0.5), expected_status(has));
            EXPECT_EQ(ready.planner.SelectFlybyCriteria(criterion), expected_status(has));
        }
        EXPECT_EQ(ready.planner.SelectFlybyCriteria(4), Status::RRS_INVALID_PARAMETER);
        EXPECT_EQ(ready.planner.SelectPointAccuracy(0), Status::RRS_SUCCESS);
        EXPECT_EQ(ready.planner.SelectPointAccuracy(1), expected_status(kind == PlannerKind::look_ahead));
        EXPECT_EQ(ready.planner.SelectPointAccuracy(2), Status::RRS_INVALID_PARAMETER);
        EXPECT_EQ(ready.planner.SelectOrientationInterpolationMode(0), Status::RRS_SUCCESS);
        EXPECT_EQ(ready.planner.SelectOrientationInterpolationMode(1),
                  expected_status(kind != PlannerKind::linuxcnc));
        EXPECT_EQ(ready.planner.SelectOrientationInterpolationMode(7), Status::RRS_INVALID_PARAMETER);
    }
}

TEST_P(FlybyServices, ExactStopsWaitAsSelected) {
    PlannerSetup setup = make_setup(PlannerKind::look_ahead);
    setup.controller.position_loop.settle_s = 0.25;
    ReadyShell ready(make(setup), joint_pos({0, 0, 0, 0, 0}));
    rrs::Shell& planner = ready.planner;
    planner.SelectMotionType(rrs::MotionType::linear);
    planner.SetCartesianPositionSpeed(100);
    const auto time_to = [&](double x_mm) { return ready.time_to(joint_pos({x_mm, 0, 0, 0, 0})); };
    const double move_s = trapezoid_s(50, 100, 490.33);
    EXPECT_NEAR(time_to(50), move_s + 0.25, 1e-9);
    planner.SelectPointAccuracy(0);
    EXPECT_NEAR(time_to(0), move_s, 1e-9);
    planner.SetPointAccuracyParameter(1, 2);
    EXPECT_NEAR(time_to(50), move_s, 1e-9) << "not selected";
    planner.SelectPointAccuracy(1);
    EXPECT_NEAR(time_to(0), move_s + 2, 1e-9);
}

}  // namespace
}  // namespace gsim::motion::flyby_test
