#include "runtime/outputs/dxf_writer.h"

#include <gtest/gtest.h>

#include "tests/runtime/simulator/string_stream.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::dxf_writer_test {
namespace {

/// A zigzag of so many moves, 1 s and 10 mm each.
void draw(DxfWriter& writer, int moves) {
    writer.begin(joints(0, 0));
    for (int i = 0; i < moves; ++i) {
        motion::Segment segment;
        segment.kind = motion::SegmentKind::linear;
        segment.target_id = i + 1;
        segment.start_s = i;
        segment.duration_s = 1;
        segment.start = joints(i % 2 == 0 ? 0 : 10, 0);
        segment.end = joints(i % 2 == 0 ? 10 : 0, 0);
        writer.on_segment(segment, {.target_id = i + 1, .kind = MoveKind::linear});
    }
    writer.end(moves);
}

TEST(DxfWriter, TruncatesTooManyPoints) {
    for (const std::uint64_t max : {4U, 5U}) {
        StringStream stream;
        DxfWriter writer(stream.out(), af5(), max);
        draw(writer, 5);
        EXPECT_EQ(writer.is_truncated(), max == 4);
    }
}

TEST(DxfWriter, WritesCompleteFile) {
    StringStream stream;
    DxfWriter writer(stream.out(), af5());
    draw(writer, 2);
    const std::string text = stream.text();
    EXPECT_TRUE(text.starts_with("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n"));
    EXPECT_TRUE(text.ends_with("0\nENDSEC\n0\nEOF\n"));
    EXPECT_NE(text.find("0\nLINE\n8\nFEED\n10\n0.000000000000\n"), std::string::npos);
}

}  // namespace
}  // namespace gsim::simulation::dxf_writer_test
