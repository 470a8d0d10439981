#include "cam/waterjet/cutting_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/waterjet/water_flow.h"
#include "sample.h"

namespace gsim::waterjet::cutting_plan_test {
namespace {

using testing::HasSubstr;

CuttingRequest make_request(std::string material, double thickness_mm) {
    CuttingRequest request;
    request.material = std::move(material);
    request.thickness_mm = thickness_mm;
    return request;
}

std::string error_of(const CuttingRequest& request) {
    const auto plan = plan_cutting(sample_materials(), request);
    return plan ? "" : plan.error().message;
}

const ResolvedValue& settled_value(const CuttingPlan& plan, std::string_view name) {
    const auto found = std::find_if(plan.values.begin(), plan.values.end(),
                                    [&](const ResolvedValue& value) { return value.name == name; });
    EXPECT_NE(found, plan.values.end()) << name;
    return *found;
}

TEST(CuttingPlan, ReportsOriginOfEachValue) {
    const CuttingPlan plan = plan_cutting(sample_materials(), make_request("aluminum", 12)).value();
    const JetRule& rule = sample_materials().jet;
    EXPECT_EQ(settled_value(plan, "thickness").origin, Origin::from_request);
    EXPECT_EQ(settled_value(plan, "pressure").origin, Origin::from_file);
    EXPECT_EQ(settled_value(plan, "machinability").origin, Origin::from_file);
    EXPECT_THAT(settled_value(plan, "machinability").basis, HasSubstr("Zeng"));
    EXPECT_EQ(settled_value(plan, "mixing tube").origin, Origin::inferred);
    EXPECT_EQ(settled_value(plan, "mixing tube").basis, "3 times the orifice");
    EXPECT_DOUBLE_EQ(plan.jet.mixing_tube_mm, rule.tube_to_orifice * rule.orifice_mm);
    EXPECT_DOUBLE_EQ(plan.water_l_min, water_flow_l_min(rule.orifice_mm, rule.pressure_mpa, rule.discharge));
    EXPECT_NEAR(plan.jet.abrasive_g_min, rule.abrasive_to_water * 1000 * plan.water_l_min, 1e-9);
    EXPECT_EQ(settled_value(plan, "cutting speed").origin, Origin::inferred);
    EXPECT_DOUBLE_EQ(plan.cutting_speed_mm_min, cutting_speed_mm_min(plan.jet, 213, 12, rule.quality));
    EXPECT_TRUE(plan.warnings.empty());
}

TEST(CuttingPlan, RequestedValuesTakePrecedence) {
    CuttingRequest request = make_request("aluminum", 12);
    request.quality = 5;
    request.pressure_mpa = 300;
    request.orifice_mm = 0.25;
    request.mixing_tube_mm = 0.8;
    request.abrasive_g_min = 200;
    request.speed_mm_min = 50;
    request.kerf_mm = 0.9;
    request.pierce_s = 7;
    const CuttingPlan plan = plan_cutting(sample_materials(), request).value();
    EXPECT_EQ(plan.jet, (JetSetting{300, 0.25, 0.8, 200, 1}));
    EXPECT_EQ(plan.quality, 5);
    EXPECT_EQ(plan.cutting_speed_mm_min, 50);
    EXPECT_EQ(plan.kerf_mm, 0.9);
    EXPECT_EQ(plan.pierce_s, 7);
    for (const std::string_view name :
         {"quality", "pressure", "orifice", "mixing tube", "abrasive", "cutting speed", "kerf", "pierce"})
        EXPECT_EQ(settled_value(plan, name).origin, Origin::from_request) << name;
}

TEST(CuttingPlan, InfersMachinabilityFromSimilarMaterial) {
    const CuttingPlan plan = sample_plan("HY-80 steel", 20, 2);
    EXPECT_EQ(plan.cutting_speed_mm_min, sample_plan("mild steel", 20, 2).cutting_speed_mm_min);
    EXPECT_EQ(settled_value(plan, "machinability").origin, Origin::inferred);
    EXPECT_THAT(settled_value(plan, "machinability").basis, HasSubstr("mild steel"));
}

// A material known by one cut is cut at that speed if all conditions are as they were then.
TEST(CuttingPlan, InfersMachinabilityFromMeasuredCut) {
    Materials materials = sample_materials();
    const JetSetting jet{320, 0.3, 0.9, 250, 1};
    materials.materials.push_back({"own", std::nullopt, "", MeasuredCut{jet, 77, 15, 4}, ""});
    CuttingRequest request = make_request("own", 15);
    request.quality = 4;
    request.pressure_mpa = jet.pressure_mpa;
    request.orifice_mm = jet.orifice_mm;
    request.mixing_tube_mm = jet.mixing_tube_mm;
    request.abrasive_g_min = jet.abrasive_g_min;
    const CuttingPlan plan = plan_cutting(materials, request).value();
    EXPECT_NEAR(plan.cutting_speed_mm_min, 77, 1e-9);
    EXPECT_THAT(settled_value(plan, "machinability").basis, HasSubstr("77 mm/min"));
}

TEST(CuttingPlan, HigherQualityGivesLowerSpeedAndTaper) {
    CuttingPlan before = sample_plan("stainless steel", 20, 1);
    EXPECT_DOUBLE_EQ(before.cutting_speed_mm_min, before.separation_speed_mm_min);
    for (const double quality : {1.5, 2.0, 3.0, 4.0, 5.0}) {
        const CuttingPlan plan = sample_plan("stainless steel", 20, quality);
        EXPECT_LT(plan.cutting_speed_mm_min, before.cutting_speed_mm_min);
        EXPECT_GT(plan.exit_kerf_mm, before.exit_kerf_mm);
        EXPECT_LT(plan.exit_kerf_mm, plan.kerf_mm);
        EXPECT_LT(plan.lag_mm, before.lag_mm);
        EXPECT_LE(plan.contour_error_mm, before.contour_error_mm);
        EXPECT_EQ(plan.pierce_s, before.pierce_s) << "piercing does not know of edges";
        before = plan;
    }
}

TEST(CuttingPlan, PierceTimeGrowsWithThickness) {
    double before = 0;
    for (const double thickness : {0.5, 1.0, 5.0, 12.0, 25.0, 50.0, 100.0}) {
        const double time = sample_plan("stainless steel", thickness, 3).pierce_s;
        EXPECT_GE(time, before);
        EXPECT_GE(time, sample_materials().pierce.min_s);
        before = time;
    }
    EXPECT_GT(sample_plan("stainless steel", 50, 3).pierce_s,
              4 * sample_plan("stainless steel", 25, 3).pierce_s)
        << "more than with the square of the thickness";
}

TEST(CuttingPlan, SpeedAtThicknessMatchesPlanForThatThickness) {
    const CuttingPlan plan = plan_cutting(sample_materials(), make_request("aluminum", 12)).value();
    for (const double thickness_mm : {6.0, 12.0, 30.0}) {
        const CuttingPlan other =
            plan_cutting(sample_materials(), make_request("aluminum", thickness_mm)).value();
        EXPECT_NEAR(speed_at_thickness_mm_min(plan, thickness_mm), other.cutting_speed_mm_min,
                    1e-9 * other.cutting_speed_mm_min);
    }
}

TEST(CuttingPlan, WarnsOfSpeedTooHighToCutThrough) {
    CuttingRequest request = make_request("stainless steel", 50);
    request.speed_mm_min = 5000;
    const CuttingPlan plan = plan_cutting(sample_materials(), request).value();
    ASSERT_EQ(plan.warnings.size(), 1U);
    EXPECT_THAT(plan.warnings[0], HasSubstr("at 5000.0 mm/min the jet does not cut through"));
    EXPECT_GE(plan.exit_kerf_mm, 0);
}

TEST(CuttingPlan, WarnsOfUnusualJets) {
    CuttingRequest request = make_request("glass", 10);
    request.pressure_mpa = 600;
    request.orifice_mm = 1.5;
    const auto warnings = plan_cutting(sample_materials(), request).value().warnings;
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0], "pressure_mpa is 600, outside the usual range of 170 to 415");
}

