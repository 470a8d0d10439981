#include "cam/drawing/nurbs.h"

#include <random>

#include <gtest/gtest.h>

namespace gsim::drawing::nurbs_test {

namespace {

using geometry::Point;

TEST(Nurbs, BezierMatchesPolynomial) {
    const Point a{0, 1}, b{3, 5}, c{-2, 8}, d{4, 4};
    const Nurbs curve = bezier(a, b, c, d);
    for (double t = 0; t <= 1; t += 0.125) {
        const double s = 1 - t;
        const Point expected = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
        EXPECT_NEAR(distance(curve_point(curve, 3, t).position, expected), 0, 1e-12);
    }
}

// The direction against differences, for curves of any degree with weights and uneven knots.
TEST(Nurbs, DirectionMatchesDifferenceQuotient) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> value(0.1, 1);
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        Nurbs curve;
        curve.degree = degree;
        double knot = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            curve.points.push_back({value(random), value(random)});
            curve.weights.push_back(value(random));
        }
        for (std::size_t i = 0; i < 8 + degree + 1; ++i) curve.knots.push_back(knot += value(random));
        ASSERT_FALSE(find_curve_error(curve));
        for (std::size_t span = degree; span < 8; ++span) {
            const double middle = (curve.knots[span] + curve.knots[span + 1]) / 2;
            const Point step = curve_point(curve, span, middle + 1e-6).position -
                               curve_point(curve, span, middle - 1e-6).position;
            EXPECT_NEAR(distance(unit(step), unit(curve_point(curve, span, middle).direction)), 0, 1e-6);
            const Point end = curve_point(curve, span, curve.knots[span + 1]).position;
            if (span + 1 < 8) {
                EXPECT_NEAR(distance(end, curve_point(curve, span + 1, curve.knots[span + 1]).position), 0,
                            1e-12);
            }
        }
    }
}

}  // namespace

}  // namespace gsim::drawing::nurbs_test
