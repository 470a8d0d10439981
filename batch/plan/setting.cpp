#include "batch/plan/setting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <boost/math/distributions/normal.hpp>

namespace gsim::batch {

namespace {

using nlohmann::json;

// Smallest distance from 0 and 1, because a normal distribution has no value there.
constexpr double kMinShare = 1e-12;

json value_at_share(const Choices& choices, double share) {
    const auto count = static_cast<double>(choices.values.size());
    const auto value_index = static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1));
    return choices.values[value_index];
}

json value_at_share(const Uniform& uniform, double share) {
    return uniform.from + share * (uniform.to - uniform.from);
}

json value_at_share(const Normal& normal, double share) {
    if (normal.deviation <= 0) return normal.mean;
    return boost::math::quantile(boost::math::normal(normal.mean, normal.deviation),
                                 std::clamp(share, kMinShare, 1 - kMinShare));
}

// The distribution function is a parabola on either side of the mode.
json value_at_share(const Triangular& triangle, double share) {
    const double width = triangle.to - triangle.from;
    if (width <= 0) return triangle.from;
    const double rise = triangle.mode - triangle.from;
    if (share * width < rise) return triangle.from + std::sqrt(share * width * rise);
    return triangle.to - std::sqrt((1 - share) * width * (width - rise));
}

/// Orders are numbered by Lehmer's code, with the first item most significant.
json value_at_share(const Order& order, double share) {
    std::vector<std::size_t> remaining(order.count);
    std::iota(remaining.begin(), remaining.end(), std::size_t{0});
    json list = json::array();
    double remaining_share = share;
    while (!remaining.empty()) {
        const double scaled_share = remaining_share * static_cast<double>(remaining.size());
        const auto value_index = std::min(static_cast<std::size_t>(scaled_share), remaining.size() - 1);
        remaining_share = scaled_share - static_cast<double>(value_index);
        list.push_back(remaining[value_index]);
        remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(value_index));
    }
    return list;
}

}  // namespace

void add_values(const Setting& setting, const json& value, std::vector<SettingValue>& values) {
    for (const std::string& key : setting.keys) values.push_back({key, value, setting.use});
}

json value_at(const Domain& domain, double share) {
    return std::visit([share](const auto& one) { return value_at_share(one, share); }, domain);
}

}  // namespace gsim::batch