TEST(CuttingPlan, RejectsUnknownMaterialAndValuesOutOfRange) {
    EXPECT_EQ(error_of(make_request("aluminium", 10)),
              "unknown material \"aluminium\"; did you mean \"aluminum\"?");
    EXPECT_THAT(error_of(make_request("x", 10)), HasSubstr("unknown material"));
    for (const double odd : {0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(error_of(make_request("glass", odd)), HasSubstr("'thickness_mm' must be between")) << odd;
        CuttingRequest request = make_request("glass", 10);
        request.quality = odd;
        EXPECT_THAT(error_of(request), HasSubstr("'quality' must be between 1 and 5")) << odd;
    }
    CuttingRequest request = make_request("glass", 10);
    request.mixing_tube_mm = 0.2;
    EXPECT_EQ(error_of(request), "the mixing tube (0.2 mm) must be wider than the orifice (0.35 mm)");
}

// Whatever is within the ranges, a plan is made of finite numbers.
TEST(CuttingPlan, IsFiniteAtEndsOfRanges) {
    for (const double thickness : {1e-3, 1e4})
        for (const double pressure : {1.0, 1000.0})
            for (const double orifice : {0.01, 10.0})
                for (const double abrasive : {0.01, 1e5}) {
                    CuttingRequest request = make_request("granite", thickness);
                    request.pressure_mpa = pressure;
                    request.orifice_mm = orifice;
                    request.abrasive_g_min = abrasive;
                    const CuttingPlan plan = plan_cutting(sample_materials(), request).value();
                    for (const ResolvedValue& value : plan.values)
                        EXPECT_TRUE(std::isfinite(value.value)) << value.name;
                    EXPECT_GT(feed_for_radius_mm_min(plan, 1), 0);
                    EXPECT_GT(feed_for_corner_mm_min(plan, 1), 0);
                }
}

}  // namespace
}  // namespace gsim::waterjet::cutting_plan_test
