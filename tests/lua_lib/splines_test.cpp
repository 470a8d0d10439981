// G5, G5.1, G5.2: the chords end on the curve and stay within the stated tolerance of it.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::splines_test {
namespace {

constexpr double kTolerance_mm = 0.001;  // TOLERANCE_MM of splines.lua

using Point = std::array<double, 2>;

std::vector<Point> ends_of(const Outcome& run) {
    std::vector<Point> ends{{0, 0}};
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        EXPECT_EQ(run.moves[i].info.kind, simulation::MoveKind::spline);
        ends.push_back({run.to(i, 'X'), run.to(i, 'Y')});
    }
    return ends;
}

Point middle(const Point& a, const Point& b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

TEST(Splines, AQuadraticOneIsAParabola) {
    // Control points (0,0), (1,1), (2,0): y = x - x^2 / 2.
    const Outcome r = run_ngc("G21 F100\nG5.1 X2 Y0 I1 J1\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const std::vector<Point> ends = ends_of(r);
    EXPECT_NEAR(ends.back()[0], 2, 1e-12);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        EXPECT_NEAR(ends[i][1], ends[i][0] - ends[i][0] * ends[i][0] / 2, 1e-12);
        const Point m = middle(ends[i - 1], ends[i]);
        EXPECT_NEAR(m[1], m[0] - m[0] * m[0] / 2, kTolerance_mm);
    }
}

TEST(Splines, ACubicOneGoesOnWhereTheLastOneLed) {
    // x runs evenly (control points 0, 1, 2, 3), so y is a cubic of x / 3; the second curve has I J of the
    // first P Q.
    const Outcome r = run_ngc("G21 F100\nG5 X3 Y0 I1 J2 P-1 Q2\nG5 X6 Y0 P-1 Q-2\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const std::vector<Point> ends = ends_of(r);
    for (const Point& end : ends) {
        const double t = end[0] <= 3 ? end[0] / 3 : end[0] / 3 - 1;
        const double sign = end[0] <= 3 ? 1 : -1;
        EXPECT_NEAR(end[1], sign * 3 * 2 * t * (1 - t), 1e-9) << end[0];
    }
}

TEST(Splines, WeightsMakeAnExactCircle) {
    const Outcome r =
        run_ngc(fmt::format("G21 F100\nG5.2 P1 L3\nX10 Y0 P{}\nX10 Y10 P1\nG5.3\nM2\n", std::sqrt(0.5)));
    ASSERT_TRUE(r.completed()) << r.message();
    const std::vector<Point> ends = ends_of(r);
    EXPECT_NEAR(ends.back()[1], 10, 1e-12);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        EXPECT_NEAR(std::hypot(ends[i][0], ends[i][1] - 10), 10, 1e-9);
        const Point m = middle(ends[i - 1], ends[i]);
        EXPECT_NEAR(std::hypot(m[0], m[1] - 10), 10, kTolerance_mm);
    }
}

TEST(Splines, SpansMeetAtTheWeightedMiddleOfTheirControlPoints) {
    const Outcome r = run_ngc("G21 F100\nG5.2 X0 Y10 P2 L3\nX10 Y10 P1\nX10 Y0 P1\nG5.3\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const Point meeting{(2 * 0 + 1 * 10) / 3.0, 10};
    const std::vector<Point> ends = ends_of(r);
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](const Point& end) {
        return std::hypot(end[0] - meeting[0], end[1] - meeting[1]) < 1e-9;
    }));
    EXPECT_NEAR(ends.back()[0], 10, 1e-12);
    EXPECT_NEAR(ends.back()[1], 0, 1e-12);
}

TEST(Splines, AreTurnedWithTheSystem) {
    const Outcome r = run_ngc("G21 F100 G10 L2 P1 R90\nG5.1 X2 Y0 I1 J1\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    for (const Point& end : ends_of(r)) EXPECT_NEAR(-end[0], end[1] - end[1] * end[1] / 2, 1e-9);
}

TEST(Splines, TakeTheTimeOfTheirBlockTogether) {
    const Outcome r = run_ngc("G21 G93\nG5.1 X20 Y0 I10 J10 F2\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.report.cycle_time_s, 30, 1e-6);
}

TEST(Splines, TheMotionBeforeThemStaysModal) {
    for (const char* spline : {"G5 X2 Y0 I1 J1 P-1 Q1", "G5.1 X2 Y0 I1 J1"}) {
        const Outcome r = run_ngc(fmt::format("G21 F100\nG0 X0\n{}\nX5\nM2\n", spline));
        ASSERT_TRUE(r.completed()) << r.message();
        EXPECT_EQ(r.moves.back().info.kind, simulation::MoveKind::rapid) << spline;
        EXPECT_NEAR(r.to(r.moves.size() - 1, 'X'), 5, 1e-12) << spline;
    }
}

TEST(Splines, WrongWords) {
    expect_alarm(run_ngc("G21 F100\nG5 X1 Y1 I1 P1 Q1\nM2\n"), 2, {"I and J"});
    expect_alarm(run_ngc("G21 F100\nG5 X1 Y1 I1 J1 P1\nM2\n"), 2, {"P and Q"});
    expect_alarm(run_ngc("G21 F100\nG5.1 X1 Y1 I1\nM2\n"), 2, {"I and J"});
    expect_alarm(run_ngc("G21 F100 G18\nG5.1 X1 Y1 I1 J1\nM2\n"), 2, {"XY plane"});
    expect_alarm(run_ngc("G21 F100\nG5.3\nM2\n"), 2, {"G5.2"});
    expect_alarm(run_ngc("G21 F100\nG5.2 X1 Y1 P1 L4\nX2 Y2 P1\nG5.3\nM2\n"), 4, {"order 4", "3"});
    expect_alarm(run_ngc("G21 F100\nG5.2 X1 Y1 P1\nX2 Y2\nM2\n"), 3, {"P", "weight"});
    expect_alarm(run_ngc("G21 F100\nG5.1 X1 Y1 I1 J1\nX2\nM2\n"), 3, {"need a motion"});
    expect_alarm(run_ngc("G21\nG5.1 X1 Y1 I1 J1\nM2\n"), 2, {"feed"});
}

}  // namespace
}  // namespace gsim::script::splines_test
