// Bound along curves with one limit for the joints' tangential and centripetal acceleration.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/planner/time_bound.h"
#include "tests/motion/time_bound_paths.h"

namespace gsim::motion::time_bound_curve_test {
namespace {

using namespace bound_paths;

// Numerical TOPP on a fine grid by another method than the bound's: constant acceleration from node to node,
// the limits kept at both nodes; highest controllable speeds backward by bisection, then forward.
class Reference {
  public:
    Reference(const Shape& shape, int steps) : shape_(shape), h_(shape.length / steps) {
        for (int i = 0; i <= steps; ++i) points_.push_back(shape.at(i * h_));
        speed2_.assign(static_cast<std::size_t>(steps) + 1, 0);
        for (std::size_t i = points_.size() - 1; i-- > 0;) speed2_[i] = controllable(i, speed2_[i + 1]);
        speed2_[0] = 0;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            speed2_[i + 1] = std::min(speed2_[i + 1], speed2_[i] + 2 * h_ * range(i, speed2_[i]).second);
        }
    }

    double duration_s() const {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            sum += 2 * h_ / (std::sqrt(speed2_[i]) + std::sqrt(speed2_[i + 1]));
        }
        return sum;
    }

    // The same law, slower by as much as it passes limits between the nodes.
    double feasible_s() const {
        double worst = 0;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            const double a = (speed2_[i + 1] - speed2_[i]) / (2 * h_);
            for (const double part : {0.0, 0.5, 1.0}) {
                const double s = (static_cast<double>(i) + part) * h_;
                worst = std::max(worst, shape_.excess(s, speed2_[i] + 2 * a * h_ * part, a));
            }
        }
        return duration_s() * std::sqrt(worst) * (1 + 1e-5);
    }

  private:
    std::pair<double, double> range(std::size_t i, double speed2) const {
        double low = std::max(-1e9, -shape_.caps.max_deceleration);
        double high = std::min(1e9, shape_.caps.max_acceleration);
        if (speed2 > std::pow(shape_.caps.max_speed, 2)) high = -kNoBound;
        for (Eigen::Index j = 0; j < points_[i].q.size(); ++j) {
            for (const double ahead : {0.0, 2 * h_}) {  // there the square of the speed has grown by ahead a
                const CurvePoint& point = points_[ahead > 0 ? i + 1 : i];
                const double lever = point.q1[j] + ahead * point.q2[j];
                const double drag = point.q2[j] * speed2;
                const double max = shape_.limits.max_acceleration[j];
                low = std::max(low, std::min((max - drag) / lever, (-max - drag) / lever));
                high = std::min(high, std::max((max - drag) / lever, (-max - drag) / lever));
            }
            if (std::abs(points_[i].q1[j]) * std::sqrt(speed2) > shape_.limits.max_speed[j]) high = -kNoBound;
        }
        return {low, high};
    }

    double controllable(std::size_t i, double next) const {
        double low = 0;
        double high = 1e4;
        for (int k = 0; k < 45; ++k) {
            const double speed2 = (low + high) / 2;
            const auto [min, max] = range(i, speed2);
            const bool can = min <= max && speed2 + 2 * h_ * min <= next && speed2 + 2 * h_ * max >= 0;
            (can ? low : high) = speed2;
        }
        return low;
    }

    const Shape& shape_;
    double h_;
    std::vector<CurvePoint> points_;
    std::vector<double> speed2_;
};

TEST(TimeBoundCurve, ArcWithPathLimitsMatchesClosedForm) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const double radius = random.around(10);
        const double centripetal = random.around(1000);
        const double tangential = random.around(1000);
        const PathCaps caps{std::sqrt(centripetal * radius), tangential, tangential};
        const Shape shape = circle(radius, random.between(0.01, 3), kNoBound);
        TimeBound bound(shape.limits);
        bound.add_curve(shape.curve(), caps);
        const double expected_s = trapezoid_s(shape.length, caps);
        ASSERT_NEAR(bound.bound_s(), expected_s, kRounding * expected_s);
    }
}

