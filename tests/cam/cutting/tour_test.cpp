#include "cam/cutting/tour.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace gsim::cutting::tour_test {

namespace {

using geometry::Point;

std::vector<Stop> random_stops(std::mt19937& random, std::size_t count, double apart) {
    std::uniform_real_distribution<double> position(0, 100);
    std::uniform_real_distribution<double> shift(-apart, apart);
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < count; ++i) {
        const Point entry{position(random), position(random)};
        stops.push_back({entry, entry + Point{shift(random), shift(random)}});
    }
    return stops;
}

double shortest(const std::vector<Stop>& stops, Point start, std::optional<Point> end) {
    std::vector<std::size_t> order(stops.size());
    std::iota(order.begin(), order.end(), 0U);
    double best = HUGE_VAL;
    do {
        best = std::min(best, tour_length_mm(stops, order, start, end));
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

TEST(Tour, FewStopsGiveNearlyShortestTour) {
    std::mt19937 random(41);
    double sum = 0;
    double min = 0;
    for (int i = 0; i < 40; ++i) {
        const std::vector<Stop> stops = random_stops(random, 1 + random() % 7, 10);
        const std::optional<Point> end = i % 2 == 0 ? std::optional<Point>(Point{50, 0}) : std::nullopt;
        const std::vector<std::size_t> order = short_tour(stops, {0, 0}, end);
        const double found = tour_length_mm(stops, order, {0, 0}, end);
        const double best = shortest(stops, {0, 0}, end);
        EXPECT_LE(found, 1.3 * best);
        sum += found;
        min += best;
    }
    EXPECT_LE(sum, 1.03 * min);
}

TEST(Tour, VisitsEachStopOnce) {
    std::mt19937 random(42);
    for (const std::size_t count : {0, 1, 2, 3, 50, 500}) {
        std::vector<std::size_t> order = short_tour(random_stops(random, count, 1), {0, 0}, {});
        std::sort(order.begin(), order.end());
        ASSERT_EQ(order.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(order[i], i);
    }
}

// A shortest tour of n random points in a square of area A has the length 0.7124 sqrt(n A) (Beardwood, Halton
// and Hammersley, 1959; Johnson and McGeoch, 1997). Heuristics of this kind come within some 10 %.
TEST(Tour, ManyStopsStayNearExpectedLength) {
    std::mt19937 random(43);
    const std::vector<Stop> stops = random_stops(random, 1000, 0);
    const double found = tour_length_mm(stops, short_tour(stops, {0, 0}, {}), {0, 0}, {});
    EXPECT_LE(found, 1.12 * 0.7124 * std::sqrt(1000.0 * 100 * 100));
}

TEST(Tour, HandlesCoincidentAndCollinearStops) {
    const std::vector<Stop> same(500, Stop{{1, 1}, {1, 1}});
    EXPECT_EQ(short_tour(same, {0, 0}, {}).size(), 500U);
    std::vector<Stop> line;
    for (int i = 0; i < 500; ++i)
        line.push_back({{static_cast<double>(i * 7919 % 500), 3}, {static_cast<double>(i * 7919 % 500), 3}});
    EXPECT_NEAR(tour_length_mm(line, short_tour(line, {0, 3}, {}), {0, 3}, {}), 499, 1e-9);
}

}  // namespace

}  // namespace gsim::cutting::tour_test
