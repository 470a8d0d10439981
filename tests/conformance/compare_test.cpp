#include "tests/conformance/compare.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/conformance/canon_text.h"

namespace gsim::conformance::compare_test {
namespace {

Move rapid(double x, double y, double z) {
    return {.kind = Kind::rapid, .to = {x, y, z}};
}

Move feed_move(double x, double y, double z, double feed, Kind kind = Kind::linear, long line = 1) {
    return {.kind = kind, .to = {x, y, z}, .feed_per_min = feed, .line = line};
}

Move arc(Kind kind, AxisValues to, ArcPart part, double feed) {
    return {.kind = kind, .to = to, .arc = part, .feed_per_min = feed};
}

std::string difference(const Verdict& verdict) {
    return verdict.difference ? verdict.difference->what : "";
}

TEST(Compare, AgreesWithinPrintedDigits) {
    const auto expected =
        expected_moves({"STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0, 0.0, 0.0)", "SET_FEED_RATE(33.3333)",
                        "STRAIGHT_FEED(2.3457, 0.0, 0.0, 0.0, 0.0, 0.0)", "DWELL(0.3333)"});
    std::vector<Move> found{rapid(1, 0, 0),
                            feed_move(2.34567, 0, 0, 100.0 / 3),
                            {.kind = Kind::dwell, .to = {2.34567}, .dwell_s = 1.0 / 3}};
    const Verdict verdict = compare(expected, found);
    EXPECT_EQ(difference(verdict), "");
    EXPECT_EQ(verdict.agreed, 3U);

    found[1].to[0] = 2.34577;
    EXPECT_EQ(difference(compare(expected, found)), "end point: X is 2.345770, 2.345700 is expected");
    found[1] = feed_move(2.34567, 0, 0, 33.33334);
    EXPECT_EQ(difference(compare(expected, found)), "");
    found[1].feed_per_min = 33.34;
    EXPECT_EQ(difference(compare(expected, found)), "feed: 33.34, 33.3333 is expected");
    found[1].feed_per_min = 33.3333;
    found[2].dwell_s = 0.34;
    EXPECT_EQ(difference(compare(expected, found)), "dwell: 0.340000 s, 0.3333 s are expected");
}

TEST(Compare, ReportsFirstDifference) {
    const auto expected = expected_moves({"STRAIGHT_TRAVERSE(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                          "STRAIGHT_TRAVERSE(2.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    const std::vector<Move> found{rapid(1, 0, 0), feed_move(2, 0, 0, 5, Kind::linear, 7)};
    const Verdict verdict = compare(expected, found);
    ASSERT_TRUE(verdict.difference);
    EXPECT_EQ(verdict.agreed, 1U);
    EXPECT_EQ(verdict.difference->what, "kind: linear, rapid is expected");
    EXPECT_EQ(verdict.difference->expected, "canonical line 2: rapid X2.00000 Y0.00000 Z0.00000");
    EXPECT_EQ(verdict.difference->found, "program line 7: linear X2.00000 Y0.00000 Z0.00000, feed 5");
}

TEST(Compare, ReportsMissingMoves) {
    const auto expected = expected_moves({"STRAIGHT_TRAVERSE(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    EXPECT_EQ(difference(compare(expected, {})), "order: gsim has no further move");
    EXPECT_EQ(difference(compare(expected, std::vector{rapid(1, 0, 0), rapid(2, 0, 0)})),
              "order: the reference has no further move");
}

TEST(Compare, IgnoresMovesWithoutLength) {
    const auto expected = expected_moves({"STRAIGHT_TRAVERSE(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                          "STRAIGHT_TRAVERSE(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                          "SET_FEED_RATE(5.0)", "STRAIGHT_FEED(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                          "DWELL(0.0)", "STRAIGHT_TRAVERSE(2.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    EXPECT_EQ(difference(compare(expected, std::vector{rapid(1, 0, 0), rapid(2, 0, 0)})), "");
    // A move too short to be seen in the printed digits.
    EXPECT_EQ(difference(compare(expected, std::vector{rapid(1, 0, 0), feed_move(1.00003, 0, 0, 5),
                                                       feed_move(1.00001, 0, 0, 5), rapid(2, 0, 0)})),
              "");
}

TEST(Compare, DoesNotIgnoreFullCircle) {
    const auto expected = expected_moves({"ARC_FEED(0.0, 0.0, 5.0, 0.0, 1, 0.0, 0.0, 0.0, 0.0)"});
    EXPECT_EQ(difference(compare(expected, {})), "order: gsim has no further move");
    EXPECT_EQ(difference(compare(
                  expected, std::vector{arc(Kind::arc_ccw, {}, {plane_normal(Plane::xy), {5, 0, 0}, 1}, 0)})),
              "");
}

TEST(Compare, ComparesArcSensePlaneCentreAndTurns) {
    const auto expected = expected_moves({"SELECT_PLANE(CANON_PLANE_XZ)", "SET_FEED_RATE(10.0)",
                                          "ARC_FEED(0.0, 10.0, 0.0, 5.0, -2, 1.0, 0.0, 0.0, 0.0)"});
    const Move right = arc(Kind::arc_cw, {10, 1, 0}, {plane_normal(Plane::zx), {5, 99, 0}, 2}, 10);
    const auto judge = [&expected](Move found) { return difference(compare(expected, std::vector{found})); };
    EXPECT_EQ(judge(right), "");  // along its own axis the centre is irrelevant
    Move wrong = right;
    wrong.kind = Kind::arc_ccw;
    EXPECT_EQ(judge(wrong), "kind: arc_ccw, arc_cw is expected");
    wrong = right;
    wrong.arc->normal = plane_normal(Plane::xy);
    EXPECT_EQ(judge(wrong),
              "plane: its normal is 0.000000 0.000000 1.000000, 0.000000 1.000000 0.000000 is expected");
    // The same arc, given about the other normal of its plane.
    wrong.arc->normal = {0, -1, 0};
    EXPECT_EQ(judge(wrong), "sense: the arc goes the other way round");
    wrong.kind = Kind::arc_ccw;
    EXPECT_EQ(judge(wrong), "");
    wrong = right;
    wrong.arc->center_mm[0] = 5.001;
    EXPECT_EQ(judge(wrong), "arc centre: X is 5.001000, 5.000000 is expected");
    wrong = right;
    wrong.arc->turns = 1;
    EXPECT_EQ(judge(wrong), "turns: 1, 2 expected");
}

TEST(Compare, ConvertsInchFeedsExceptOfRotaryMoves) {
    const auto expected = expected_moves({"USE_LENGTH_UNITS(CANON_UNITS_INCHES)", "SET_FEED_RATE(10.0)",
                                          "STRAIGHT_FEED(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                          "STRAIGHT_FEED(1.0, 0.0, 0.0, 90.0, 0.0, 0.0)"});
    Move turn{.kind = Kind::linear, .to = {25.4, 0, 0, 90}, .feed_per_min = 10};
    EXPECT_EQ(difference(compare(expected, std::vector{feed_move(25.4, 0, 0, 254), turn})), "");
    turn.feed_per_min = 254;
    EXPECT_EQ(difference(compare(expected, std::vector{feed_move(25.4, 0, 0, 254), turn})),
              "feed: 254, 10 is expected");
}

TEST(Compare, MatchesSplineWithMovesOfOneLine) {
    const auto expected = expected_moves({"SET_FEED_RATE(10.0)", "NURBS_FEED(4, ...)", "NURBS_FEED(4, ...)",
                                          "STRAIGHT_FEED(3.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    const auto spline = [](double x, long line) { return feed_move(x, 0, 0, 10, Kind::spline, line); };
    const Move last = feed_move(3, 0, 0, 10);
    EXPECT_EQ(difference(compare(expected, std::vector{spline(1, 1), spline(2, 1), spline(2.5, 2), last})),
              "");
    EXPECT_EQ(difference(compare(expected, std::vector{spline(1, 1), spline(2.5, 1), last})), "");  // a loop
    const auto arc_part = [](double x, long line) { return feed_move(x, 0, 0, 10, Kind::arc_cw, line); };
    EXPECT_EQ(
        difference(compare(expected, std::vector{arc_part(1, 1), spline(2, 1), arc_part(2.5, 2), last})), "");
    EXPECT_EQ(difference(compare(expected, std::vector{spline(1, 1), last})),
              "splines: the moves do not go with the splines of the reference");
    EXPECT_EQ(difference(compare(expected, std::vector{spline(1, 1), spline(2, 2), spline(2.5, 3), last})),
              "kind: spline, linear is expected");
    // The reference does not print the end of a spline: its next move has no length if gsim is there.
    EXPECT_EQ(difference(compare(expected, std::vector{spline(1, 1), spline(3, 2)})), "");
}

TEST(Compare, IgnoresMovesWithoutLengthBetweenSplines) {
    const auto expected =
        expected_moves({"SET_FEED_RATE(10.0)", "NURBS_FEED(4, ...)",
                        "STRAIGHT_TRAVERSE(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)", "NURBS_FEED(4, ...)"});
    const std::vector<Move> found{feed_move(0.5, 0, 0, 10, Kind::spline, 1),
                                  feed_move(1, 0, 0, 10, Kind::spline, 1),
                                  feed_move(2, 0, 0, 10, Kind::spline, 3)};
    EXPECT_EQ(difference(compare(expected, found)), "");
}

TEST(Compare, AllowsReferenceToStopBeforeProbeTarget) {
    const auto expected =
        expected_moves({"SET_FEED_RATE(10.0)", "STRAIGHT_PROBE(10.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                        "STRAIGHT_TRAVERSE(9.7460, 5.0, 0.0, 0.0, 0.0, 0.0)",
                        "STRAIGHT_TRAVERSE(8.7460, 5.0, 0.0, 0.0, 0.0, 0.0)",
                        "STRAIGHT_TRAVERSE(20.0, 5.0, 0.0, 0.0, 0.0, 0.0)",
                        "STRAIGHT_TRAVERSE(19.7460, 5.0, 0.0, 0.0, 0.0, 0.0)"});
    std::vector<Move> found{feed_move(10, 0, 0, 10, Kind::probe), rapid(10, 5, 0), rapid(9, 5, 0),
                            rapid(20, 5, 0), rapid(19.746, 5, 0)};
    EXPECT_EQ(difference(compare(expected, found)), "");
    found[4] = rapid(21, 5, 0);  // once both agree, they stay together
    EXPECT_EQ(difference(compare(expected, found)), "end point: X is 21.000000, 19.746000 is expected");

    // Steps from the end of a probe add up.
    const auto steps = expected_moves({"SET_FEED_RATE(10.0)", "STRAIGHT_PROBE(10.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                       "STRAIGHT_PROBE(19.7460, 0.0, 0.0, 0.0, 0.0, 0.0)",
                                       "STRAIGHT_TRAVERSE(20.4920, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    EXPECT_EQ(difference(compare(steps, std::vector{feed_move(10, 0, 0, 10, Kind::probe),
                                                    feed_move(20, 0, 0, 10, Kind::probe), rapid(21, 0, 0)})),
              "");

    const auto touching =
        expected_moves({"SET_FEED_RATE(10.0)", "STRAIGHT_PROBE(10.0, 0.0, 0.0, 0.0, 0.0, 0.0)",
                        "STRAIGHT_FEED(10.0, 0.0, 0.0, 0.0, 0.0, 0.0)"});
    EXPECT_EQ(difference(compare(touching, std::vector{feed_move(10, 0, 0, 10, Kind::probe)})), "");
}

}  // namespace
}  // namespace gsim::conformance::compare_test
