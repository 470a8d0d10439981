// G5, G5.1, G5.2: pairs of arcs with their ends on the curve, four pairs for each control point, as in
// LinuxCNC.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::splines_test {
namespace {

constexpr double kNear_mm = 2e-3;  // for curves of a few mm: the joint of a pair's arcs is off the curve

using Point = std::array<double, 2>;

// The ends of the pairs, from the start on.
std::vector<Point> ends_of(const Outcome& run) {
    std::vector<Point> ends{{0, 0}};
    for (std::size_t i = 1; i < run.moves.size(); i += 2) ends.push_back({run.to(i, 'X'), run.to(i, 'Y')});
    return ends;
}

// Returns points of the driven path.
std::vector<Point> driven(const Outcome& run) {
    std::vector<Point> points;
    for (const motion::Segment& segment : run.segments) {
        for (int i = 0; i <= 8; ++i) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * i / 8);
            points.push_back({at[0], at[1]});
        }
    }
    return points;
}

// At the end of each part the next one continues in the same direction.
void expect_tangent_joints(const Outcome& run) {
    for (std::size_t i = 1; i < run.segments.size(); ++i) {
        const rrs::JointPos before = run.segments[i - 1].at(0.999 * run.segments[i - 1].duration_s).velocity;
        const rrs::JointPos after = run.segments[i].at(0.001 * run.segments[i].duration_s).velocity;
        EXPECT_GT(before.normalized().dot(after.normalized()), 0.9999) << i;
    }
}

TEST(Splines, QuadraticSplineIsParabola) {
    // Control points (0,0), (1,1), (2,0): y = x - x^2 / 2.
    const Outcome r = run_ngc("G21 F100\nG5.1 X2 Y0 I1 J1\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.size(), 2U * 4 * 3);
    const std::vector<Point> ends = ends_of(r);
    EXPECT_NEAR(ends.back()[0], 2, 1e-12);
    for (const Point& end : ends) EXPECT_NEAR(end[1], end[0] - end[0] * end[0] / 2, 1e-12);
    for (const Point& at : driven(r)) EXPECT_NEAR(at[1], at[0] - at[0] * at[0] / 2, kNear_mm);
    expect_tangent_joints(r);
}

TEST(Splines, CubicSplineContinuesInPreviousDirection) {
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

TEST(Splines, WeightsMakeExactCircle) {
    const Outcome r =
        run_ngc(fmt::format("G21 F100\nG5.2 P1 L3\nX10 Y0 P{}\nX10 Y10 P1\nG5.3\nM2\n", std::sqrt(0.5)));
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(ends_of(r).back()[1], 10, 1e-12);
    for (const Point& at : driven(r)) EXPECT_NEAR(std::hypot(at[0], at[1] - 10), 10, 1e-5);
}

TEST(Splines, SpansMeetAtWeightedMidpointOfControlPoints) {
    const Outcome r = run_ngc("G21 F100\nG5.2 X0 Y10 P2 L3\nX10 Y10 P1\nX10 Y0 P1\nG5.3\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const Point midpoint{(2 * 0 + 1 * 10) / 3.0, 10};
    const std::vector<Point> ends = ends_of(r);
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](const Point& end) {
        return std::hypot(end[0] - midpoint[0], end[1] - midpoint[1]) < 1e-9;
    }));
    EXPECT_NEAR(ends.back()[0], 10, 1e-12);
    EXPECT_NEAR(ends.back()[1], 0, 1e-12);
}

TEST(Splines, RotateWithWorkCoordinateSystem) {
    const Outcome r = run_ngc("G21 F100 G10 L2 P1 R90\nG5.1 X2 Y0 I1 J1\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    for (const Point& end : ends_of(r)) EXPECT_NEAR(-end[0], end[1] - end[1] * end[1] / 2, 1e-9);
}

// Control points that coincide, or lie on a line: no part is left out, and no position is lost.
TEST(Splines, DegenerateSplinesReachTheirEnd) {
    for (const char* spline :
         {"G5 X3 Y0 I1 J0 P-1 Q0", "G5 X3 Y1 I0 J0 P0 Q0", "G5.1 X4 Y0 I2 J0", "G5 X1 Y0 I4 J0 P4 Q0",
          "G5 X0.001 Y0 I5 J5 P-5 Q5", "G5.2 X1 Y1 P1 L2\nX2 Y0 P1\nX2 Y0 P1\nG5.3"}) {
        const Outcome r = run_ngc(fmt::format("G21 F100\n{}\nM2\n", spline));
        ASSERT_TRUE(r.completed()) << spline << ": " << r.message();
        const rrs::JointPos end = r.segments.back().end_position();
        EXPECT_NEAR(end[0], r.to(r.moves.size() - 1, 'X'), 1e-9) << spline;
        EXPECT_GE(r.report.distances.feed_mm, end.norm() - 1e-9) << spline;
        for (const Point& at : driven(r)) EXPECT_LT(std::hypot(at[0], at[1]), 12) << spline;
    }
}

TEST(Splines, InverseTimeAppliesToFullSpline) {
    const Outcome r = run_ngc("G21 G93\nG5.1 X20 Y0 I10 J10 F2\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.report.cycle_time_s, 30, 1e-6);
}

TEST(Splines, PreviousMotionStaysModal) {
    for (const char* spline : {"G5 X2 Y0 I1 J1 P-1 Q1", "G5.1 X2 Y0 I1 J1"}) {
        const Outcome r = run_ngc(fmt::format("G21 F100\nG0 X0\n{}\nX5\nM2\n", spline));
        ASSERT_TRUE(r.completed()) << r.message();
        EXPECT_EQ(r.moves.back().info.kind, simulation::MoveKind::rapid) << spline;
        EXPECT_NEAR(r.to(r.moves.size() - 1, 'X'), 5, 1e-12) << spline;
    }
}

TEST(Splines, RejectsInvalidWords) {
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
