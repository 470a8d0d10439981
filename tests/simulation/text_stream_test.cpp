#include "runtime/simulation/text_stream.h"

#include <cerrno>

#include <gtest/gtest.h>

namespace gsim::simulation::text_stream_test {
namespace {

TEST(TextStream, FullDiskIsReportedOnceAndForAll) {
    std::FILE* file = std::fopen("/dev/full", "w");
    if (!file) GTEST_SKIP() << "no /dev/full here";
    TextStream stream(file);
    for (int i = 0; i < 100000; ++i) {
        fmt::format_to(std::back_inserter(stream.buffer()), "line {}", i);
        stream.end_line();
    }
    EXPECT_TRUE(stream.failed());
    EXPECT_LT(stream.buffer().size(), 100000u);
    const auto flushed = stream.flush();
    ASSERT_FALSE(flushed);
    EXPECT_EQ(flushed.error(), ENOSPC);
    std::fclose(file);
}

}  // namespace
}  // namespace gsim::simulation::text_stream_test
