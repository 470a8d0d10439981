#include "toolpath/rotary/rotary_candidates.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::path {

namespace {

constexpr double kConfigurationTolerance_deg = 1e-7;
constexpr double kRangeSlack_deg = 1e-6;
constexpr double kEndlessRange_deg = 3600;  // beyond that, an axis counts as endless
constexpr std::size_t kMaxCandidates = 32;

bool is_same(const AxisValues& a, const AxisValues& b) {
    return a.size() == 0 || (a - b).cwiseAbs().maxCoeff() < kConfigurationTolerance_deg;
}

void add_unique(std::vector<AxisValues>& list, const AxisValues& values) {
    if (list.size() >= kMaxCandidates) return;
    const auto same = [&](const AxisValues& each) { return is_same(each, values); };
    if (std::none_of(list.begin(), list.end(), same)) list.push_back(values);
}

// Returns the values of one axis that differ from `value` in full turns and lie in its range; for an endless
// axis, the one nearest to `near`.
std::vector<double> in_range(const machine::Axis& axis, double value, double near) {
    std::vector<double> found;
    if (axis.max - axis.min > kEndlessRange_deg) {
        found.push_back(value + 360 * std::round((near - value) / 360));
        return found;
    }
    const double first = value + 360 * std::ceil((axis.min - kRangeSlack_deg - value) / 360);
    for (double each = first; each <= axis.max + kRangeSlack_deg; each += 360) {
        found.push_back(std::clamp(each, axis.min, axis.max));
    }
    return found;
}

// Leaves axes that are not named unchanged.
Result<AxisValues> specified_values(const MachineSpace& space, const RotaryAxes& given,
                                    const AxisValues& before) {
    AxisValues values = before;
    for (const auto& [letter, value_deg] : given) {
        std::size_t axis = 0;
        while (axis < space.rotary_count() && space.rotary_axis(axis).letter != letter) ++axis;
        if (axis == space.rotary_count()) {
            return Unexpected(
                fmt::format("the machine '{}' has no rotary axis {}", space.machine().name, letter));
        }
        values[static_cast<Eigen::Index>(axis)] = value_deg;
    }
    return values;
}

std::string out_of_range(const MachineSpace& space, const AxisValues& values) {
    std::string text = "out of reach: no full turn brings";
    for (std::size_t i = 0; i < space.rotary_count(); ++i) {
        const machine::Axis& axis = space.rotary_axis(i);
        text += fmt::format("{} {} {:.6g} into {:.6g} to {:.6g}", i == 0 ? "" : " and", axis.letter,
                            values[static_cast<Eigen::Index>(i)], axis.min, axis.max);
    }
    return text;
}

}  // namespace

double turn_between(const AxisValues& from, const AxisValues& to) {
    return from.size() == 0 ? 0.0 : (to - from).cwiseAbs().sum();
}

double min_turn_between(const AxisValues& from, const AxisValues& to) {
    double sum = 0;
    for (Eigen::Index i = 0; i < from.size(); ++i) sum += std::abs(std::remainder(to[i] - from[i], 360.0));
    return sum;
}

void add_full_turns(const MachineSpace& space, const AxisValues& values, const AxisValues& near,
                    std::vector<AxisValues>& out) {
    std::vector<AxisValues> partial_solutions{values};
    for (std::size_t axis = 0; axis < space.rotary_count(); ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        std::vector<AxisValues> next;
        for (const AxisValues& each : partial_solutions) {
            for (const double turned : in_range(space.rotary_axis(axis), each[i], near[i])) {
                next.push_back(each);
                next.back()[i] = turned;
            }
        }
        partial_solutions = std::move(next);
    }
    for (const AxisValues& each : partial_solutions) add_unique(out, each);
}

Result<std::vector<AxisValues>> rotary_candidates(const MachineSpace& space, const Vector& tcp_mm,
                                                  const Orientation& orientation,
                                                  const std::vector<AxisValues>& before, bool is_literal) {
    std::vector<AxisValues> found;
    std::vector<AxisValues> checked_bodies;
    std::optional<AxisValues> unreachable;
    for (const AxisValues& near : before) {
        // Full turns of the previous values lead to the same solutions; an endless axis follows each.
        const auto is_same_turn = [&](const AxisValues& each) {
            return min_turn_between(each, near) < kConfigurationTolerance_deg;
        };
        const bool known = std::any_of(checked_bodies.begin(), checked_bodies.end(), is_same_turn);
        if (known && !is_literal && !std::holds_alternative<RotaryAxes>(orientation)) continue;
        checked_bodies.push_back(near);
        std::vector<AxisValues> solutions;
        if (const auto* given = std::get_if<RotaryAxes>(&orientation)) {
            const auto values = specified_values(space, *given, near);
            if (!values) return tl::unexpected(values.error());
            if (is_literal) {
                add_unique(found, *values);
                continue;
            }
            solutions.push_back(*values);
        } else {
            auto solved = space.solve_rotary(tcp_mm, orientation, near);
            if (!solved) return tl::unexpected(solved.error());
            solutions = std::move(*solved);
        }
        for (const AxisValues& each : solutions) {
            add_full_turns(space, each, near, found);
            if (!unreachable) unreachable = each;
        }
    }
    if (found.empty() && unreachable) return tl::unexpected(out_of_range(space, *unreachable));
    return found;
}

}  // namespace gsim::path
