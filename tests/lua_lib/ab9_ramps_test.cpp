// G47 to G48.3: how motion speeds up and slows down.

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_ramps_test {
namespace {

/// Returns the cycle time of 100 mm at 6000 mm/min after `words`.
double time_s(const std::string& words) {
    const Outcome r = run(words + "\nG1 X100 F6000\nM30\n");
    EXPECT_TRUE(r.completed()) << words << ": " << r.message();
    return r.report.cycle_time_s;
}

TEST(Ab9Ramps, InfiniteRampTakesNoTime) {
    const double straight_s = time_s("");
    EXPECT_GT(straight_s, 1.05);
    EXPECT_NEAR(time_s("G47.9"), 1.0, 1e-9);
    EXPECT_EQ(time_s("G47"), straight_s);
    EXPECT_EQ(time_s("G47.9\nG47"), straight_s);
}

TEST(Ab9Ramps, SCurveRequiresJerk) {
    const double straight_s = time_s("");
    EXPECT_EQ(time_s("G47.1"), straight_s);
    const Outcome r = run("G47.1\nG1 X1 F600\nM30\n");
    ASSERT_FALSE(r.report.messages.warnings.empty());
    EXPECT_NE(r.report.messages.warnings[0].find("jerk"), std::string::npos);
    EXPECT_GT(time_s("G47.1\nG48.3 X1000"), straight_s + 0.1);
    EXPECT_EQ(time_s("G48.3 X1000"), straight_s) << "no S-curves are selected";
}

// 100 mm at 100 mm/s: each ramp costs half of its time.
TEST(Ab9Ramps, LimitsUseProgramUnits) {
    EXPECT_NEAR(time_s("G48.1 X400\nG48.2 X200"), 1 + 0.125 + 0.25, 1e-9);
    EXPECT_NEAR(time_s("G20 G48.1 X10\nG48.2 X10\nG21"), 1 + 100 / 254.0, 1e-9);
    EXPECT_EQ(time_s("G48.1 X100\nG48"), time_s(""));
    EXPECT_EQ(time_s("G48.1 X1000000"), time_s("")) << "the machine's hold";
}

TEST(Ab9Ramps, RejectsInvalidValues) {
    EXPECT_FALSE(run("G48.1 X0\nM30\n").completed());
    EXPECT_FALSE(run("G48.1\nM30\n").completed());
    EXPECT_FALSE(run("G48.2 W5\nM30\n").completed());
}

}  // namespace
}  // namespace gsim::script::ab9_ramps_test
