#include "cam/waterjet/cutting_speed.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cam/waterjet/water_flow.h"

namespace gsim::waterjet::cutting_speed_test {
namespace {

constexpr double kMmInInch = 25.4;
constexpr double kGramInPound = 453.59237;
constexpr double kMpaInKpsi = 6.894757;

double uniform(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

JetSetting random_jet(std::mt19937& random) {
    JetSetting jet;
    jet.pressure_mpa = uniform(random, 170, 415);
    jet.orifice_mm = uniform(random, 0.1, 0.5);
    jet.mixing_tube_mm = jet.orifice_mm * uniform(random, 2, 4);
    jet.abrasive_g_min = uniform(random, 50, 900);
    return jet;
}

// The equation in the units of its first publication, with the constant that belongs to them.
double speed_in_min(const JetSetting& jet, double machinability, double thickness_mm, double quality) {
    const double strength = std::pow(jet.pressure_mpa / kMpaInKpsi, 1.594) *
                            std::pow(jet.orifice_mm / kMmInInch, 1.374) *
                            std::pow(jet.abrasive_g_min / kGramInPound, 0.343);
    return std::pow(
        machinability * strength /
            (163 * quality * thickness_mm / kMmInInch * std::pow(jet.mixing_tube_mm / kMmInInch, 0.618)),
        1.15);
}

// Both constants are published with three digits: 163 +-0.5 alone is 0.35 % of the speed.
TEST(CuttingSpeed, MatchesEquationInInchUnits) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const JetSetting jet = random_jet(random);
        const double machinability = uniform(random, 20, 700);
        const double thickness_mm = uniform(random, 1, 100);
        const double quality = uniform(random, 1, 5);
        const double speed = cutting_speed_mm_min(jet, machinability, thickness_mm, quality);
        EXPECT_NEAR(speed / (kMmInInch * speed_in_min(jet, machinability, thickness_mm, quality)), 1, 0.004);
    }
}

// A jet of 50 kpsi with 0.014 in, 0.042 in and 0.8 lb/min cuts aluminum (213) of half an inch with quality 3
// at 11.4 in/min: 50^1.594 = 510.7, 0.014^1.374 = 0.0028364, 0.8^0.343 = 0.92632, 0.042^0.618 = 0.14098.
TEST(CuttingSpeed, MatchesHandCalculation) {
    const JetSetting jet{.pressure_mpa = 50 * kMpaInKpsi,
                         .orifice_mm = 0.014 * kMmInInch,
                         .mixing_tube_mm = 0.042 * kMmInInch,
                         .abrasive_g_min = 0.8 * kGramInPound};
    const double in_brackets = 213 * 510.7 * 0.0028364 * 0.92632 / (163 * 3 * 0.5 * 0.14098);
    const double speed_in_min_by_hand = std::exp(1.15 * std::log(in_brackets));
    EXPECT_NEAR(cutting_speed_mm_min(jet, 213, 0.5 * kMmInInch, 3) / kMmInInch, speed_in_min_by_hand,
                0.004 * speed_in_min_by_hand);
    EXPECT_NEAR(speed_in_min_by_hand, 11.39, 0.01);
}

TEST(CuttingSpeed, IsMonotonicInEachParameter) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const JetSetting jet = random_jet(random);
        const double more = uniform(random, 1.01, 2);
        const double speed = cutting_speed_mm_min(jet, 100, 10, 2);
        const auto changed = [&](double JetSetting::*member) {
            JetSetting other = jet;
            other.*member *= more;
            return cutting_speed_mm_min(other, 100, 10, 2);
        };
        EXPECT_GT(changed(&JetSetting::pressure_mpa), speed);
        EXPECT_GT(changed(&JetSetting::orifice_mm), speed);
        EXPECT_GT(changed(&JetSetting::abrasive_g_min), speed);
        EXPECT_GT(changed(&JetSetting::abrasive_factor), speed);
        EXPECT_LT(changed(&JetSetting::mixing_tube_mm), speed);
        EXPECT_GT(cutting_speed_mm_min(jet, 100 * more, 10, 2), speed);
        EXPECT_LT(cutting_speed_mm_min(jet, 100, 10 * more, 2), speed);
        EXPECT_LT(cutting_speed_mm_min(jet, 100, 10, 2 * more), speed);
    }
}

// Twice the thickness at half the quality is the same cut; the speed varies with the power 1.15.
TEST(CuttingSpeed, DependsOnProductOfQualityAndThickness) {
    std::mt19937 random(3);
    const JetSetting jet = random_jet(random);
    EXPECT_NEAR(cutting_speed_mm_min(jet, 80, 20, 2), cutting_speed_mm_min(jet, 80, 10, 4), 1e-9);
    EXPECT_NEAR(cutting_speed_mm_min(jet, 80, 10, 1) / cutting_speed_mm_min(jet, 80, 10, 5),
                std::pow(5, 1.15), 1e-9);
}

// A maker of machines (WARDJet) cuts aluminum of 4 in at 4.2 in/min with quality 1, at 0.72 with quality 5.
TEST(CuttingSpeed, QualityRangeMatchesPublishedThickPlate) {
    const JetSetting jet{345, 0.35, 1.05, 370, 1};
    const double span =
        cutting_speed_mm_min(jet, 213, 4 * kMmInInch, 1) / cutting_speed_mm_min(jet, 213, 4 * kMmInInch, 5);
    EXPECT_NEAR(span, 4.2 / 0.72, 0.1 * span);
}

TEST(CuttingSpeed, MachinabilityOfCutIsInverse) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        const JetSetting jet = random_jet(random);
        const double machinability = uniform(random, 5, 1000);
        const double thickness_mm = uniform(random, 0.5, 200);
        const double quality = uniform(random, 1, 5);
        const double speed = cutting_speed_mm_min(jet, machinability, thickness_mm, quality);
        EXPECT_NEAR(machinability_of_cut(jet, speed, thickness_mm, quality), machinability,
                    1e-9 * machinability);
    }
}

// In US units the equation of the orifice is Q = 29.84 C_d d^2 sqrt(p): 0.931 gal/min for 0.014 in and
// 60,000 psi with C_d = 0.65.
TEST(WaterFlow, MatchesKnownFlowOfUsualOrifice) {
    constexpr double kLitresInGallon = 3.785411784;
    const double flow = water_flow_l_min(0.014 * kMmInInch, 60 * kMpaInKpsi, 0.65);
    EXPECT_NEAR(flow / kLitresInGallon, 0.931, 0.002);
}

TEST(WaterFlow, GrowsWithAreaAndRootOfPressure) {
    const double flow = water_flow_l_min(0.3, 300, 0.65);
    EXPECT_NEAR(water_flow_l_min(0.6, 300, 0.65), 4 * flow, 1e-12);
    EXPECT_NEAR(water_flow_l_min(0.3, 75, 0.65), flow / 2, 1e-12);
}

}  // namespace
}  // namespace gsim::waterjet::cutting_speed_test
