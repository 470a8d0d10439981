#include "motion/kinematics/numeric_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/units.h"
#include "motion/kinematics/solution.h"
#include "motion/kinematics/symmetric_solver.h"

namespace gsim::kinematics {

namespace {

constexpr int kStartCount = 64;
constexpr int kSteps = 100;
constexpr double kPositionTolerance_mm = 1e-9;
constexpr double kOrientationTolerance_rad = 1e-10;
constexpr double kSingularTolerance = 1e-6;  // mm and rad, at singular configurations
constexpr int kMaxStalledSteps = 12;         // steps that gain too little
constexpr double kGain = 0.01;               // what a step should gain of the error
constexpr double kMinFineGain = 1e-6;
constexpr double kSingular = 1e-6;  // singular values
constexpr double kNearlySingular = 1e-2;
constexpr double kDamping = 0.05;  // of the squared error, without unit
constexpr double kMinDamping = 1e-14;

// Quasirandom sequence that fills a space of d dimensions evenly (Roberts 2018, "the unreasonable
// effectiveness of quasirandom sequences"): the fractional parts of a start's number times the powers of the
// root of x^(d+1) = x + 1.
double quasi_random(int number, int dimension, int dimensions) {
    double root = 2;
    for (int i = 0; i < 32; ++i) root = std::pow(1 + root, 1.0 / (dimensions + 1));
    const double value = 0.5 + number * std::pow(root, -(dimension + 1));
    return value - std::floor(value);
}

bool within(const Twist& remaining, double mm, double rad) {
    return remaining.head<3>().norm() <= mm && remaining.tail<3>().norm() <= rad;
}

rrs::JointPos clamp_to_ranges(const std::vector<JointRange>& ranges, rrs::JointPos joints) {
    Eigen::Index joint = 0;
    for (const JointRange& range : ranges) {
        joints[joint] = std::clamp(joints[joint], range.min, range.max);
        ++joint;
    }
    return joints;
}

}  // namespace

NumericKinematics::NumericKinematics(Chain chain, std::vector<JointRange> ranges, std::vector<int> fixed)
    : chain_(std::move(chain)),
      ranges_(std::move(ranges)),
      fixed_joints_(std::move(fixed)),
      mm_per_rad_(mm_per_rad(chain_)) {
    unlimited_ranges_.resize(static_cast<std::size_t>(chain_.joint_count()));
    if (ranges_.empty()) ranges_ = unlimited_ranges_;
}

tl::expected<std::shared_ptr<const NumericKinematics>, std::string> NumericKinematics::make(
    Chain chain, std::vector<JointRange> ranges, std::vector<int> fixed) {
    if (auto error = find_error(chain, ranges)) return tl::unexpected(*std::move(error));
    if (chain.joint_count() == 0)
        return tl::unexpected<std::string>("The numeric inverse needs a chain with at least one joint.");
    if (!chain.forward(rrs::JointPos::Zero(chain.joint_count())).matrix().allFinite())
        return tl::unexpected<std::string>("The kinematic chain contains a value that is not finite.");
    return std::shared_ptr<const NumericKinematics>(
        new NumericKinematics(std::move(chain), std::move(ranges), std::move(fixed)));
}

bool NumericKinematics::is_fixed(int joint) const {
    return std::find(fixed_joints_.begin(), fixed_joints_.end(), joint) != fixed_joints_.end();
}

// Start 0 is the current position of the machine. The others are spread over the ranges, but over no more
// than a turn of a revolute joint. A slide without limits is spread over no more than the chain's reach about
// `near`.
rrs::JointPos NumericKinematics::start(int number, const rrs::JointPos& near) const {
    rrs::JointPos joints = clamp_to_ranges(ranges_, near);
    if (number == 0) return joints;
    for (int i = 0; i < joint_count(); ++i) {
        if (is_fixed(i)) continue;
        const JointRange& range = ranges_[static_cast<std::size_t>(i)];
        const bool revolute = chain_.kind(i) == rrs::JointKind::revolute;
        const double half = revolute ? std::numbers::pi : mm_per_rad_;
        const double middle = std::clamp(revolute ? 0.0 : near[i], range.min + half,
                                         std::max(range.min + half, range.max - half));
        const double low = std::max(range.min, middle - half);
        const double high = std::min(range.max, middle + half);
        joints[i] = low + quasi_random(number, i, joint_count()) * (high - low);
    }
    return joints;
}

double NumericKinematics::size(const Twist& remaining) const {
    return std::hypot(remaining.head<3>().norm() / mm_per_rad_, remaining.tail<3>().norm());
}

// Damped least squares in units in which the joint columns have size 1. A joint that would move beyond the
// end of its range is held, and the others are solved again.
rrs::JointPos NumericKinematics::step(const Configuration& configuration, const Twist& remaining,
                                      const rrs::JointPos& joints,
                                      const std::vector<JointRange>& ranges) const {
    Jacobian scaled = configuration.jacobian;
    rrs::JointPos unit(joints.size());
    scaled.topRows<3>() /= mm_per_rad_;
    for (int i = 0; i < joint_count(); ++i) {
        unit[i] = chain_.kind(i) == rrs::JointKind::prismatic ? mm_per_rad_ : 1;
        scaled.col(i) *= is_fixed(i) ? 0 : unit[i];
    }
    Twist goal = remaining;
    goal.head<3>() /= mm_per_rad_;
    const double damping = kMinDamping + kDamping * goal.squaredNorm();
    rrs::JointPos change(joints.size());
    for (int round = 0; round <= joint_count(); ++round) {
        // Eigen's product is for large matrices, which these are not, and would cost a second of each build.
        JointMatrix normal = scaled.transpose().lazyProduct(scaled);
        normal.diagonal().array() += damping;
        change = solve_symmetric(normal, scaled.transpose().lazyProduct(goal));
        bool fixed = false;
        for (Eigen::Index i = 0; i < joints.size(); ++i) {
            const JointRange& range = ranges[static_cast<std::size_t>(i)];
            const bool blocked =
                (joints[i] <= range.min && change[i] < 0) || (joints[i] >= range.max && change[i] > 0);
            if (!blocked) continue;
            scaled.col(i).setZero();
            fixed = true;
        }
        if (!fixed) break;
    }
    return clamp_to_ranges(ranges, joints + change.cwiseProduct(unit));
}

NumericKinematics::Attempt NumericKinematics::search(const rrs::CartPos& pose, const rrs::JointPos& from,
                                                     const std::vector<JointRange>& ranges,
                                                     double min_gain) const {
    Attempt best;
    best.joints = from;
    rrs::JointPos joints = from;
    int stalled_steps = 0;
    for (int i = 0; i < kSteps && stalled_steps < kMaxStalledSteps; ++i) {
        const Configuration current = configuration(chain_, joints);
        const Twist remaining = twist_to_pose(current, pose);
        const double error = size(remaining);
        if (!std::isfinite(error)) break;
        stalled_steps = error < (1 - min_gain) * best.error ? 0 : stalled_steps + 1;
        if (error < best.error) {
            best.joints = joints;
            best.remaining = remaining;
            best.error = error;
        }
        if (within(best.remaining, kPositionTolerance_mm, kOrientationTolerance_rad)) break;
        joints = step(current, remaining, joints, ranges);
    }
    best.reached =
        std::isfinite(best.error) && within(best.remaining, kSingularTolerance, kSingularTolerance);
    return best;
}

// Ends of ranges obstruct a search. It first ignores them, because full turns may bring a solution beyond an
// end back into range.
NumericKinematics::Attempt NumericKinematics::attempt(const rrs::CartPos& pose, const rrs::JointPos& from,
                                                      const rrs::JointPos& near) const {
    Attempt unconstrained = search(pose, from, unlimited_ranges_, kGain);
    unwrap_near(chain_, ranges_, near, unconstrained.joints);
    if (in_range(ranges_, unconstrained.joints)) return unconstrained;
    Attempt fixed = search(pose, from, ranges_, kGain);
    unwrap_near(chain_, ranges_, near, fixed.joints);
    return fixed;
}

std::optional<std::string> NumericKinematics::find_fixed_joint_error(const rrs::JointPos& near) const {
    for (const int joint : fixed_joints_) {
        const JointRange& range = ranges_[static_cast<std::size_t>(joint)];
        if (near[joint] >= range.min - kPositionTolerance_mm &&
            near[joint] <= range.max + kPositionTolerance_mm)
            continue;
        const bool is_prismatic = chain_.kind(joint) == rrs::JointKind::prismatic;
        const double unit = is_prismatic ? 1 : kDegPerRad;
        return fmt::format(
            "The pose is out of reach: {} would be at {:.6g} {}, outside its range {:.6g} .. {:.6g}.",
            names({joint}), near[joint] * unit, is_prismatic ? "mm" : "deg", range.min * unit,
            range.max * unit);
    }
    return std::nullopt;
}

tl::expected<rrs::JointPos, std::string> NumericKinematics::inverse(const rrs::CartPos& pose,
                                                                    const rrs::JointPos& near) const {
    if (auto error = find_error(chain_, pose, near)) return tl::unexpected(*std::move(error));
    if (auto error = find_fixed_joint_error(near)) return tl::unexpected(*std::move(error));
    Attempt best;
    for (int number = 0; number < kStartCount; ++number) {
        Attempt next = attempt(pose, start(number, near), near);
        if (next.reached) return next.joints;
        if (next.error < best.error) best = std::move(next);
    }
    return tl::unexpected(out_of_reach_message(pose, best));
}

tl::expected<std::vector<rrs::JointPos>, std::string> NumericKinematics::solutions(
    const rrs::CartPos& pose, const rrs::JointPos& near) const {
    if (auto error = find_error(chain_, pose, near)) return tl::unexpected(*std::move(error));
    if (auto error = find_fixed_joint_error(near)) return tl::unexpected(*std::move(error));
    std::vector<Solution> found;
    Attempt best;
    for (int number = 0; number < kStartCount; ++number) {
        Attempt next = attempt(pose, start(number, near), near);
        if (next.reached) {
            found.push_back({.joints = next.joints, .exact = true});
        } else if (next.error < best.error) {
            best = std::move(next);
        }
    }
    if (found.empty()) return tl::unexpected(out_of_reach_message(pose, best));
    return sorted_solutions(chain_, ranges_, near, std::move(found));
}

std::vector<int> NumericKinematics::aligned_joints(const rrs::JointPos& joints) const {
    return aligned_joints(joints, kSingular);
}

// Held joints do not compensate for joints that line up.
std::vector<int> NumericKinematics::aligned_joints(const rrs::JointPos& joints, double threshold) const {
    Configuration current = configuration(chain_, joints);
    std::vector<int> moved;
    for (int i = 0; i < joint_count(); ++i) {
        if (is_fixed(i)) continue;
        current.jacobian.col(static_cast<Eigen::Index>(moved.size())) = current.jacobian.col(i);
        moved.push_back(i);
    }
    current.jacobian.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(moved.size()));
    std::vector<int> found = kinematics::aligned_joints(current, mm_per_rad_, threshold);
    for (int& joint : found) joint = moved[static_cast<std::size_t>(joint)];
    return found;
}

