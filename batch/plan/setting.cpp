#include "batch/plan/setting.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/normal.hpp>

namespace gsim::batch {

namespace {

using nlohmann::json;

// What no double is nearer to 0 or 1 by: a normal distribution has no value there.
constexpr double kLeastShare = 1e-12;

json value_of(const Choices& choices, double share) {
    const auto count = static_cast<double>(choices.values.size());
    const auto place = static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1));
    return choices.values[place];
}

json value_of(const Uniform& uniform, double share) {
    return uniform.from + share * (uniform.to - uniform.from);
}

json value_of(const Normal& normal, double share) {
    if (normal.deviation <= 0) return normal.mean;
    return boost::math::quantile(boost::math::normal(normal.mean, normal.deviation),
                                 std::clamp(share, kLeastShare, 1 - kLeastShare));
}

// Its distribution function is a parabola on either side of the mode.
json value_of(const Triangular& triangle, double share) {
    const double width = triangle.to - triangle.from;
    if (width <= 0) return triangle.from;
    const double rise = triangle.mode - triangle.from;
    if (share * width < rise) return triangle.from + std::sqrt(share * width * rise);
    return triangle.to - std::sqrt((1 - share) * width * (width - rise));
}

}  // namespace

json value_at(const Domain& domain, double share) {
    return std::visit([share](const auto& one) { return value_of(one, share); }, domain);
}

}  // namespace gsim::batch
