#include "cam/cutting/tour.h"

#include <algorithm>

#include "cam/cutting/nearest_grid.h"

namespace gsim::cutting {

using geometry::Point;

namespace {

constexpr std::size_t kMaxPasses = 30;
constexpr std::size_t kMaxSteps = 60'000'000;  // comparisons in all
constexpr std::size_t kMaxMoved = 3;           // stops moved together (Or)
constexpr double kGain_mm = 1e-7;

double way(Point a, Point b) {
    return std::sqrt(dot(b - a, b - a));
}

class Tour {
  public:
    Tour(std::span<const Stop> stops, Point start, std::optional<Point> end)
        : stops_(stops), start_(start), end_(end) {
        std::vector<Point> entries;
        entries.reserve(stops.size());
        for (const Stop& stop : stops) entries.push_back(stop.entry);
        NearestGrid grid(std::move(entries));
        order_.reserve(stops.size());
        Point here = start;
        while (grid.left() > 0) {
            order_.push_back(grid.take_nearest(here));
            here = stops[order_.back()].exit;
        }
        const std::size_t per_pass = kMaxSteps / kMaxPasses;
        window_ = std::clamp<std::size_t>(per_pass / std::max<std::size_t>(1, stops.size()), 10, 1000);
    }

    std::vector<std::size_t> improved() {
        bool better = order_.size() > 1;
        for (std::size_t pass = 0; better && pass < kMaxPasses; ++pass) {
            better = false;
            for (std::size_t i = 0; i < order_.size(); ++i) better = turn_round(i) || better;
            for (std::size_t i = 0; i < order_.size(); ++i) better = move_from(i) || better;
        }
        return std::move(order_);
    }

  private:
    Point exit_before(std::size_t i) const { return i == 0 ? start_ : stops_[order_[i - 1]].exit; }
    Point exit(std::size_t i) const { return stops_[order_[i]].exit; }
    Point entry(std::size_t i) const { return stops_[order_[i]].entry; }
    // Returns the distance from a point to the stop after index i.
    double way_on(Point from, std::size_t i) const {
        if (i + 1 < order_.size()) return way(from, entry(i + 1));
        return end_ ? way(from, *end_) : 0;
    }

    // Reverses the best part that begins at index i, if that is shorter.
    bool turn_round(std::size_t i) {
        const Point before = exit_before(i);
        double there = 0;  // within the part, as it is and turned round
        double back = 0;
        double best = -kGain_mm;
        std::size_t best_end = i;
        const std::size_t last = std::min(order_.size(), i + window_);
        for (std::size_t j = i + 1; j < last; ++j) {
            there += way(exit(j - 1), entry(j));
            back += way(exit(j), entry(j - 1));
            const double old_ways = way(before, entry(i)) + there + way_on(exit(j), j);
            const double new_ways = way(before, entry(j)) + back + way_on(exit(i), j);
            if (new_ways - old_ways < best) {
                best = new_ways - old_ways;
                best_end = j;
            }
        }
        if (best_end == i) return false;
        std::reverse(place(i), place(best_end + 1));
        return true;
    }

    // Moves up to three stops from index i to the position with the lowest cost.
    bool move_from(std::size_t i) {
        for (std::size_t count = 1; count <= kMaxMoved && i + count <= order_.size(); ++count) {
            const std::size_t last = i + count - 1;
            const double saved =
                way(exit_before(i), entry(i)) + way_on(exit(last), last) - way_on(exit_before(i), last);
            if (saved <= kGain_mm) continue;
            const std::size_t target = cheapest_place(i, count, saved);
            if (target == i) continue;
            if (target < i) {
                std::rotate(place(target), place(i), place(i + count));
            } else {
                std::rotate(place(i), place(i + count), place(target));
            }
            return true;
        }
        return false;
    }

    // Returns the index before which the stops cost less than now; i if none is found.
    std::size_t cheapest_place(std::size_t i, std::size_t count, double saved) const {
        const std::size_t last = i + count - 1;
        double best = saved - kGain_mm;
        std::size_t best_place = i;
        const auto consider = [&](std::size_t target) {
            const Point from = exit_before(target);
            const double on = target == 0 ? way_to(exit(last), 0) : way_on(exit(last), target - 1);
            const double direct = target == 0 ? way_to(from, 0) : way_on(from, target - 1);
            const double cost = way(from, entry(i)) + on - direct;
            if (cost < best) {
                best = cost;
                best_place = target;
            }
        };
        for (std::size_t target = i - std::min(i, window_); target < i; ++target) consider(target);
        const std::size_t furthest = std::min(order_.size(), last + window_);
        for (std::size_t target = last + 2; target <= furthest; ++target) consider(target);
        return best_place;
    }

    double way_to(Point from, std::size_t i) const { return way(from, entry(i)); }
    std::vector<std::size_t>::iterator place(std::size_t i) {
        return order_.begin() + static_cast<std::ptrdiff_t>(i);
    }

    std::span<const Stop> stops_;
    Point start_;
    std::optional<Point> end_;
    std::vector<std::size_t> order_;
    std::size_t window_ = 0;
};

}  // namespace

std::vector<std::size_t> short_tour(std::span<const Stop> stops, Point start, std::optional<Point> end) {
    return Tour(stops, start, end).improved();
}

double tour_length_mm(std::span<const Stop> stops, std::span<const std::size_t> order, Point start,
                      std::optional<Point> end) {
    double sum = 0;
    Point here = start;
    for (const std::size_t i : order) {
        sum += way(here, stops[i].entry);
        here = stops[i].exit;
    }
    return end ? sum + way(here, *end) : sum;
}

}  // namespace gsim::cutting
