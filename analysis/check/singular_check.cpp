#include "analysis/check/singular_check.h"

#include <algorithm>
#include <memory>

#include "base/dense/singular.h"
#include "motion/kinematics/jacobian.h"

namespace gsim::check {

namespace {

constexpr double kSingularityLimit = 0.01;
constexpr double kRankTolerance = 1e-9;     // a direction in which the tool never moves
constexpr double kMinParticipation = 0.05;  // as in kinematics::aligned_joints()
constexpr int kSteps = 720;                 // of one joint's range
constexpr int kSamplesPerStep = 8;          // configurations of the other joints, at each step
constexpr int kConfigurations = 2000;

/// Amount by which the joints move the tool, in the direction in which they can do so least.
struct WeakestDirection {
    double value;
    Eigen::VectorXd parts;  ///< Parts of the joints that then move against each other.
};

class ConfigurationSampler {
  public:
    ConfigurationSampler(const machine::Machine& machine, const machine::JointBox& box)
        : kinematics_(machine::make_kinematics(machine)),
          chain_(kinematics_->chain()),
          mm_per_rad_(kinematics::mm_per_rad(chain_)),
          box_(box) {
        for (int number = 1; number <= kSamplesPerStep; ++number)
            directions_ = std::max(directions_, rank(sample(number)));
    }

    int joints() const { return chain_.joint_count(); }
    rrs::JointPos sample(int number) const { return box_.at(machine::halton_point(number, joints())); }

    WeakestDirection smallest_singular_value(const rrs::JointPos& at) const {
        if (directions_ == 0) return {1, {}};
        const base::SingularValues singular = base::singular_values(scaled(at));
        return {singular.values[directions_ - 1], singular.right.col(directions_ - 1).cwiseAbs()};
    }
    bool is_near(const rrs::JointPos& at) const {
        return smallest_singular_value(at).value < kSingularityLimit;
    }

  private:
    // Returns rows: three of the TCP's speed, in reaches; three of its rotation, or two without that about
    // the tool.
    Eigen::MatrixXd scaled(const rrs::JointPos& at) const {
        const kinematics::Configuration configuration = kinematics::configuration(chain_, at);
        const Eigen::Matrix3d to_tool = configuration.tool.linear().transpose();
        const int turns = joints() > 5 ? 3 : 2;
        Eigen::MatrixXd matrix(3 + turns, joints());
        matrix.topRows(3) = configuration.jacobian.topRows<3>() / mm_per_rad_;
        matrix.bottomRows(turns) = (to_tool * configuration.jacobian.bottomRows<3>()).topRows(turns);
        for (int joint = 0; joint < joints(); ++joint) {
            if (chain_.kind(joint) == rrs::JointKind::prismatic) matrix.col(joint) *= mm_per_rad_;
        }
        return matrix;
    }

    int rank(const rrs::JointPos& at) const {
        return static_cast<int>((base::singular_values(scaled(at)).values.array() > kRankTolerance).count());
    }

    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    const kinematics::Chain& chain_;
    double mm_per_rad_;
    const machine::JointBox& box_;
    int directions_ = 0;  ///< Possible directions of the tool, in most configurations.
};

bool is_singular_for_all_samples(const ConfigurationSampler& configurations, int joint, double value) {
    for (int number = 1; number <= kSamplesPerStep; ++number) {
        rrs::JointPos at = configurations.sample(number);
        at[joint] = value;
        if (!configurations.is_near(at)) return false;
    }
    return true;
}

std::vector<int> aligned_joints(const ConfigurationSampler& configurations, int joint, double value) {
    rrs::JointPos at = configurations.sample(1);
    at[joint] = value;
    const Eigen::VectorXd parts = configurations.smallest_singular_value(at).parts;
    std::vector<int> joints;
    for (int i = 0; i < configurations.joints(); ++i) {
        if (parts[i] > kMinParticipation * parts.maxCoeff()) joints.push_back(i);
    }
    return joints;
}

void add_ranges(const ConfigurationSampler& configurations, const machine::JointBox& box, int joint,
                std::vector<SingularRange>& ranges) {
    const double width = box.high[joint] - box.low[joint];
    if (!(width > 0)) return;
    bool open = false;
    for (int step = 0; step <= kSteps; ++step) {
        const double value = box.low[joint] + width * step / kSteps;
        const bool near = is_singular_for_all_samples(configurations, joint, value);
        if (near && !open) ranges.push_back({joint, value, value, {}});
        if (near) ranges.back().high = value;
        open = near;
    }
}

}  // namespace

SingularCheck check_singular(const machine::Machine& machine, const machine::JointBox& box) {
    SingularCheck check;
    const ConfigurationSampler configurations(machine, box);
    for (int joint = 0; joint < configurations.joints(); ++joint) {
        const std::size_t before = check.ranges.size();
        if (machine.axes[static_cast<std::size_t>(joint)].kind == machine::AxisKind::rotary)
            add_ranges(configurations, box, joint, check.ranges);
        for (std::size_t i = before; i < check.ranges.size(); ++i) {
            SingularRange& range = check.ranges[i];
            range.aligned_joints = aligned_joints(configurations, joint, (range.low + range.high) / 2);
        }
    }
    int near = 0;
    for (int number = 1; number <= kConfigurations; ++number)
        near += configurations.is_near(configurations.sample(number)) ? 1 : 0;
    check.near_share = static_cast<double>(near) / kConfigurations;
    check.at_home = configurations.is_near(machine::home_position(machine));
    return check;
}

}  // namespace gsim::check
