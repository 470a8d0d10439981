#include "controller/services/planner_capabilities.h"

#include <gtest/gtest.h>

#include "controller/services/controller_rules.h"

namespace gsim::rrs::planner_capabilities_test {
namespace {

TEST(PlannerCapabilities, EachPlannerKindHasItsName) {
    EXPECT_EQ(capabilities_of(PlannerKind::rest_to_rest).name, "rest-to-rest");
    EXPECT_EQ(capabilities_of(PlannerKind::look_ahead).name, "look-ahead");
    EXPECT_EQ(capabilities_of(PlannerKind::linuxcnc).name, "linuxcnc");
    EXPECT_EQ(capabilities_of(PlannerKind::klipper).name, "klipper");
}

TEST(PlannerCapabilities, MessageListsPlannersWithoutCapability) {
    EXPECT_EQ(planners_without(&PlannerCapabilities::plans_great_circles), "\"linuxcnc\" and \"klipper\"");
    EXPECT_EQ(planners_without(&PlannerCapabilities::has_deceleration_limits), "\"linuxcnc\"");
    EXPECT_EQ(planners_without(&PlannerCapabilities::plans_tool_paths),
              "\"rest-to-rest\", \"linuxcnc\" and \"klipper\"");
}

TEST(PlannerCapabilities, SCurvesOfLinuxcncNeedRelease210) {
    ControllerRules rules;
    EXPECT_TRUE(rules.has_s_curves());
    rules.planner = PlannerKind::klipper;
    EXPECT_FALSE(rules.has_s_curves());
    rules.planner = PlannerKind::linuxcnc;
    EXPECT_FALSE(rules.has_s_curves());
    rules.linuxcnc.release = LinuxcncRelease::v2_10;
    EXPECT_TRUE(rules.has_s_curves());
}

TEST(PlannerCapabilities, ArcsAsChordsExcludeGreatCircles) {
    ControllerRules rules;
    EXPECT_TRUE(rules.has_great_circles());
    rules.curves.arc_chord_tolerance_mm = 0.002;
    EXPECT_FALSE(rules.has_great_circles());
}

}  // namespace
}  // namespace gsim::rrs::planner_capabilities_test
