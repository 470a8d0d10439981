#include "studio/engine/message.h"

#include <gtest/gtest.h>

#include "tests/studio/engine/frames.h"

namespace gsim::studio {
namespace {

TEST(Message, ContainsSizeHeaderAndAlignedColumns) {
    Message message("segments");
    message.header()["robot"] = 1;
    message.add("start_s", std::vector<double>{0.5, 1.25, -3});
    message.add("line", std::vector<std::uint32_t>{7});
    message.add("vertex_mm", std::vector<float>{1, 2, 3});
    message.add("lua", std::string("G1{}"));
    const std::string bytes = message.bytes();
    EXPECT_EQ(number_at(bytes, 0), bytes.size());
    EXPECT_EQ(bytes.size() % 8, 0U);
    const Frame frame = read_frame(bytes);
    EXPECT_EQ(frame.is(), "segments");
    EXPECT_EQ(frame.header["robot"], 1);
    EXPECT_EQ(frame.column<double>("start_s"), (std::vector<double>{0.5, 1.25, -3}));
    EXPECT_EQ(frame.column<std::uint32_t>("line"), std::vector<std::uint32_t>{7});
    EXPECT_EQ(frame.column<float>("vertex_mm"), (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(frame.columns.at("lua"), "G1{}");
}

TEST(Message, AcceptsNoColumnsAndEmptyColumns) {
    EXPECT_EQ(read_frame(Message("done").bytes()).is(), "done");
    Message empty("segments");
    empty.add("start_s", std::vector<double>{});
    EXPECT_TRUE(read_frame(empty.bytes()).column<double>("start_s").empty());
}

TEST(Message, ReplacesInvalidUtf8InHeader) {
    Message message("diagnostic");
    message.header()["text"] = "\xff\xfe";
    EXPECT_EQ(read_frame(message.bytes()).header["text"], "\xef\xbf\xbd\xef\xbf\xbd");
}

}  // namespace
}  // namespace gsim::studio