std::string NumericKinematics::names(const std::vector<int>& joints) const {
    std::vector<std::string> list;
    list.reserve(joints.size());
    for (const int joint : joints) {
        const std::string& name = ranges_[static_cast<std::size_t>(joint)].name;
        list.push_back(name.empty() ? fmt::format("joint {}", joint) : fmt::format("axis {}", name));
    }
    return text::joined(list, " and ");
}

std::string NumericKinematics::out_of_reach_message(const rrs::CartPos& pose, const Attempt& nearest) const {
    if (!std::isfinite(nearest.error)) return "The pose is out of reach: it is too far away to be computed.";
    const Attempt best = search(pose, nearest.joints, ranges_, kMinFineGain);
    std::string message = fmt::format(
        "The pose is out of reach: the nearest pose of the joints is {:.6g} mm and {:.6g} deg off",
        best.remaining.head<3>().norm(), best.remaining.tail<3>().norm() * kDegPerRad);
    std::vector<int> at_end;
    for (int i = 0; i < joint_count(); ++i) {
        const JointRange& range = ranges_[static_cast<std::size_t>(i)];
        if (is_fixed(i)) continue;
        if (best.joints[i] <= range.min || best.joints[i] >= range.max) at_end.push_back(i);
    }
    const std::vector<int> aligned = aligned_joints(best.joints, kNearlySingular);
    if (!at_end.empty()) message += fmt::format(", with {} at a limit of the range", names(at_end));
    if (!aligned.empty()) message += fmt::format(", with {} aligned", names(aligned));
    return message + ".";
}

}  // namespace gsim::kinematics
