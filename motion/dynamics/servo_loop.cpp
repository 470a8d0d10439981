#include "motion/dynamics/servo_loop.h"

#include <algorithm>
#include <cmath>

namespace gsim::dynamics {

namespace {

/// exp(-decay t) times the hyperbolic functions of sqrt(|square|) t, or the circular ones if `square` is
/// below 0: cosh, and sinh over the root.
struct DampedSolution {
    double even;
    double odd;
};

DampedSolution damped_solution(double decay_1_s, double square, double t_s) {
    const double root = std::sqrt(std::abs(square));
    const double angle = root * t_s;
    const double decay_factor = std::exp(-decay_1_s * t_s);
    if (angle < 0.1) {  // by their series: the next terms are below rounding
        const double n = square * t_s * t_s;
        return {decay_factor * (1 + n / 2 * (1 + n / 12 * (1 + n / 30 * (1 + n / 56)))),
                decay_factor * t_s * (1 + n / 6 * (1 + n / 20 * (1 + n / 42 * (1 + n / 72))))};
    }
    if (square < 0) return {decay_factor * std::cos(angle), decay_factor * std::sin(angle) / root};
    // The slow pole is computed by the product of both, so that neither is a difference of near numbers.
    const double fast_1_s = decay_1_s + root;
    const double slow_1_s = (decay_1_s * decay_1_s - square) / fast_1_s;
    const double slow = std::exp(-slow_1_s * t_s), fast = std::exp(-fast_1_s * t_s);
    return {(slow + fast) / 2, (slow - fast) / (2 * root)};
}

}  // namespace

double ServoLoop::slowest_1_s() const {
    if (lag_s <= 0 || std::isinf(gain_1_s)) return gain_1_s;
    const double decay_1_s = 1 / (2 * lag_s);
    const double square = decay_1_s * decay_1_s - gain_1_s / lag_s;
    return square > 0 ? gain_1_s / lag_s / (decay_1_s + std::sqrt(square)) : decay_1_s;
}

ServoStep::ServoStep(const ServoLoop& loop, const SpeedPolynomial& speed, const ServoError& start)
    : lag_s_(loop.lag_s) {
    if (std::isinf(loop.gain_1_s)) return;
    gain_1_s_ = loop.gain_1_s;
    const double velocity_error_gain = 1 - loop.velocity_share;
    const double acceleration_error_gain = (1 - loop.acceleration_share) * lag_s_;
    const std::array<double, 4> commanded{
        velocity_error_gain * speed[0] + acceleration_error_gain * speed[1],
        velocity_error_gain * speed[1] + acceleration_error_gain * 2 * speed[2],
        velocity_error_gain * speed[2] + acceleration_error_gain * 3 * speed[3],
        velocity_error_gain * speed[3]};
    auto& [p0, p1, p2, p3] = forced_response_;
    p3 = commanded[3] / gain_1_s_;
    p2 = (commanded[2] - 3 * p3) / gain_1_s_;
    p1 = (commanded[1] - 2 * p2 - 6 * lag_s_ * p3) / gain_1_s_;
    p0 = (commanded[0] - p1 - 2 * lag_s_ * p2) / gain_1_s_;
    transient_ = {start.value - p0, lag_s_ > 0 ? start.rate - p1 : 0};
}

ServoError ServoStep::at(double t_s) const {
    if (gain_1_s_ == 0) return {};
    const auto& [p0, p1, p2, p3] = forced_response_;
    const ServoError remaining = transient_at(t_s);
    return {p0 + t_s * (p1 + t_s * (p2 + t_s * p3)) + remaining.value,
            p1 + t_s * (2 * p2 + t_s * 3 * p3) + remaining.rate};
}

ServoError ServoStep::transient_at(double t_s) const {
    if (transient_.value == 0 && transient_.rate == 0) return {};
    if (lag_s_ <= 0) {
        const double value = transient_.value * std::exp(-gain_1_s_ * t_s);
        return {value, -gain_1_s_ * value};
    }
    const double decay_1_s = 1 / (2 * lag_s_);
    const double square = decay_1_s * decay_1_s - gain_1_s_ / lag_s_;
    const DampedSolution solution = damped_solution(decay_1_s, square, t_s);
    const double rate_term = transient_.rate + decay_1_s * transient_.value;
    const double value = transient_.value * solution.even + rate_term * solution.odd;
    return {value, transient_.value * square * solution.odd + rate_term * solution.even - decay_1_s * value};
}

// With real poles the error is at most |e| + |e'| lag; with complex ones its energy gain e^2 + lag e'^2
// never grows.
double ServoStep::transient_bound() const {
    if (lag_s_ <= 0) return std::abs(transient_.value);
    return std::abs(transient_.value) +
           std::abs(transient_.rate) * std::max(lag_s_, std::sqrt(lag_s_ / gain_1_s_));
}

}  // namespace gsim::dynamics
