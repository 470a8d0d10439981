#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "motion/profile/ramp.h"
#include "motion/profile/s_curve.h"

namespace gsim::motion {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Arguments of TimeLaw::between().
struct LawCase {
    double length, start, end;
    LawLimits limits;
};

inline testing::Message what(const LawCase& c) {
    return testing::Message() << "length " << c.length << " start " << c.start << " end " << c.end
                              << " max_speed " << c.limits.max_speed << " acceleration "
                              << c.limits.acceleration << " deceleration " << c.limits.deceleration
                              << " jerk " << c.limits.jerk;
}

/// Random requests over many orders of magnitude, with infinite limits among them.
class LawCases {
  public:
    explicit LawCases(unsigned seed) : random_(seed) {}

    double log_uniform(double low, double high) {
        return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random_));
    }
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    bool chance(double probability) { return share() < probability; }

    LawLimits limits() {
        return {allows_infinite(log_uniform(1, 3000)), allows_infinite(log_uniform(10, 1e5)),
                allows_infinite(log_uniform(10, 1e5)), allows_infinite(log_uniform(100, 1e8))};
    }

    LawCase rest_to_rest() { return {log_uniform(1e-4, 1e4), 0, 0, limits()}; }

    /// Returns speeds within max_speed, and a length that suffices, of at most kMaxLength_mm.
    LawCase moving() {
        LawCase c = any_moving();
        while (c.length > kMaxLength_mm) c = any_moving();
        return c;
    }

    /// Returns a start speed that is too high, and a length of at most kMaxLength_mm that suffices to brake
    /// to the end in one step.
    LawCase too_fast() {
        LawCase c = any_too_fast();
        while (c.length > kMaxLength_mm) c = any_too_fast();
        return c;
    }

  private:
    static constexpr double kMaxLength_mm = 1e5;  // doubles are exact to 1e-11 mm there

    LawCase any_moving() {
        LawCase c = rest_to_rest();
        const double fastest = std::min(c.limits.max_speed, 3000.0);
        c.start = speed(fastest);
        c.end = chance(0.2) ? c.start : speed(fastest);
        const double limit = c.start < c.end ? c.limits.acceleration : c.limits.deceleration;
        const double direct = ramp_length(c.start, c.end, limit, c.limits.jerk);
        if (direct > 0) c.length = direct * (1 + log_uniform(1e-9, 1e3));
        return c;
    }

    LawCase any_too_fast() {
        LawCase c = rest_to_rest();
        if (std::isinf(c.limits.max_speed)) c.limits.max_speed = 50;
        if (std::isinf(c.limits.deceleration) && std::isinf(c.limits.jerk)) c.limits.deceleration = 500;
        c.start = c.limits.max_speed * (1 + log_uniform(1e-3, 10));
        c.end = chance(0.2) ? c.limits.max_speed : speed(c.limits.max_speed);
        const double direct = ramp_length(c.start, c.end, c.limits.deceleration, c.limits.jerk);
        c.length = direct * (1 + log_uniform(1e-6, 10));
        return c;
    }

    double allows_infinite(double limit) { return chance(0.1) ? kInfinity : limit; }
    double speed(double fastest) {
        if (chance(0.2)) return 0;
        return chance(0.2) ? fastest : fastest * log_uniform(1e-4, 1);
    }

    std::mt19937 random_;
};

}  // namespace gsim::motion