// However the path is measured, one joint that never reverses has its own trapezoid.
TEST(TimeBoundCurve, SingleJointTakesOwnTrapezoid) {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const double frequency = random.between(0.5, 2);
        const double speed = random.around(10);
        const double acceleration = random.around(10);
        const Shape shape{
            .length = random.between(1, 10),
            .joints = {{{random.between(0, 0.99) / frequency, frequency, random.between(0, 6)}}},
            .joint_slope = {1},
            .limits = {joints({speed}), joints({acceleration})},
            .caps = {}};
        const double distance = shape.at(shape.length).q[0] - shape.at(0).q[0];
        const double expected_s = trapezoid_s(distance, {speed, acceleration, acceleration});
        ASSERT_NEAR(shape.bound_s({.cell_rad = 0.005}), expected_s, 1e-9 * expected_s) << "case " << i;
        for (const double cell_rad : {0.3, 1.0, 2.0, 4.0}) {
            ASSERT_LE(shape.bound_s({.cell_rad = cell_rad}), expected_s * (1 + kRounding)) << "case " << i;
        }
    }
}

// The path speeds up to 10 at 1 and slows down at 10. During the slowdown a joint with hardly any
// acceleration moves at its own constant speed of 1. That is only possible because the path slows down;
// mirrored, speeds up.
TEST(TimeBoundCurve, JointLimitsMayRequirePathSpeedChange) {
    for (const bool mirrored : {false, true}) {
        const PathCaps caps{kNoBound, mirrored ? 10.0 : 1.0, mirrored ? 1.0 : 10.0};
        const auto at = [&](double s) {
            const double speed = std::sqrt(mirrored ? 40 + 20 * s : 100 - 20 * s);
            const double q2 = 10 / (speed * speed * speed);
            return CurvePoint{joints({mirrored ? speed / 10 : -speed / 10}), joints({1 / speed}),
                              joints({mirrored ? -q2 : q2})};
        };
        TimeBound bound({joints({2}), joints({1e-3})});
        bound.add_line(mirrored ? 2 : 50, caps);
        bound.add_curve({.length = 3, .turn_rad = 1, .max_q2 = joints({0.04}), .at = at}, caps);
        bound.add_line(mirrored ? 50 : 2, caps);
        EXPECT_NEAR(bound.bound_s(), 11, 1e-9);
    }
}

TEST(TimeBoundCurve, CircleAgreesWithNumericalOptimum) {
    for (const double turns : {0.05, 0.25, 0.7, 1.0, 2.5}) {
        const Shape shape = circle(2, turns, 20);
        const double feasible_s = Reference(shape, 3000).feasible_s();
        EXPECT_LE(shape.bound_s(), feasible_s) << turns;
        EXPECT_GE(shape.bound_s(), feasible_s * 0.999) << turns;
    }
}

TEST(TimeBoundCurve, RandomCurvesAgreeWithNumericalOptimum) {
    Random random(6);
    for (int i = 0; i < 40; ++i) {
        const Shape shape = random_shape(random);
        const double feasible_s = Reference(shape, 1500).feasible_s();
        ASSERT_LE(shape.bound_s(), feasible_s) << "case " << i;
        ASSERT_GE(shape.bound_s(), feasible_s * 0.995) << "case " << i;
        for (const double cell_rad : {0.1, 0.5, 2.0, 100.0}) {
            ASSERT_LE(shape.bound_s({.cell_rad = cell_rad}), feasible_s) << "case " << i << ' ' << cell_rad;
        }
    }
}

// The square of the speed is s (length - s) times something positive; slowed down until every limit is kept.
// With s = length sin^2(x) the time is an integral of something smooth.
double smooth_law_s(const Shape& shape, Random& random) {
    const double amplitude = random.between(-0.9, 0.9);
    const double frequency = random.between(0, 6) / shape.length;
    constexpr int kSteps = 2000;
    double worst = 0;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = shape.length * std::pow(std::sin((i + 0.5) / kSteps * std::numbers::pi / 2), 2);
        const double factor = 1 + amplitude * std::sin(frequency * s);
        const double slope = amplitude * frequency * std::cos(frequency * s);
        const double travel = s * (shape.length - s);
        const double a = ((shape.length - 2 * s) * factor + travel * slope) / 2;
        worst = std::max(worst, shape.excess(s, travel * factor, a));
        sum += std::numbers::pi / kSteps / std::sqrt(factor);
    }
    return sum * std::sqrt(worst) * (1 + 1e-4);
}

TEST(TimeBoundCurve, NoRandomLawOnCurveBeatsBound) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const Shape shape = random_shape(random);
        const double bound_s = shape.bound_s({.cell_rad = random.around(0.1)});
        ASSERT_GT(bound_s, 0);
        ASSERT_LE(bound_s, smooth_law_s(shape, random)) << "case " << i;
    }
}

}  // namespace
}  // namespace gsim::motion::time_bound_curve_test
