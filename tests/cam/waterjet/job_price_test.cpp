#include "cam/waterjet/job_price.h"

#include <random>

#include <gtest/gtest.h>

#include "sample.h"

namespace gsim::waterjet::job_price_test {
namespace {

double uniform(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

// An hour of jet: 60 minutes of water and abrasive, an hour of the nozzle's life.
TEST(JobPrice, MatchesHandCalculationForOneHour) {
    const CuttingPlan plan = sample_plan("aluminum", 12, 3);
    const PriceRule& prices = sample_materials().prices;
    const JobPrice price = price_job(plan, prices, {.cut_length_mm = 60 * plan.cutting_speed_mm_min});
    EXPECT_NEAR(price.jet_time_s, 3600, 1e-9);
    EXPECT_NEAR(price.water_l, 60 * plan.water_l_min, 1e-9);
    EXPECT_NEAR(price.abrasive_kg, 0.06 * plan.jet.abrasive_g_min, 1e-9);
    EXPECT_NEAR(price.orifice_wear, 1 / prices.orifice_life_h, 1e-12);
    const double by_hand = prices.machine_per_h + 0.06 * plan.water_l_min * prices.water_per_m3 +
                           0.06 * plan.jet.abrasive_g_min * prices.abrasive_per_kg +
                           prices.orifice_price / prices.orifice_life_h +
                           prices.mixing_tube_price / prices.mixing_tube_life_h;
    EXPECT_NEAR(price.total, by_hand, 1e-9);
}

TEST(JobPrice, TimesAddUp) {
    const CuttingPlan plan = sample_plan("stainless steel", 20, 2);
    const JobPrice price =
        price_job(plan, sample_materials().prices,
                  {.cut_length_mm = 1000, .pierces = 7, .cut_time_s = 321, .other_time_s = 40});
    EXPECT_DOUBLE_EQ(price.cut_time_s, 321) << "what the moves take, not the straight line's speed";
    EXPECT_DOUBLE_EQ(price.pierce_time_s, 7 * plan.pierce_s);
    EXPECT_DOUBLE_EQ(price.jet_time_s, 321 + 7 * plan.pierce_s);
    EXPECT_DOUBLE_EQ(price.machine_time_s, price.jet_time_s + 40);
}

TEST(JobPrice, EmptyJobCostsNothing) {
    EXPECT_EQ(price_job(sample_plan("glass", 5, 3), sample_materials().prices, {}).total, 0);
}

// Two jobs cost as much as both together.
TEST(JobPrice, IsLinearInQuantities) {
    const CuttingPlan plan = sample_plan("granite", 30, 3);
    const PriceRule& prices = sample_materials().prices;
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const JobQuantities a{.cut_length_mm = uniform(random, 0, 1e5), .pierces = random() % 50};
        const JobQuantities b{.cut_length_mm = uniform(random, 0, 1e5), .pierces = random() % 50};
        const JobQuantities both{.cut_length_mm = a.cut_length_mm + b.cut_length_mm,
                                 .pierces = a.pierces + b.pierces};
        const double sum = price_job(plan, prices, a).total + price_job(plan, prices, b).total;
        EXPECT_NEAR(price_job(plan, prices, both).total, sum, 1e-9 * sum);
    }
}

// The thesis: abrasive is up to half of the cost, and 50 to 70 % of it can be used again. That makes cutting
// up to 40 % cheaper. Half of the cost and 70 % are 35 %, if the second use is free.
TEST(JobPrice, RecyclingSavesAtMostRecycledShareOfAbrasive) {
    const CuttingPlan plan = sample_plan("aluminum", 12, 3);
    PriceRule prices = sample_materials().prices;
    const JobQuantities job{.cut_length_mm = 5000, .pierces = 10};
    prices.recycled_share = 0;
    const JobPrice once = price_job(plan, prices, job);
    prices.abrasive_per_kg = (once.total - once.abrasive_kg * prices.abrasive_per_kg) / once.abrasive_kg;
    const double total = price_job(plan, prices, job).total;  // half of it abrasive
    prices.recycled_share = 0.7;
    prices.recycled_per_kg = 0;
    EXPECT_NEAR(price_job(plan, prices, job).total / total, 0.65, 1e-9);
    prices.recycled_per_kg = prices.abrasive_per_kg;
    EXPECT_NEAR(price_job(plan, prices, job).total / total, 1, 1e-9);
}

}  // namespace
}  // namespace gsim::waterjet::job_price_test
