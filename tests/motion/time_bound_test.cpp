#include "motion/planner/time_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/time_bound_paths.h"

namespace gsim::motion::time_bound_test {
namespace {

using namespace bound_paths;

struct Line {
    double length;
    PathCaps caps;
};

std::vector<Line> random_lines(Random& random, int count) {
    std::vector<Line> lines;
    for (int i = 0; i < count; ++i) lines.push_back({random.around(5), random.caps(0.5)});
    return lines;
}

double bound_of(const std::vector<Line>& lines, TimeBoundGrid grid = {}) {
    TimeBound bound({}, grid);
    for (const Line& line : lines) bound.add_line(line.length, line.caps);
    return bound.bound_s();
}

TEST(TimeBound, LineTakesTrapezoidTime) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const PathCaps caps = random.caps(4);
        const double length = random.around(10, 5);
        const double expected_s = trapezoid_s(length, caps);
        ASSERT_NEAR(bound_of({{length, caps}}), expected_s, 1e-12 * expected_s) << length;
    }
}

TEST(TimeBound, SplitLineTakesTimeOfFullLine) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const PathCaps caps = random.caps(2);
        std::vector<Line> parts;
        double length = 0;
        for (int part = random.count(2, 300); part > 0; --part) {
            parts.push_back({random.around(1, 3), caps});
            length += parts.back().length;
        }
        ASSERT_NEAR(bound_of(parts), trapezoid_s(length, caps), kRounding * trapezoid_s(length, caps));
    }
}

TEST(TimeBound, LongPathThroughWindowTakesTimeOfFullLine) {
    const PathCaps caps{100, 500, 800};
    const std::vector<Line> parts(300'000, Line{0.01, caps});
    EXPECT_NEAR(bound_of(parts), trapezoid_s(3000, caps), 1e-9);
}

// Returns the min time over one line between two speeds, with the peak found by bisection; infinite if no
// time exists.
double between_s(const Line& line, double v0, double v1) {
    const auto [limit, up, down] = line.caps;
    const auto ramps = [&, up = up, down = down](double v) {
        return (v * v - v0 * v0) / (2 * up) + (v * v - v1 * v1) / (2 * down);
    };
    double low = std::max(v0, v1);
    double high = limit;
    if (low > limit || ramps(low) > line.length * (1 + 1e-12)) return kNoBound;
    for (int i = 0; i < 30; ++i) (ramps((low + high) / 2) <= line.length ? low : high) = (low + high) / 2;
    const double cruise = std::max(0.0, line.length - ramps(low));
    return (low - v0) / up + (low - v1) / down + cruise / low;
}

// Dynamic programming over a grid of speeds at the corners: a feasible law, and nearly the best.
double programmed_s(const std::vector<Line>& lines, int steps) {
    std::vector<double> speeds{0};
    std::vector<double> best{0};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool last = i + 1 == lines.size();
        const double top = last ? 0 : std::min(lines[i].caps.max_speed, lines[i + 1].caps.max_speed);
        std::vector<double> next_speeds;
        std::vector<double> next_best;
        for (int step = 0; step <= (last ? 0 : steps); ++step) {
            next_speeds.push_back(top * step / steps);
            double min = kNoBound;
            for (std::size_t k = 0; k < speeds.size(); ++k) {
                min = std::min(min, best[k] + between_s(lines[i], speeds[k], next_speeds.back()));
            }
            next_best.push_back(min);
        }
        speeds = std::move(next_speeds);
        best = std::move(next_best);
    }
    return best[0];
}

TEST(TimeBound, PolylinesAgreeWithDynamicProgramming) {
    Random random(3);
    for (int i = 0; i < 25; ++i) {
        const std::vector<Line> lines = random_lines(random, random.count(2, 5));
        const double feasible_s = programmed_s(lines, 100);
        const double bound_s = bound_of(lines);
        ASSERT_LE(bound_s, feasible_s * (1 + 1e-7)) << "case " << i;
        ASSERT_GE(bound_s, feasible_s * 0.98) << "case " << i;
    }
}

TEST(TimeBound, JointsLimitLineByTheirShares) {
    TimeBound bound({joints({100, 30, kNoBound}), joints({1000, 500, 800})});
    bound.add_line(200, joints({0.6, -0.8, 0}), {70, 1200, 400});
    const PathCaps expected{30 / 0.8, 500 / 0.8, 400};
    EXPECT_DOUBLE_EQ(bound.bound_s(), trapezoid_s(200, expected));
}

TEST(TimeBound, StopSplitsPath) {
    Random random(4);
    const std::vector<Line> first = random_lines(random, 20);
    const std::vector<Line> second = random_lines(random, 20);
    TimeBound bound({});
    for (const Line& line : first) bound.add_line(line.length, line.caps);
    bound.stop();
    bound.stop();
    for (const Line& line : second) bound.add_line(line.length, line.caps);
    EXPECT_DOUBLE_EQ(bound.bound_s(), bound_of(first) + bound_of(second));
    bound.begin();
    EXPECT_EQ(bound.bound_s(), 0);
    for (const Line& line : first) bound.add_line(line.length, line.caps);
    EXPECT_DOUBLE_EQ(bound.bound_s(), bound_of(first));
}

TEST(TimeBound, ChangeOfMeasureFreesSpeed) {
    // 50 mm up to 100 mm/s in 1 s, then 0.5 rad down from 1 rad/s in 1 s.
    TimeBound bound({});
    bound.add_line(50, {1000, 100, 100});
    bound.change_measure();
    bound.add_line(0.5, {10, 1, 1});
    EXPECT_DOUBLE_EQ(bound.bound_s(), 2);
}

