#include "batch/search/space.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gsim::batch {

namespace {

using Eigen::Index;

constexpr double kLastShare = 1 - 1e-12;  // shares are below 1

std::size_t dimensions_of(const Setting& setting) {
    const auto* order = std::get_if<Order>(&setting.domain);
    return order != nullptr ? order->count : 1;
}

nlohmann::json order_of(const Eigen::VectorXd& keys) {
    std::vector<std::size_t> places(static_cast<std::size_t>(keys.size()));
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
        return keys[static_cast<Index>(a)] < keys[static_cast<Index>(b)];
    });
    return places;
}

}  // namespace

Space::Space(std::vector<Setting> settings) : settings_(std::move(settings)) {
    for (const Setting& setting : settings_) dimensions_ += dimensions_of(setting);
}

std::vector<SettingValue> Space::variant(const Eigen::VectorXd& point) const {
    std::vector<SettingValue> values;
    Index at = 0;
    for (const Setting& setting : settings_) {
        const auto count = static_cast<Index>(dimensions_of(setting));
        const bool ordered = std::holds_alternative<Order>(setting.domain);
        add_values(setting,
                   ordered ? order_of(point.segment(at, count))
                           : value_at(setting.domain, std::min(point[at], kLastShare)),
                   values);
        at += count;
    }
    return values;
}

}  // namespace gsim::batch
