#include "tests/accuracy/outcome.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::accuracy::outcome_test {
namespace {

const Controller kController{"any", "", "", true, {0.5, 0.005}, {2, 0.005}};

TimeOutcome outcome(double recorded_s, double found_s) {
    TimeOutcome sample_outcome;
    sample_outcome.name = "router_a";
    sample_outcome.recorded_s = recorded_s;
    sample_outcome.found_s = found_s;
    return sample_outcome;
}

TimeOutcome rejected() {
    TimeOutcome sample_outcome = outcome(1, 1);
    sample_outcome.found_s = Unexpected("alarm");
    return sample_outcome;
}

TimeOutcome uncounted(TimeOutcome sample_outcome) {
    sample_outcome.counted = false;
    return sample_outcome;
}

TimeOutcome known(TimeOutcome sample_outcome) {
    sample_outcome.known = "a reason";
    return sample_outcome;
}

TEST(TimeOutcome, IsMarkedByTolerances) {
    EXPECT_EQ(mark(outcome(10, 10.04), kController), Mark::close);
    EXPECT_EQ(mark(outcome(10, 9.9), kController), Mark::fair);
    EXPECT_EQ(mark(outcome(10, 10.21), kController), Mark::off);
    EXPECT_EQ(mark(outcome(10, std::nan("")), kController), Mark::off);
    EXPECT_EQ(mark(outcome(0.1, 0.105), kController), Mark::close);
    EXPECT_EQ(mark(rejected(), kController), Mark::rejected);
    EXPECT_EQ(mark(uncounted(rejected()), kController), Mark::not_counted);
    EXPECT_EQ(name(Mark::close), "good");
    EXPECT_EQ(name(Mark::not_counted), "not counted");
}

TEST(TimeOutcome, HasErrorInPercentOfRecordedTime) {
    EXPECT_NEAR(outcome(2, 1.9).error_percent(), -5, 1e-9);
    EXPECT_EQ(outcome(0, 0).error_percent(), 0);
    EXPECT_TRUE(std::isinf(outcome(0, 1).error_percent()));
}

TEST(Summary, CountsOutcomesAndFindsLargestError) {
    std::vector<TimeOutcome> outcomes{outcome(10, 10.01), outcome(10, 9.85), outcome(1, 1.5), rejected(),
                                      uncounted(outcome(1, 9))};
    outcomes[2].name = "worst";
    const Summary summary = summarize(outcomes, kController);
    EXPECT_EQ(summary.counted, 4U);
    EXPECT_EQ(summary.close, 1U);
    EXPECT_EQ(summary.fair, 2U);
    EXPECT_EQ(summary.unknown, 2U);
    ASSERT_TRUE(summary.largest);
    EXPECT_EQ(summary.largest->name, "worst");
    EXPECT_FALSE(summary.good());
}

TEST(Summary, IsGoodWith95PercentCloseAndOthersFair) {
    std::vector<TimeOutcome> outcomes(19, outcome(10, 10));
    outcomes.push_back(outcome(10, 10.1));
    EXPECT_TRUE(summarize(outcomes, kController).good());  // 19 of 20
    outcomes.front() = outcome(10, 10.1);
    EXPECT_FALSE(summarize(outcomes, kController).good());  // 18 of 20
}

TEST(Summary, UsesSharesOfItsController) {
    Controller half = kController;
    half.close_percent = 50;
    half.fair_percent = 75;
    std::vector<TimeOutcome> outcomes{outcome(10, 10), outcome(10, 10), outcome(10, 10.1), outcome(10, 11)};
    EXPECT_TRUE(summarize(outcomes, half).good());
    outcomes[2] = outcome(10, 11);
    EXPECT_FALSE(summarize(outcomes, half).good());
    outcomes[2] = outcomes[1] = outcome(10, 10.1);
    EXPECT_FALSE(summarize(outcomes, half).good());
}

TEST(Summary, IgnoresKnownErrorsButNotIn95Percent) {
    std::vector<TimeOutcome> outcomes(19, outcome(10, 10));
    outcomes.push_back(outcome(10, 11));
    EXPECT_FALSE(summarize(outcomes, kController).good());
    outcomes.back() = known(outcome(10, 11));
    EXPECT_TRUE(summarize(outcomes, kController).good());
    outcomes.back() = known(rejected());
    EXPECT_TRUE(summarize(outcomes, kController).good());
    outcomes.push_back(known(outcome(10, 11)));
    EXPECT_FALSE(summarize(outcomes, kController).good());  // 19 of 21
}

TEST(Summary, IgnoresUncountedOutcomes) {
    const std::vector<TimeOutcome> outcomes{outcome(10, 10), uncounted(outcome(1, 9)), uncounted(rejected())};
    EXPECT_TRUE(summarize(outcomes, kController).good());
}

TEST(PathOutcome, IsGoodWithin1Mm) {
    EXPECT_TRUE((PathOutcome{"a", Distance{1.0, 3, 0.1}, ""}.good()));
    EXPECT_FALSE((PathOutcome{"a", Distance{1.001, 3, 0.1}, ""}.good()));
    EXPECT_FALSE((PathOutcome{"a", Distance{std::nan(""), 3, 0.1}, ""}.good()));
    EXPECT_FALSE((PathOutcome{"a", Unexpected("refused"), ""}.good()));
}

}  // namespace
}  // namespace gsim::accuracy::outcome_test
