#include "analysis/check/singular_check.h"

#include <algorithm>
#include <memory>

#include "base/dense/singular.h"
#include "motion/kinematics/jacobian.h"

namespace gsim::check {

namespace {

constexpr double kNear = 0.01;
constexpr double kNone = 1e-9;       // a direction in which the tool never moves
constexpr double kTakesPart = 0.05;  // as in kinematics::lined_up()
constexpr int kSteps = 720;          // of one joint's range
constexpr int kOthers = 8;           // configurations of the other joints, at each step
constexpr int kStances = 2000;

/// Amount by which the joints move the tool, in the direction in which they can do so least.
struct Least {
    double value;
    Eigen::VectorXd parts;  ///< Parts of the joints that then move against each other.
};

class Stances {
  public:
    Stances(const machine::Machine& machine, const machine::JointBox& box)
        : kinematics_(machine::make_kinematics(machine)),
          chain_(kinematics_->chain()),
          mm_per_rad_(kinematics::mm_per_rad(chain_)),
          box_(box) {
        for (int number = 1; number <= kOthers; ++number)
            directions_ = std::max(directions_, rank(sample(number)));
    }

    int joints() const { return chain_.joint_count(); }
    rrs::JointPos sample(int number) const { return box_.at(machine::halton_point(number, joints())); }

    Least least(const rrs::JointPos& at) const {
        if (directions_ == 0) return {1, {}};
        const base::SingularValues singular = base::singular_values(scaled(at));
        return {singular.values[directions_ - 1], singular.right.col(directions_ - 1).cwiseAbs()};
    }
    bool is_near(const rrs::JointPos& at) const { return least(at).value < kNear; }

  private:
    // Returns rows: three of the TCP's speed, in reaches; three of its rotation, or two without that about
    // the tool.
    Eigen::MatrixXd scaled(const rrs::JointPos& at) const {
        const kinematics::Stance stance = kinematics::stance(chain_, at);
        const Eigen::Matrix3d to_tool = stance.tool.linear().transpose();
        const int turns = joints() > 5 ? 3 : 2;
        Eigen::MatrixXd matrix(3 + turns, joints());
        matrix.topRows(3) = stance.jacobian.topRows<3>() / mm_per_rad_;
        matrix.bottomRows(turns) = (to_tool * stance.jacobian.bottomRows<3>()).topRows(turns);
        for (int joint = 0; joint < joints(); ++joint) {
            if (chain_.kind(joint) == rrs::JointKind::prismatic) matrix.col(joint) *= mm_per_rad_;
        }
        return matrix;
    }

    int rank(const rrs::JointPos& at) const {
        return static_cast<int>((base::singular_values(scaled(at)).values.array() > kNone).count());
    }

    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    const kinematics::Chain& chain_;
    double mm_per_rad_;
    const machine::JointBox& box_;
    int directions_ = 0;  ///< Possible directions of the tool, in most configurations.
};

bool is_near_whatever_the_others(const Stances& stances, int joint, double value) {
    for (int number = 1; number <= kOthers; ++number) {
        rrs::JointPos at = stances.sample(number);
        at[joint] = value;
        if (!stances.is_near(at)) return false;
    }
    return true;
}

std::vector<int> lined_up(const Stances& stances, int joint, double value) {
    rrs::JointPos at = stances.sample(1);
    at[joint] = value;
    const Eigen::VectorXd parts = stances.least(at).parts;
    std::vector<int> joints;
    for (int i = 0; i < stances.joints(); ++i) {
        if (parts[i] > kTakesPart * parts.maxCoeff()) joints.push_back(i);
    }
    return joints;
}

void add_ranges(const Stances& stances, const machine::JointBox& box, int joint,
                std::vector<SingularRange>& ranges) {
    const double width = box.high[joint] - box.low[joint];
    if (!(width > 0)) return;
    bool open = false;
    for (int step = 0; step <= kSteps; ++step) {
        const double value = box.low[joint] + width * step / kSteps;
        const bool near = is_near_whatever_the_others(stances, joint, value);
        if (near && !open) ranges.push_back({joint, value, value, {}});
        if (near) ranges.back().high = value;
        open = near;
    }
}

}  // namespace

SingularCheck check_singular(const machine::Machine& machine, const machine::JointBox& box) {
    SingularCheck check;
    const Stances stances(machine, box);
    for (int joint = 0; joint < stances.joints(); ++joint) {
        const std::size_t before = check.ranges.size();
        if (machine.axes[static_cast<std::size_t>(joint)].kind == machine::AxisKind::rotary)
            add_ranges(stances, box, joint, check.ranges);
        for (std::size_t i = before; i < check.ranges.size(); ++i) {
            SingularRange& range = check.ranges[i];
            range.lined_up = lined_up(stances, joint, (range.low + range.high) / 2);
        }
    }
    int near = 0;
    for (int number = 1; number <= kStances; ++number)
        near += stances.is_near(stances.sample(number)) ? 1 : 0;
    check.near_share = static_cast<double>(near) / kStances;
    check.at_home = stances.is_near(machine::home_position(machine));
    return check;
}

}  // namespace gsim::check
