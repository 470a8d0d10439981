#include "cli/progress.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace gsim::apps::progress_test {
namespace {

std::string drawn(bool enabled, std::uint64_t done, std::uint64_t total) {
    char* data = nullptr;
    std::size_t size = 0;
    std::FILE* file = ::open_memstream(&data, &size);
    {
        Progress progress(file, enabled);
        progress.update(done, total);
    }
    std::fclose(file);
    std::string text(data, size);
    std::free(data);
    return text;
}

TEST(Progress, DrawsAndClearsBar) {
    const std::string bar = std::string(20, '=') + std::string(20, ' ');
    EXPECT_EQ(drawn(true, 5, 10), "\r[" + bar + "]  50 %\r\x1b[K");
    EXPECT_EQ(drawn(true, 20, 10), "\r[" + std::string(40, '=') + "] 100 %\r\x1b[K");
    EXPECT_EQ(drawn(true, 5, 0), "\r5 blocks\r\x1b[K");
}

TEST(Progress, IsSilentWithoutTerminal) {
    EXPECT_EQ(drawn(false, 5, 10), "");
    std::FILE* file = std::tmpfile();
    {
        Progress progress(file);
        progress.update(1, 2);
    }
    EXPECT_EQ(std::ftell(file), 0);
    std::fclose(file);
}

}  // namespace
}  // namespace gsim::apps::progress_test
