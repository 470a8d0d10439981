#include "cam/cutting/tour.h"

#include <algorithm>

#include "cam/cutting/nearest_grid.h"

namespace gsim::cutting {

using geometry::Point;

namespace {

constexpr std::size_t kMaxPasses = 30;
constexpr std::size_t kMaxSteps = 60'000'000;  // comparisons in all
constexpr std::size_t kMaxMovedStops = 3;      // stops moved together (Or)
constexpr double kMinGain_mm = 1e-7;

double cut_distance(Point a, Point b) {
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
        Point current = start;
        while (grid.remaining() > 0) {
            order_.push_back(grid.pop_nearest(current));
            current = stops[order_.back()].exit;
        }
        const std::size_t steps_per_pass = kMaxSteps / kMaxPasses;
        window_ = std::clamp<std::size_t>(steps_per_pass / std::max<std::size_t>(1, stops.size()), 10, 1000);
    }

    std::vector<std::size_t> optimize() {
        bool better = order_.size() > 1;
        for (std::size_t pass = 0; better && pass < kMaxPasses; ++pass) {
            better = false;
            for (std::size_t i = 0; i < order_.size(); ++i) better = reverse_segment(i) || better;
            for (std::size_t i = 0; i < order_.size(); ++i) better = relocate(i) || better;
        }
        return std::move(order_);
    }

  private:
    Point exit_before(std::size_t i) const { return i == 0 ? start_ : stops_[order_[i - 1]].exit; }
    Point exit(std::size_t i) const { return stops_[order_[i]].exit; }
    Point entry(std::size_t i) const { return stops_[order_[i]].entry; }
    // Returns the distance from a point to the stop that follows index i.
    double distance_to_next(Point from, std::size_t i) const {
        if (i + 1 < order_.size()) return cut_distance(from, entry(i + 1));
        return end_ ? cut_distance(from, *end_) : 0;
    }

    // Reverses the best part that begins at index i, if that is shorter.
    bool reverse_segment(std::size_t i) {
        const Point before = exit_before(i);
        double forward_length = 0;  // within the part, as it is and turned round
        double back = 0;
        double best = -kMinGain_mm;
        std::size_t best_end = i;
        const std::size_t last = std::min(order_.size(), i + window_);
        for (std::size_t j = i + 1; j < last; ++j) {
            forward_length += cut_distance(exit(j - 1), entry(j));
            back += cut_distance(exit(j), entry(j - 1));
            const double old_length =
                cut_distance(before, entry(i)) + forward_length + distance_to_next(exit(j), j);
            const double new_length = cut_distance(before, entry(j)) + back + distance_to_next(exit(i), j);
            if (new_length - old_length < best) {
                best = new_length - old_length;
                best_end = j;
            }
        }
        if (best_end == i) return false;
        std::reverse(iterator_at(i), iterator_at(best_end + 1));
        return true;
    }

    // Moves up to three stops from index i to the position with the lowest cost.
    bool relocate(std::size_t i) {
        for (std::size_t count = 1; count <= kMaxMovedStops && i + count <= order_.size(); ++count) {
            const std::size_t last = i + count - 1;
            const double saved_mm = cut_distance(exit_before(i), entry(i)) +
                                    distance_to_next(exit(last), last) -
                                    distance_to_next(exit_before(i), last);
            if (saved_mm <= kMinGain_mm) continue;
            const std::size_t target = cheapest_position(i, count, saved_mm);
            if (target == i) continue;
            if (target < i) {
                std::rotate(iterator_at(target), iterator_at(i), iterator_at(i + count));
            } else {
                std::rotate(iterator_at(i), iterator_at(i + count), iterator_at(target));
            }
            return true;
        }
        return false;
    }

    // Returns the index before which the stops cost less than now; i if none is found.
    std::size_t cheapest_position(std::size_t i, std::size_t count, double saved_mm) const {
        const std::size_t last = i + count - 1;
        double best = saved_mm - kMinGain_mm;
        std::size_t best_position = i;
        const auto try_target = [&](std::size_t target) {
            const Point from = exit_before(target);
            const double on =
                target == 0 ? distance_to(exit(last), 0) : distance_to_next(exit(last), target - 1);
            const double direct = target == 0 ? distance_to(from, 0) : distance_to_next(from, target - 1);
            const double cost = cut_distance(from, entry(i)) + on - direct;
            if (cost < best) {
                best = cost;
                best_position = target;
            }
        };
        for (std::size_t target = i - std::min(i, window_); target < i; ++target) try_target(target);
        const std::size_t last_target = std::min(order_.size(), last + window_);
        for (std::size_t target = last + 2; target <= last_target; ++target) try_target(target);
        return best_position;
    }

    double distance_to(Point from, std::size_t i) const { return cut_distance(from, entry(i)); }
    std::vector<std::size_t>::iterator iterator_at(std::size_t i) {
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
    return Tour(stops, start, end).optimize();
}

double tour_length_mm(std::span<const Stop> stops, std::span<const std::size_t> order, Point start,
                      std::optional<Point> end) {
    double sum = 0;
    Point current = start;
    for (const std::size_t i : order) {
        sum += cut_distance(current, stops[i].entry);
        current = stops[i].exit;
    }
    return end ? sum + cut_distance(current, *end) : sum;
}

}  // namespace gsim::cutting
