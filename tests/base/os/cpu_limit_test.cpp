#include "base/os/cpu_limit.h"

#include <gtest/gtest.h>

namespace gsim::os {
namespace {

TEST(CpuLimit, StaysReachedAfterWork) {
    CpuLimit limit(0.02);
    EXPECT_EQ(limit.seconds(), 0.02);
    while (!limit.reached()) {
    }
    EXPECT_TRUE(limit.reached());
}

TEST(CpuLimit, TinyLimitIsReachedAtFirstCheck) {
    CpuLimit limit(1e-9);
    EXPECT_TRUE(limit.reached());
}

TEST(CpuLimit, LargeLimitIsNotReached) {
    for (const double seconds : {1e3, 1e9, 1e300}) {
        CpuLimit limit(seconds);
        for (int i = 0; i < 1000; ++i) EXPECT_FALSE(limit.reached());
    }
}

}  // namespace
}  // namespace gsim::os