TEST(TimeBound, NoRandomLawWithStopsBeatsBound) {
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        double law_s = 0;
        double since_stop = 0;
        PathCaps min;
        TimeBound bound({});
        for (const Line& line : random_lines(random, 30)) {
            bound.add_line(line.length, line.caps);
            since_stop += line.length;
            min.max_speed = std::min(min.max_speed, line.caps.max_speed);
            min.max_acceleration = std::min(min.max_acceleration, line.caps.max_acceleration);
            min.max_deceleration = std::min(min.max_deceleration, line.caps.max_deceleration);
            if (random.count(0, 3) > 0) continue;
            law_s += trapezoid_s(since_stop, min);
            since_stop = 0;
            min = {};
            if (random.count(0, 1) > 0) bound.stop();
        }
        if (since_stop > 0) law_s += trapezoid_s(since_stop, min);
        ASSERT_LE(bound.bound_s(), law_s * (1 + kRounding)) << "case " << i;
    }
}

// Lines and curves by turns, under one set of limits.
double mixed_bound_s(unsigned seed, const JointLimits& limits, const PathCaps& caps, TimeBoundGrid grid) {
    Random random(seed);
    TimeBound bound(limits, grid);
    for (int i = 0; i < 20; ++i) {
        bound.add_line(random.around(1), joints({random.between(-1, 1), random.between(-1, 1)}), caps);
        const Shape shape = circle(random.around(1), random.between(0.05, 0.5), 1);
        bound.add_curve(shape.curve(), caps);
        if (random.count(0, 9) == 0) bound.stop();
    }
    return bound.bound_s();
}

TEST(TimeBound, ShorterWindowNeverRaisesBound) {
    const JointLimits limits{joints({20, 30}), joints({40, 25})};
    for (unsigned seed = 0; seed < 30; ++seed) {
        const double total_s = mixed_bound_s(seed, limits, {25, 60, 50}, {.cell_rad = 0.05});
        double shorter_s = 0;
        for (const std::size_t window : {0, 2, 8, 64, 256}) {
            shorter_s = mixed_bound_s(seed, limits, {25, 60, 50}, {.cell_rad = 0.05, .window = window});
            ASSERT_LE(shorter_s, total_s * (1 + kRounding)) << "window " << window;
        }
        ASSERT_NEAR(shorter_s, total_s, kRounding * total_s) << "braking takes less than 128 cells";
    }
}

TEST(TimeBound, NeverRisesWithHigherLimits) {
    Random random(9);
    for (unsigned seed = 0; seed < 60; ++seed) {
        JointLimits limits{joints({random.around(20), random.around(20)}),
                           joints({random.around(40), random.around(40)})};
        PathCaps caps = random.caps();
        double before_s = mixed_bound_s(seed, limits, caps, {.cell_rad = 0.1});
        for (double* limit :
             {&limits.max_speed[0], &limits.max_speed[1], &limits.max_acceleration[0],
              &limits.max_acceleration[1], &caps.max_speed, &caps.max_acceleration, &caps.max_deceleration}) {
            *limit *= random.between(1, 3);
            const double after_s = mixed_bound_s(seed, limits, caps, {.cell_rad = 0.1});
            ASSERT_LE(after_s, before_s * (1 + kRounding)) << "seed " << seed;
            before_s = after_s;
        }
    }
}

TEST(TimeBound, IgnoresInfiniteLimits) {
    EXPECT_DOUBLE_EQ(bound_of({{100, {50, kNoBound, kNoBound}}}), 2);
    EXPECT_DOUBLE_EQ(bound_of({{100, {kNoBound, 100, 100}}}), 2);
    EXPECT_NEAR(bound_of({{100, {}}}), 0, 1e-40);
}

TEST(TimeBound, IgnoresInvalidLengths) {
    const PathCaps caps{100, 100, 100};
    for (const double none : {0.0, -1.0, kNaN, -kNoBound}) {
        EXPECT_DOUBLE_EQ(bound_of({{300, caps}, {none, {1e-9, 1e-9, 1e-9}}}), 4) << none;
    }
}

TEST(TimeBound, OddValuesGiveNonNegativeBound) {
    const double odd[] = {0, -1, 1e-320, 1e-200, 1, 1e200, 1e308, kNoBound, -kNoBound, kNaN};
    Random random(10);
    const auto any = [&] { return odd[random.count(0, std::size(odd) - 1)]; };
    for (int i = 0; i < 3000; ++i) {
        TimeBound bound({joints({any(), any()}), joints({any(), any(), any()})}, {.cell_rad = 0.2});
        for (int part_index = 0; part_index < 4; ++part_index) {
            bound.add_line(any(), joints({any(), any(), any()}), {any(), any(), any()});
            const auto at = [&](double) {
                return CurvePoint{joints({any(), any()}), joints({any(), any()}), joints({any(), any()})};
            };
            bound.add_curve({any(), random.between(-1, 5), joints({any(), any()}), at},
                            {any(), any(), any()});
        }
        ASSERT_GE(bound.bound_s(), 0) << "case " << i;
    }
    TimeBound bound({joints({1}), joints({1})});
    bound.add_curve({1, kNaN, {}, [](double) { return CurvePoint{}; }}, {});
    bound.add_curve({1, 1, {}, {}}, {});
    EXPECT_NEAR(bound.bound_s(), 0, 1e-40);
}

}  // namespace
}  // namespace gsim::motion::time_bound_test
