#include "motion/kinematics/solution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "motion/kinematics/chain.h"
#include "motion/kinematics/pose.h"

namespace gsim::kinematics {

namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kRangeTolerance = 1e-9;
constexpr double kEqualTolerance = 1e-6;

bool inside(const JointRange& range, double value) {
    return value >= range.min - kRangeTolerance && value <= range.max + kRangeTolerance;
}

// Returns the angle nearest to `near` among those that differ from `angle` by full turns and are in range.
double unwrapped_near(const JointRange& range, double near, double angle) {
    const double closest = angle + kFullTurn_rad * std::round((near - angle) / kFullTurn_rad);
    if (closest < range.min - kRangeTolerance) {
        const double raised =
            closest + kFullTurn_rad * std::ceil((range.min - kRangeTolerance - closest) / kFullTurn_rad);
        return inside(range, raised) ? raised : closest;
    }
    if (closest > range.max + kRangeTolerance) {
        const double lowered_angle =
            closest - kFullTurn_rad * std::ceil((closest - range.max - kRangeTolerance) / kFullTurn_rad);
        return inside(range, lowered_angle) ? lowered_angle : closest;
    }
    return closest;
}

bool same(const Chain& chain, const rrs::JointPos& a, const rrs::JointPos& b) {
    for (int joint = 0; joint < chain.joint_count(); ++joint) {
        const double difference = a[joint] - b[joint];
        const bool revolute = chain.kind(joint) == rrs::JointKind::revolute;
        if (std::abs(revolute ? std::remainder(difference, kFullTurn_rad) : difference) >= kEqualTolerance)
            return false;
    }
    return true;
}

}  // namespace

std::optional<std::string> find_error(const Chain& chain, const rrs::CartPos& pose,
                                      const rrs::JointPos& near) {
    if (auto valid = check_pose(pose); !valid) return std::move(valid.error());
    if (near.size() == chain.joint_count() && near.allFinite()) return std::nullopt;
    return fmt::format("The joint values near the solution must be {} finite numbers.", chain.joint_count());
}

std::optional<std::string> find_error(const Chain& chain, const std::vector<JointRange>& ranges) {
    if (ranges.empty()) return std::nullopt;
    const bool ordered = std::all_of(ranges.begin(), ranges.end(),
                                     [](const JointRange& range) { return range.min <= range.max; });
    if (ordered && ranges.size() == static_cast<std::size_t>(chain.joint_count())) return std::nullopt;
    return fmt::format("The ranges of the joints must be {}, each with min not greater than max.",
                       chain.joint_count());
}

void unwrap_near(const Chain& chain, const std::vector<JointRange>& ranges, const rrs::JointPos& near,
                 rrs::JointPos& joints) {
    for (int joint = 0; joint < chain.joint_count(); ++joint) {
        if (chain.kind(joint) != rrs::JointKind::revolute) continue;
        const JointRange range = ranges.empty() ? JointRange{} : ranges[static_cast<std::size_t>(joint)];
        joints[joint] = unwrapped_near(range, near[joint], joints[joint]);
    }
}

bool in_range(const std::vector<JointRange>& ranges, const rrs::JointPos& joints) {
    Eigen::Index joint = 0;
    return std::all_of(ranges.begin(), ranges.end(),
                       [&](const JointRange& range) { return inside(range, joints[joint++]); });
}

std::vector<rrs::JointPos> sorted_solutions(const Chain& chain, const std::vector<JointRange>& ranges,
                                            const rrs::JointPos& near, std::vector<Solution> solutions) {
    const auto rank = [&](const Solution& solution) {
        return std::tuple(!in_range(ranges, solution.joints), !solution.exact,
                          (solution.joints - near).squaredNorm());
    };
    std::stable_sort(solutions.begin(), solutions.end(),
                     [&](const Solution& a, const Solution& b) { return rank(a) < rank(b); });
    std::vector<rrs::JointPos> ordered;
    ordered.reserve(solutions.size());
    for (const Solution& solution : solutions) {
        const bool known = std::any_of(ordered.begin(), ordered.end(), [&](const rrs::JointPos& other) {
            return same(chain, other, solution.joints);
        });
        if (!known) ordered.push_back(solution.joints);
    }
    return ordered;
}

}  // namespace gsim::kinematics
