#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "motion/kinematics/chain.h"
#include "motion/kinematics/jacobian.h"
#include "motion/kinematics/kinematics.h"

namespace gsim::kinematics {

/// Inverse of any chain by damped least squares (Wampler 1986; Nakamura and Hanafusa 1986). The damping falls
/// with the square of the remaining error (Sugihara 2011). The search runs from several starts in the joint
/// ranges: first as if they had no ends, then held within them. A pose always means both position and
/// orientation.
class NumericKinematics : public Kinematics {
  public:
    /// Returns the kinematics of a chain. `ranges` has an entry for each joint, or is empty if no limits
    /// apply. `fixed` lists the indices of the joints that no search moves. The error is a message.
    static tl::expected<std::shared_ptr<const NumericKinematics>, std::string> make(
        Chain chain, std::vector<JointRange> ranges = {}, std::vector<int> fixed = {});

    const Chain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    InverseKind inverse_kind() const override { return InverseKind::numeric; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }

    /// Returns the solution that the search from `near` finds, which mostly is the nearest one, otherwise the
    /// first that another start finds. Solutions are within the ranges, to 1e-9 mm and 1e-10 rad, at singular
    /// configurations to 1e-6. The error reports how far the pose is out of reach. It also reports the joints
    /// that line up at the end of the search, by their names or by their indices.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;
    /// Returns the results of a fixed number of starts. An arm with six joints gets all solutions, unless two
    /// are close together. An arm with more joints has infinitely many solutions and gets some.
    tl::expected<std::vector<rrs::JointPos>, std::string> solutions(const rrs::CartPos& pose,
                                                                    const rrs::JointPos& near) const override;

    std::vector<int> aligned_joints(const rrs::JointPos& joints) const override;
    std::vector<int> fixed_joints() const override { return fixed_joints_; }

  private:
    struct Attempt {
        rrs::JointPos joints;
        Twist remaining = Twist::Zero();                         ///< Remaining error, mm and rad.
        double error = std::numeric_limits<double>::infinity();  ///< Its size, lengths in mm_per_rad_.
        bool reached = false;
    };

    NumericKinematics(Chain chain, std::vector<JointRange> ranges, std::vector<int> fixed);
    bool is_fixed(int joint) const;
    std::optional<std::string> find_fixed_joint_error(const rrs::JointPos& near) const;
    std::vector<int> aligned_joints(const rrs::JointPos& joints, double threshold) const;
    rrs::JointPos start(int number, const rrs::JointPos& near) const;
    double size(const Twist& remaining) const;
    rrs::JointPos step(const Configuration& configuration, const Twist& remaining,
                       const rrs::JointPos& joints, const std::vector<JointRange>& ranges) const;
    Attempt search(const rrs::CartPos& pose, const rrs::JointPos& from, const std::vector<JointRange>& ranges,
                   double min_gain) const;
    Attempt attempt(const rrs::CartPos& pose, const rrs::JointPos& from, const rrs::JointPos& near) const;
    std::string names(const std::vector<int>& joints) const;
    std::string out_of_reach_message(const rrs::CartPos& pose, const Attempt& best) const;

    Chain chain_;
    std::vector<JointRange> ranges_;
    std::vector<JointRange> unlimited_ranges_;  ///< As many without ends.
    std::vector<int> fixed_joints_;
    double mm_per_rad_ = 1;
};

}  // namespace gsim::kinematics
