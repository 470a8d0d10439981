#include "geometry/planar/fit.h"

#include <gtest/gtest.h>

namespace gsim::geometry::fit_test {

namespace {

TEST(Fit, KeepsAreaAndToleranceOfEllipse) {
    for (const double ratio : {1.0, 0.5, 0.02}) {
        for (const double tolerance_mm : {0.1, 0.001}) {
            const double a = 50;
            const double b = a * ratio;
            Contour contour;
            fit_arcs(
                [&](double t) {
                    return CurvePoint{{a * std::cos(t), b * std::sin(t)},
                                      {-a * std::sin(t), b * std::cos(t)}};
                },
                0, 2 * std::numbers::pi, tolerance_mm, 0, contour);
            contour.vertices.pop_back();
            contour.closed = true;
            EXPECT_NEAR(area_mm2(contour), std::numbers::pi * a * b, 5 * a * tolerance_mm);
            for (std::size_t i = 0; i < contour.edges(); ++i) {
                for (double share = 0; share < 1; share += 0.1) {
                    const Point p = point_at(contour.edge(i), share);
                    // Distance from the ellipse, to the first order.
                    const double value = p.x * p.x / (a * a) + p.y * p.y / (b * b) - 1;
                    const double slope = 2 * std::hypot(p.x / (a * a), p.y / (b * b));
                    EXPECT_LE(std::abs(value) / slope, 1.2 * tolerance_mm);
                }
            }
        }
    }
}

TEST(Fit, UsesFewArcsForCircle) {
    Contour contour;
    fit_arcs(
        [](double t) {
            return CurvePoint{{9 * std::cos(t), 9 * std::sin(t)}, {-std::sin(t), std::cos(t)}};
        },
        0, 2 * std::numbers::pi, 1e-6, 0, contour);
    EXPECT_LE(contour.edges(), 8U);
    for (std::size_t i = 0; i < contour.edges(); ++i) EXPECT_NEAR(radius_mm(contour.edge(i)), 9, 1e-9);
}

TEST(Fit, FitsStraightCurveWithLines) {
    Contour contour;
    fit_arcs(
        [](double t) {
            return CurvePoint{{t * t, 2 * t * t}, {2 * t, 4 * t}};
        },
        1, 3, 0.001, 0, contour);
    for (std::size_t i = 0; i < contour.edges(); ++i) EXPECT_FALSE(is_arc(contour.edge(i)));
    EXPECT_NEAR(length_mm(contour), std::hypot(8, 16), 1e-9);
}

TEST(Fit, TerminatesAtCusp) {
    Contour contour;  // y^2 = x^3, which has no direction at the origin
    fit_arcs(
        [](double t) {
            return CurvePoint{{t * t, t * t * t}, {2 * t, 3 * t * t}};
        },
        -1, 1, 0.01, 0, contour);
    EXPECT_LT(contour.edges(), 100U);
    EXPECT_NEAR(distance(contour.vertices.back().position, {1, 1}), 0, 1e-12);
}

}  // namespace

}  // namespace gsim::geometry::fit_test
