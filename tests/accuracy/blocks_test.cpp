#include "tests/accuracy/blocks.h"

#include <sstream>

#include <gtest/gtest.h>

namespace gsim::accuracy::blocks_test {
namespace {

TEST(Blocks, FollowOneAnotherWithoutPauses) {
    const auto blocks = blocks_of({{3, 0.5}, {0, 0.25}, {5, 1}, {3, 2}, {0, 0.002}});
    ASSERT_EQ(blocks.size(), 3U);
    EXPECT_EQ(blocks[0].line, 3);
    EXPECT_EQ(blocks[0].start_s, 0);
    EXPECT_EQ(blocks[0].end_s, 0.5);
    EXPECT_EQ(blocks[1].line, 5);
    EXPECT_EQ(blocks[1].start_s, 0.75);
    EXPECT_EQ(blocks[1].end_s, 1.75);
    EXPECT_EQ(blocks[2].line, 3);  // a line may come again
    EXPECT_EQ(blocks[2].end_s, 3.75);
}

TEST(Blocks, GroupConsecutiveMovesOfLine) {
    std::istringstream moves(
        R"({"n":1,"file":"a.ngc","line":3,"kind":"rapid","to":{},"start_s":0,"end_s":1}
{"n":2,"file":"a.ngc","line":3,"kind":"linear","to":{},"start_s":1,"end_s":1.5}

{"n":3,"file":"a.ngc","line":4,"kind":"linear","to":{},"start_s":1.5,"end_s":1.5}
{"n":4,"file":null,"line":null,"kind":"dwell","to":{},"start_s":1.5,"end_s":2}
{"n":5,"file":"a.ngc","line":6,"kind":"arc_cw","to":{},"start_s":2,"end_s":4}
)");
    const auto blocks = read_blocks(moves);
    ASSERT_TRUE(blocks) << blocks.error().message;
    ASSERT_EQ(blocks->size(), 2U);
    EXPECT_EQ((*blocks)[0].line, 3);
    EXPECT_EQ((*blocks)[0].start_s, 0);
    EXPECT_EQ((*blocks)[0].end_s, 1.5);
    EXPECT_EQ((*blocks)[1].line, 6);
    EXPECT_EQ((*blocks)[1].start_s, 2);
    EXPECT_EQ((*blocks)[1].end_s, 4);
}

TEST(Blocks, ReportUnreadableLine) {
    std::istringstream moves("\n{\"line\":3}");
    const auto blocks = read_blocks(moves);
    ASSERT_FALSE(blocks);
    EXPECT_EQ(blocks.error().message.find("line 2 of the moves cannot be understood: "), 0U)
        << blocks.error().message;
    std::istringstream broken("{");
    EXPECT_FALSE(read_blocks(broken));
}

}  // namespace
}  // namespace gsim::accuracy::blocks_test
