#include "geometry/planar/chain.h"

#include <gtest/gtest.h>

#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry::chain_test {

namespace {

// The edges of a contour one by one, in any order and sense, their ends moved by up to `gap_mm`.
std::vector<Contour> in_pieces(const Contour& contour, std::mt19937& random, double gap_mm) {
    std::uniform_real_distribution<double> shift(-gap_mm / 3, gap_mm / 3);
    std::vector<Contour> drawn_contours;
    for (std::size_t i = 0; i < contour.edges(); ++i) {
        Edge edge = contour.edge(i);
        edge.start = edge.start + Point{shift(random), shift(random)};
        Contour drawn_contour;
        append_edge(drawn_contour, edge, static_cast<std::uint32_t>(i));
        if (random() % 2 == 0) reverse(drawn_contour);
        drawn_contours.push_back(drawn_contour);
    }
    std::shuffle(drawn_contours.begin(), drawn_contours.end(), random);
    return drawn_contours;
}

TEST(Chain, ClosesEdgesInAnyOrderAndDirection) {
    std::mt19937 random(21);
    for (const double gap_mm : {0.0, 0.01}) {
        for (int i = 0; i < 20; ++i) {
            const Contour contour = star(random, 25, 10, 30, 0.5);
            const ChainResult chains = chain(in_pieces(contour, random, gap_mm), 0.02);
            ASSERT_EQ(chains.closed.size(), 1U);
            EXPECT_TRUE(chains.open.empty());
            EXPECT_NEAR(std::abs(area_mm2(chains.closed[0])), area_mm2(contour),
                        1e-6 + gap_mm * length_mm(contour));
        }
    }
}

TEST(Chain, StaysOpenIfGapExceedsTolerance) {
    Contour drawn_contour;
    append_edge(drawn_contour, {{0, 0}, {10, 0}, 0}, 0);
    append_edge(drawn_contour, {{10, 0}, {10, 10}, 0}, 0);
    append_edge(drawn_contour, {{10, 10}, {0, 0.1}, 0}, 0);
    EXPECT_EQ(chain({drawn_contour}, 0.05).open.size(), 1U);
    EXPECT_EQ(chain({drawn_contour}, 0.2).closed.size(), 1U);
}

TEST(Chain, ReportsTooManyEndsAtOnePoint) {
    std::vector<Contour> rays;
    for (int i = 0; i < 1000; ++i) {
        Contour ray;
        append_edge(ray, {{0, 0}, {std::cos(i * 0.006), std::sin(i * 0.006)}, 0}, 0);
        rays.push_back(ray);
    }
    EXPECT_TRUE(chain(rays, 0.001).is_ambiguous);
}

}  // namespace

}  // namespace gsim::geometry::chain_test
