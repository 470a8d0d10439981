#include "runtime/outputs/text_stream.h"

#include <gtest/gtest.h>

#include "base/text/format.h"

namespace gsim::simulation::text_stream_test {
namespace {

TEST(TextStream, DropsOutputAfterWriteError) {
    int chunk_count = 0;
    TextStream stream([&](std::string_view) { return ++chunk_count < 2; });
    for (int i = 0; i < 100000; ++i) {
        text::append_format(stream.buffer(), "line {}", i);
        stream.end_line();
    }
    stream.flush();
    EXPECT_TRUE(stream.failed());
    EXPECT_EQ(stream.buffer().size(), 0u);
    EXPECT_EQ(chunk_count, 2) << "nothing is given behind a failure";
}

}  // namespace
}  // namespace gsim::simulation::text_stream_test
