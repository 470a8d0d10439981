#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "motion/planner/time_bound.h"

/// Random paths for the tests of TimeBound, and what their times are known by.
namespace gsim::motion::bound_paths {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kRounding = 1e-11;

inline rrs::JointPos joints(std::initializer_list<double> values) {
    rrs::JointPos q(static_cast<Eigen::Index>(values.size()));
    std::copy(values.begin(), values.end(), q.begin());
    return q;
}

/// Returns the time between standstills, from first principles.
inline double trapezoid_s(double length, const PathCaps& caps) {
    const double slowness = 1 / caps.max_acceleration + 1 / caps.max_deceleration;
    if (caps.max_speed * caps.max_speed * slowness / 2 > length) return std::sqrt(2 * length * slowness);
    return length / caps.max_speed + caps.max_speed * slowness / 2;
}

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double around(double middle, double decades = 1) {
        return middle * std::pow(10, between(-decades, decades));
    }
    int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    PathCaps caps(double decades = 1) {
        return {around(100, decades), around(1000, decades), around(1000, decades)};
    }

  private:
    std::mt19937 engine_;
};

struct Wave {
    double amplitude, frequency, phase;
};

/// A curve that is a sum of sines and a drift in each joint, under limits of the joints and the path.
struct Shape {
    double length = 0;
    std::vector<std::vector<Wave>> joints;
    std::vector<double> joint_slope;
    JointLimits limits;
    PathCaps caps;

    CurvePoint at(double s) const {
        const auto count = static_cast<Eigen::Index>(joints.size());
        CurvePoint point{rrs::JointPos::Zero(count), rrs::JointPos::Zero(count), rrs::JointPos::Zero(count)};
        for (Eigen::Index j = 0; j < count; ++j) {
            point.q[j] = joint_slope[static_cast<std::size_t>(j)] * s;
            point.q1[j] = joint_slope[static_cast<std::size_t>(j)];
            for (const auto& [amplitude, frequency, phase] : joints[static_cast<std::size_t>(j)]) {
                point.q[j] += amplitude * std::sin(frequency * s + phase);
                point.q1[j] += amplitude * frequency * std::cos(frequency * s + phase);
                point.q2[j] -= amplitude * frequency * frequency * std::sin(frequency * s + phase);
            }
        }
        return point;
    }

    Curve curve() const {
        Curve result{.length = length, .turn_rad = 0, .max_q2 = {}, .at = {}};
        result.max_q2 = rrs::JointPos::Zero(static_cast<Eigen::Index>(joints.size()));
        for (std::size_t j = 0; j < joints.size(); ++j) {
            for (const Wave& wave : joints[j]) {
                result.max_q2[static_cast<Eigen::Index>(j)] +=
                    wave.amplitude * wave.frequency * wave.frequency;
                result.turn_rad = std::max(result.turn_rad, wave.frequency * length);
            }
        }
        result.at = [this](double s) { return at(s); };
        return result;
    }

    double bound_s(TimeBoundGrid grid = {}) const {
        TimeBound bound(limits, grid);
        bound.add_curve(curve(), caps);
        return bound.bound_s();
    }

    /// By what factor a law with these values passes a limit here, as the square of a stretch of time.
    double excess(double s, double speed2, double a) const {
        const CurvePoint point = at(s);
        double worst = std::max(
            {speed2 / std::pow(caps.max_speed, 2), a / caps.max_acceleration, -a / caps.max_deceleration});
        for (Eigen::Index j = 0; j < point.q.size(); ++j) {
            const double acceleration = std::abs(point.q2[j] * speed2 + point.q1[j] * a);
            worst = std::max({worst, acceleration / limits.max_acceleration[j],
                              speed2 * std::pow(point.q1[j] / limits.max_speed[j], 2)});
        }
        return worst;
    }
};

inline Shape circle(double radius, double turns, double acceleration) {
    const double half_pi = std::numbers::pi / 2;
    return {2 * std::numbers::pi * radius * turns,
            {{{radius, 1 / radius, half_pi}}, {{radius, 1 / radius, 0}}},
            {0, 0},
            {joints({1e9, 1e9}), joints({acceleration, acceleration})},
            {}};
}

inline Shape random_shape(Random& random) {
    Shape shape;
    const int count = random.count(2, 4);
    shape.length = random.between(2, 8);
    shape.limits = {rrs::JointPos::Zero(count), rrs::JointPos::Zero(count)};
    for (int j = 0; j < count; ++j) {
        shape.joints.emplace_back();
        for (int k = random.count(1, 2); k > 0; --k) {
            shape.joints.back().push_back(
                {random.around(1, 0.3), random.between(0.3, 2), random.between(0, 6)});
        }
        shape.joint_slope.push_back(random.between(-1, 1));
        shape.limits.max_speed[j] = random.around(10, 0.7);
        shape.limits.max_acceleration[j] = random.around(20, 0.5);
    }
    if (random.count(0, 1) > 0) shape.caps = {random.around(10), random.around(10), random.around(10)};
    return shape;
}

}  // namespace gsim::motion::bound_paths
