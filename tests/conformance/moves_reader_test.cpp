#include "tests/conformance/moves_reader.h"

#include <sstream>

#include <gtest/gtest.h>

namespace gsim::conformance::moves_reader_test {
namespace {

TEST(MovesReader, ReadsMovesArcsAndDwells) {
    std::istringstream text(
        R"({"n":1,"file":"a.nc","line":3,"kind":"rapid","to":{"X":1,"Y":2,"Z":3,"A":4,"U":9},"feed":null,"start_s":0,"end_s":1}
{"n":2,"file":"a.nc","line":4,"kind":"arc_cw","to":{"X":5,"Y":2,"Z":3},"center":{"X":3,"Y":2,"Z":3},"normal":{"X":0,"Y":1,"Z":0},"plane":"zx","turns":2,"feed":100,"start_s":1,"end_s":2}
{"n":3,"file":null,"line":null,"kind":"dwell","to":{"X":5,"Y":2,"Z":3},"feed":null,"start_s":2,"end_s":2.5}
)");
    const auto moves = read_moves(text);
    ASSERT_TRUE(moves) << moves.error().message;
    ASSERT_EQ(moves->size(), 3U);
    EXPECT_EQ((*moves)[0].kind, Kind::rapid);
    EXPECT_EQ((*moves)[0].to, (AxisValues{1, 2, 3, 4, 0, 0}));
    EXPECT_EQ((*moves)[0].line, 3);
    EXPECT_FALSE((*moves)[0].feed_per_min);
    EXPECT_EQ((*moves)[1].kind, Kind::arc_cw);
    EXPECT_EQ((*moves)[1].arc->normal, plane_normal(Plane::zx));
    EXPECT_EQ((*moves)[1].arc->turns, 2);
    EXPECT_EQ((*moves)[1].arc->center_mm[0], 3);
    EXPECT_EQ((*moves)[1].feed_per_min, 100);
    EXPECT_EQ((*moves)[2].dwell_s, 0.5);
    EXPECT_EQ((*moves)[2].line, 0);
}

TEST(MovesReader, NamesUnreadableLine) {
    std::istringstream text(R"({"kind":"loop"})");
    const auto moves = read_moves(text);
    ASSERT_FALSE(moves);
    EXPECT_EQ(moves.error().message,
              "line 1 of the moves cannot be understood: its kind 'loop' is not known");
    std::istringstream broken("{");
    EXPECT_FALSE(read_moves(broken));
}

}  // namespace
}  // namespace gsim::conformance::moves_reader_test
