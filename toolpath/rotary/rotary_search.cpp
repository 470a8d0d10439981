#include "toolpath/rotary/rotary_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "toolpath/rotary/rotary_candidates.h"

namespace gsim::path {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();
// Weight of the first point of a path, which has no predecessor; axes near home can turn in both directions.
constexpr double kHomeWeight = 1e-3;
// Cost that keeps the start of a sub-path within half a turn of home, so that the axes can reach it by the
// short turn from anywhere.
constexpr double kFarEntryWeight = 1e9;

bool is_far(const AxisValues& home, const AxisValues& values) {
    return home.size() > 0 && (values - home).cwiseAbs().maxCoeff() > 180 + kTurnTolerance_deg;
}

double min_rotation(const AxisValues& from, const std::vector<AxisValues>& candidates) {
    double min = kUnreachable;
    for (const AxisValues& each : candidates) min = std::min(min, min_turn_between(from, each));
    return min;
}

}  // namespace

void RotarySearch::begin(std::vector<AxisValues> candidates, const AxisValues& home, bool must_be_near_home) {
    costs_.clear();
    costs_.reserve(candidates.size());
    for (const AxisValues& each : candidates) {
        const double share = must_be_near_home && is_far(home, each) ? kFarEntryWeight : kHomeWeight;
        costs_.push_back(share * turn_between(home, each));
    }
    const std::vector<std::uint8_t> from(candidates.size(), 0);
    add_layer(std::move(candidates), from);
}

bool RotarySearch::step(std::vector<AxisValues> candidates, bool cutting, double stop_cost) {
    relax_turns_in_place(stop_cost);
    std::vector<double> next(candidates.size(), kUnreachable);
    std::vector<std::uint8_t> from(candidates.size(), 0);
    for (std::size_t k = 0; k < joint_values_.size(); ++k) {
        const double max =
            cutting ? min_rotation(joint_values_[k], candidates) + kTurnTolerance_deg : kUnreachable;
        for (std::size_t m = 0; m < candidates.size(); ++m) {
            const double turn = turn_between(joint_values_[k], candidates[m]);
            if (turn > max || costs_[k] + turn >= next[m]) continue;
            next[m] = costs_[k] + turn;
            from[m] = static_cast<std::uint8_t>(k);
        }
    }
    costs_ = std::move(next);
    add_layer(std::move(candidates), from);
    return *std::min_element(costs_.begin(), costs_.end()) < kUnreachable;
}

void RotarySearch::leave(std::vector<AxisValues> values) {
    values_.resize(values_.size() - rotary_count_);
    for (const AxisValues& each : values) values_.insert(values_.end(), each.begin(), each.end());
    from_.resize(from_.size() + values.size() - 1, 0);
    costs_.resize(values.size(), kUnreachable);
    joint_values_ = std::move(values);
}

void RotarySearch::add_layer(std::vector<AxisValues> candidates, const std::vector<std::uint8_t>& from) {
    layer_begins_.push_back(from_.size());
    from_.insert(from_.end(), from.begin(), from.end());
    for (const AxisValues& each : candidates) values_.insert(values_.end(), each.begin(), each.end());
    joint_values_ = std::move(candidates);
}

void RotarySearch::relax_turns_in_place(double stop_cost) {
    const std::vector<double> before = costs_;
    for (std::size_t k = 0; k < before.size(); ++k) {
        auto from = static_cast<std::uint8_t>(k);
        for (std::size_t j = 0; j < before.size(); ++j) {
            const double cost = before[j] + stop_cost + turn_between(joint_values_[j], joint_values_[k]);
            if (j == k || cost >= costs_[k]) continue;
            costs_[k] = cost;
            from = static_cast<std::uint8_t>(j);
        }
        in_place_predecessor_.push_back(from);
    }
}

AxisValues RotarySearch::value(std::size_t layer, std::size_t candidate) const {
    AxisValues values(static_cast<Eigen::Index>(rotary_count_));
    const std::size_t begin = (layer_begins_[layer] + candidate) * rotary_count_;
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(begin), rotary_count_, values.begin());
    return values;
}

RotarySchedule RotarySearch::result() const {
    RotarySchedule turns(rotary_count_);
    turns.unknown = unknown_;
    if (layer_begins_.empty()) return turns;
    turns.values.resize(layer_begins_.size() * rotary_count_);
    auto at = static_cast<std::size_t>(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
    for (std::size_t layer = layer_begins_.size(); layer-- > 0;) {
        const AxisValues values = value(layer, at);
        std::copy(values.begin(), values.end(),
                  turns.values.begin() + static_cast<std::ptrdiff_t>(layer * rotary_count_));
        if (layer == 0) break;
        const std::size_t departure_candidate = from_[layer_begins_[layer] + at];
        at = in_place_predecessor_[layer_begins_[layer - 1] + departure_candidate];
        if (at != departure_candidate)
            turns.unwindings.push_back({unknown_ + layer - 1, value(layer - 1, departure_candidate)});
    }
    std::reverse(turns.unwindings.begin(), turns.unwindings.end());
    return turns;
}

}  // namespace gsim::path
