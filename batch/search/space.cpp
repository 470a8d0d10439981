#include "batch/search/space.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gsim::batch {

namespace {

using Eigen::Index;

constexpr double kMaxShare = 1 - 1e-12;  // shares are below 1

std::size_t dimension_count(const Setting& setting) {
    const auto* order = std::get_if<Order>(&setting.domain);
    return order != nullptr ? order->count : 1;
}

nlohmann::json sort_order(const Eigen::VectorXd& keys) {
    std::vector<std::size_t> sort_order_indices(static_cast<std::size_t>(keys.size()));
    std::iota(sort_order_indices.begin(), sort_order_indices.end(), std::size_t{0});
    std::stable_sort(sort_order_indices.begin(), sort_order_indices.end(), [&](std::size_t a, std::size_t b) {
        return keys[static_cast<Index>(a)] < keys[static_cast<Index>(b)];
    });
    return sort_order_indices;
}

}  // namespace

SearchSpace::SearchSpace(std::vector<Setting> settings) : settings_(std::move(settings)) {
    for (const Setting& setting : settings_) dimensions_ += dimension_count(setting);
}

std::vector<SettingValue> SearchSpace::variant(const Eigen::VectorXd& point) const {
    std::vector<SettingValue> values;
    Index at = 0;
    for (const Setting& setting : settings_) {
        const auto count = static_cast<Index>(dimension_count(setting));
        const bool ordered = std::holds_alternative<Order>(setting.domain);
        add_values(setting,
                   ordered ? sort_order(point.segment(at, count))
                           : value_at(setting.domain, std::min(point[at], kMaxShare)),
                   values);
        at += count;
    }
    return values;
}

}  // namespace gsim::batch
