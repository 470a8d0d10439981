#include "batch/plan/design.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace gsim::batch::design_test {
namespace {

std::vector<double> values(const Design& design, std::size_t setting) {
    std::vector<double> found;
    for (std::uint64_t run = 0; run < design.size(); ++run)
        found.push_back(design.variant(run)[setting].value);
    return found;
}

std::vector<Setting> two_uniform() {
    return {{.keys = {"machine.a"}, .domain = Uniform{0, 1}},
            {.keys = {"machine.b"}, .domain = Uniform{-3, 5}}};
}

TEST(Design, GridHasEachCombination) {
    const Design design({{.keys = {"machine.a"}, .domain = Choices{{1, 2, 3}}},
                         {.keys = {"option.dialect"}, .domain = Choices{{"ab9", "rs274ngc"}}}},
                        {});
    ASSERT_EQ(design.size(), 6U);
    std::set<std::string> all;
    for (std::uint64_t run = 0; run < 6; ++run) all.insert(settings_json(design.variant(run)).dump());
    EXPECT_EQ(all.size(), 6U);
    EXPECT_EQ(design.variant(1)[0].value, 1);
    EXPECT_EQ(design.variant(1)[1].value, "rs274ngc");
    EXPECT_EQ(Design({}, {}).size(), 1U) << "nothing to change is one variant";
}

TEST(Design, LatinHypercubeHasOneValuePerInterval) {
    constexpr std::uint64_t kRuns = 97;
    const Design design(two_uniform(), {.sampling = Sampling::latin_hypercube, .runs = kRuns, .seed = 5});
    for (const std::size_t setting : {0U, 1U}) {
        std::set<int> parts;
        for (const double value : values(design, setting)) {
            const double share = setting == 0 ? value : (value + 3) / 8;
            ASSERT_GE(share, 0);
            ASSERT_LT(share, 1);
            parts.insert(static_cast<int>(share * kRuns));
        }
        EXPECT_EQ(parts.size(), kRuns);
    }
}

// The mean of a smooth function comes much nearer than by lot: Owen 1998.
TEST(Design, SobolIsMoreEvenThanRandom) {
    const auto worst = [](Sampling sampling) {
        double max = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Design design(two_uniform(), {.sampling = sampling, .runs = 512, .seed = seed});
            double mean = 0;
            for (std::uint64_t run = 0; run < 512; ++run) {
                const auto variant = design.variant(run);
                mean += variant[0].value.get<double>() * (variant[1].value.get<double>() + 3) / 8 / 512;
            }
            max = std::max(max, std::abs(mean - 0.25));
        }
        return max;
    };
    EXPECT_LT(worst(Sampling::sobol), 0.005);
    EXPECT_GT(worst(Sampling::random), 0.01);
}

TEST(Design, IsSameOnlyForSameSeed) {
    for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
        const auto with_seed = [&](std::uint64_t seed) {
            return values(Design(two_uniform(), {.sampling = sampling, .runs = 16, .seed = seed}), 1);
        };
        EXPECT_EQ(with_seed(1), with_seed(1));
        EXPECT_NE(with_seed(1), with_seed(2));
    }
}

TEST(Domain, HasQuantilesOfItsDistribution) {
    EXPECT_NEAR(value_at(Normal{10, 2}, 0.975).get<double>(), 10 + 2 * 1.959963984540054, 1e-9);
    EXPECT_NEAR(value_at(Normal{10, 2}, 0.5).get<double>(), 10, 1e-12);
    EXPECT_TRUE(std::isfinite(value_at(Normal{10, 2}, 0).get<double>()));
    EXPECT_EQ(value_at(Normal{3, 0}, 0.9), 3.0);
    EXPECT_NEAR(value_at(Uniform{-1, 3}, 0.25).get<double>(), 0, 1e-12);
    // A triangle from 0 over 1 to 4: a quarter lies below its mode.
    EXPECT_NEAR(value_at(Triangular{0, 4, 1}, 0.25).get<double>(), 1, 1e-12);
    EXPECT_NEAR(value_at(Triangular{0, 4, 1}, 0).get<double>(), 0, 1e-12);
    EXPECT_NEAR(value_at(Triangular{0, 4, 1}, 0.75).get<double>(), 4 - std::sqrt(3), 1e-12);
    EXPECT_EQ(value_at(Choices{{"a", "b"}}, 0.49), "a");
    EXPECT_EQ(value_at(Choices{{"a", "b"}}, 0.999999), "b");
}

}  // namespace
}  // namespace gsim::batch::design_test
