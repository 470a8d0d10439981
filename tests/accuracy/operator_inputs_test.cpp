#include "tests/accuracy/operator_inputs.h"

#include <gtest/gtest.h>

namespace gsim::accuracy::operator_inputs_test {
namespace {

TEST(OperatorInputs, BecomeTimedOverrides) {
    EXPECT_EQ(overrides_of("").value(), "");
    EXPECT_EQ(overrides_of("0.5:0x92;0.5:0x92;1:0x97;2:0x90").value(),
              "[[override]]\nat_s = 0.500000\nfeed_percent = 80.0\nrapid_percent = 100.0\n\n"
              "[[override]]\nat_s = 1.000000\nfeed_percent = 80.0\nrapid_percent = 25.0\n\n"
              "[[override]]\nat_s = 2.000000\nfeed_percent = 100.0\nrapid_percent = 25.0\n\n");
}

TEST(OperatorInputs, ClampFeedOverrideToItsRange) {
    std::string inputs;
    for (int i = 0; i < 12; ++i) inputs += "0:0x91;";
    EXPECT_NE(overrides_of(inputs).value().find("feed_percent = 200.0"), std::string::npos);
}

TEST(OperatorInputs, AreRejectedIfUnknownOrMalformed) {
    EXPECT_NE(overrides_of("0.9:0x21").error().message.find("0x21"), std::string::npos);
    EXPECT_FALSE(overrides_of("soon:0x91"));
    EXPECT_FALSE(overrides_of("0x91"));
}

}  // namespace
}  // namespace gsim::accuracy::operator_inputs_test
