#include "tests/accuracy/distribution.h"

#include <cmath>

#include <gtest/gtest.h>

namespace gsim::accuracy::distribution_test {
namespace {

TimeOutcome outcome(const std::string& name, double recorded_s, double found_s) {
    return {name, "", true, recorded_s, found_s, ""};
}

TEST(Distribution, UsesAbsoluteErrors) {
    std::vector<TimeOutcome> outcomes;
    for (int i = 1; i <= 20; ++i)
        outcomes.push_back(outcome("p" + std::to_string(i), 100, i % 2 == 0 ? 100 + i : 100 - i));
    const Distribution all = distribution_of(outcomes);
    EXPECT_EQ(all.count, 20U);
    EXPECT_DOUBLE_EQ(all.median_percent, 10);
    EXPECT_DOUBLE_EQ(all.p95_percent, 19);
    EXPECT_DOUBLE_EQ(all.largest_percent, 20);
    EXPECT_EQ(all.largest, "p20");
    EXPECT_EQ(all.within, 0U);
}

TEST(Distribution, CountsRejectedButNotUncountedRuns) {
    TimeOutcome rejected = outcome("refused", 1, 1);
    rejected.found_s = Unexpected("no");
    TimeOutcome left_out = outcome("left out", 1, 9);
    left_out.counted = false;
    const Distribution all = distribution_of({outcome("a", 1, 1.004), rejected, left_out});
    EXPECT_EQ(all.count, 2U);
    EXPECT_EQ(all.within, 1U);
    EXPECT_EQ(all.largest, "a");
    EXPECT_TRUE(std::isinf(all.p95_percent));
    EXPECT_EQ(distribution_of({}).count, 0U);
}

}  // namespace
}  // namespace gsim::accuracy::distribution_test
