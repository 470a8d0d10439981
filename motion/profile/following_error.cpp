#include "motion/profile/following_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gsim::motion {

namespace {

/// Returns phi_k(-x) for k = 1, 2, 3 and x >= 0, with phi_0(z) = exp(z), phi_k+1(z) = (phi_k(z) - 1/k!) / z.
/// This is what an exponential decay leaves of an input that grows as t^(k-1), after a time of x time
/// constants.
std::array<double, 3> phi(double x) {
    constexpr double kSeriesBelow = 0.5;  // the recursion would cancel
    if (x < kSeriesBelow) {
        std::array<double, 3> values{};
        double first = 1;  // 1 / k!
        for (std::size_t k = 0; k < values.size(); ++k) {
            first /= static_cast<double>(k + 1);
            double term = first;
            for (int n = 1; n <= 14; ++n) {
                values[k] += term;
                term *= -x / static_cast<double>(n + static_cast<int>(k) + 1);
            }
        }
        return values;
    }
    const double phi1 = -std::expm1(-x) / x;
    const double phi2 = (1 - phi1) / x;
    return {phi1, phi2, (0.5 - phi2) / x};
}

}  // namespace

double lag_after(const TimeLaw& law, double lag, double gain_1_s) {
    if (law.sections().empty()) return lag + law.length();  // a jump
    for (const LawSection& section : law.sections()) {
        const double t = section.duration_s;
        const auto [phi1, phi2, phi3] = phi(gain_1_s * t);
        const double added_error =
            t * (section.v0 * phi1 + t * (section.a0 * phi2 + t * section.jerk * phi3));
        lag = std::max(lag * std::exp(-gain_1_s * t) + added_error, 0.0);
    }
    return lag;
}

Segment& FollowingError::begin(rrs::TargetId id) {
    open_ = &output_.begin(id);
    return *open_;
}

/// The time between two segments is a dwell. The lags of two simultaneous motions add up.
void FollowingError::finish() {
    const double gain_1_s = position_loop_.gain_1_s;
    if (gain_1_s > 0) {
        const double standstill_s = std::max(open_->start_s - end_s_, 0.0);
        lag_ = lag_after(open_->master, lag_ * std::exp(-gain_1_s * standstill_s), gain_1_s);
        if (open_->superimposed) lag_ += lag_after(open_->superimposed->master, 0, gain_1_s);
        if (open_->kind == SegmentKind::rest) lag_ *= std::exp(-gain_1_s * open_->duration_s);
        end_s_ = open_->end_s();
    }
    output_.finish();
}

}  // namespace gsim::motion
