#include "tests/conformance/canon_reader.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/conformance/canon_text.h"

namespace gsim::conformance::canon_reader_test {
namespace {

TEST(CanonReader, ReadsMovesAndDwellsInOrder) {
    const auto moves = expected_moves({"STRAIGHT_TRAVERSE(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)",
                                       "SET_FEED_RATE(100.0)", "STRAIGHT_FEED(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                       "COMMENT(\"DWELL(3)\")", "DWELL(1.5000)"});
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[0].move.kind, Kind::rapid);
    EXPECT_EQ(moves[0].move.to, (AxisValues{1, 2, 3, 4, 5, 6}));
    EXPECT_FALSE(moves[0].move.feed_per_min);
    EXPECT_EQ(moves[1].move.kind, Kind::linear);
    EXPECT_EQ(moves[1].move.feed_per_min, 100);
    EXPECT_EQ(moves[1].move.line, 3);
    EXPECT_EQ(moves[2].move.kind, Kind::dwell);
    EXPECT_EQ(moves[2].move.dwell_s, 1.5);
}

TEST(CanonReader, ReadsArcsInTheirPlane) {
    const auto moves = expected_moves(
        {"ARC_FEED(1.0, 2.0, 3.0, 4.0, -1, 5.0, 6.0, 7.0, 8.0)", "SELECT_PLANE(CANON_PLANE_XZ)",
         "ARC_FEED(1.0, 2.0, 3.0, 4.0, 1, 5.0, 6.0, 7.0, 8.0)", "SELECT_PLANE(CANON_PLANE_YZ)",
         "ARC_FEED(1.0, 2.0, 3.0, 4.0, 3, 5.0, 6.0, 7.0, 8.0)"});
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[0].move.kind, Kind::arc_cw);
    EXPECT_EQ(moves[0].move.to, (AxisValues{1, 2, 5, 6, 7, 8}));
    EXPECT_EQ(moves[0].move.arc->center_mm[0], 3);
    EXPECT_EQ(moves[0].move.arc->center_mm[1], 4);

    EXPECT_EQ(moves[1].move.kind, Kind::arc_ccw);
    EXPECT_EQ(moves[1].move.arc->normal, plane_normal(Plane::zx));
    EXPECT_EQ(moves[1].move.to, (AxisValues{2, 5, 1, 6, 7, 8}));  // Z comes before X
    EXPECT_EQ(moves[1].move.arc->center_mm[2], 3);
    EXPECT_EQ(moves[1].move.arc->center_mm[0], 4);

    EXPECT_EQ(moves[2].move.arc->normal, plane_normal(Plane::yz));
    EXPECT_EQ(moves[2].move.to, (AxisValues{5, 1, 2, 6, 7, 8}));
    EXPECT_EQ(moves[2].move.arc->turns, 3);
}

TEST(CanonReader, RotatesArcCentres) {
    const auto moves =
        expected_moves({"SET_G5X_OFFSET(1, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "SET_XY_ROTATION(90.0)",
                        "ARC_FEED(20.0, 0.0, 10.0, 0.0, 1, 0.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_NEAR(moves[0].move.to[1], 20, 1e-12);
    EXPECT_NEAR(moves[0].move.arc->center_mm[0], 10, 1e-12);
    EXPECT_NEAR(moves[0].move.arc->center_mm[1], 10, 1e-12);
}

// LinuxCNC's controller does the same with the call (ARC_FEED in emccanon.cc): the plane turns with the
// program.
TEST(CanonReader, RotatesArcPlanes) {
    const auto moves = expected_moves({"SET_XY_ROTATION(30.0)", "SELECT_PLANE(CANON_PLANE_XZ)",
                                       "ARC_FEED(0.0, 20.0, 0.0, 10.0, 1, 0.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 1U);
    const ArcPart& arc = *moves[0].move.arc;
    EXPECT_NEAR(arc.normal[0], -0.5, 1e-12);
    EXPECT_NEAR(arc.normal[1], std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(arc.center_mm[0], 10 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(arc.center_mm[1], 5, 1e-12);
}

TEST(CanonReader, ReadsSpindleSynchronizedFeedAsThread) {
    const auto moves =
        expected_moves({"SET_FEED_RATE(5.0)", "START_SPEED_FEED_SYNC(1.25, 0)",
                        "STRAIGHT_FEED(0.0, 0.0, -9.0, 0.0, 0.0, 0.0)", "STOP_SPEED_FEED_SYNCH()",
                        "STRAIGHT_FEED(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[0].move.kind, Kind::thread);
    EXPECT_FALSE(moves[0].move.feed_per_min);
    EXPECT_EQ(moves[1].move.kind, Kind::linear);
}

TEST(CanonReader, ReadsTapAsMoveAndReturn) {
    const auto moves =
        expected_moves({"STRAIGHT_TRAVERSE(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)", "START_SPEED_FEED_SYNC(1.5, 0)",
                        "RIGID_TAP(1.0, 2.0, -20.0)", "STOP_SPEED_FEED_SYNCH()"});
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[1].move.kind, Kind::thread);
    EXPECT_EQ(moves[1].move.to, (AxisValues{1, 2, -20, 4, 5, 6}));
    EXPECT_EQ(moves[2].move.to, (AxisValues{1, 2, 3, 4, 5, 6}));
}

TEST(CanonReader, StopsBeforeProbeTarget) {
    const auto moves = expected_moves({"STRAIGHT_TRAVERSE(0.0, 0.0, 10.0, 0.0, 0.0, 0.0)",
                                       "STRAIGHT_PROBE(0.0, 0.0, -5.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[1].move.to[2], -5);
    EXPECT_NEAR(moves[1].stop[2], -4.746, 1e-12);
}

TEST(CanonReader, ConvertsFeedPerTurnIfSpindleSpeedIsKnown) {
    const auto moves = expected_moves(
        {"SET_FEED_MODE(0, 1)", "SET_FEED_RATE(0.2)", "STRAIGHT_FEED(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
         "SET_SPINDLE_SPEED(0, 1000.0)", "STRAIGHT_FEED(2.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
         "SET_SPINDLE_MODE(0 2500.0)", "STRAIGHT_FEED(3.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "SET_FEED_MODE(0, 0)",
         "SET_FEED_RATE(50.0)", "STRAIGHT_FEED(4.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_FALSE(moves[0].move.feed_per_min);
    EXPECT_DOUBLE_EQ(*moves[1].move.feed_per_min, 200);
    EXPECT_FALSE(moves[2].move.feed_per_min);
    EXPECT_DOUBLE_EQ(*moves[3].move.feed_per_min, 50);
}

TEST(CanonReader, KeepsUnitOfGivenFeed) {
    const auto moves =
        expected_moves({"USE_LENGTH_UNITS(CANON_UNITS_INCHES)", "SET_FEED_RATE(10.0)",
                        "USE_LENGTH_UNITS(CANON_UNITS_MM)", "STRAIGHT_FEED(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_EQ(moves[0].move.to[0], 1);
    EXPECT_EQ(moves[0].feed_unit_mm, 25.4);
}

TEST(CanonReader, NamesLineWithMissingNumbers) {
    std::istringstream text("    1 N..... ON_RESET()\n    2 N..... STRAIGHT_FEED(1.0, 2.0)\n");
    const auto moves = read_canon(text);
    ASSERT_FALSE(moves);
    EXPECT_EQ(moves.error().message,
              "line 2 of the canonical output lacks numbers:     2 N..... STRAIGHT_FEED(1.0, 2.0)");
}

}  // namespace
}  // namespace gsim::conformance::canon_reader_test
