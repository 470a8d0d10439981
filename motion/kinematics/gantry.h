#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "motion/kinematics/dh_chain.h"
#include "motion/kinematics/kinematics.h"
#include "motion/kinematics/rotary_axes.h"
#include "motion/kinematics/screws.h"

namespace gsim::kinematics {

/// Gantry or mill with three prismatic joints in different directions and up to two revolute joints. They
/// come in any order, each on the tool side or the work side. The rotary axes are head-head, head-table or
/// table-table, with the TCP on the rotation point or off it. The inverse is in closed form. The machine,
/// seen from the work, is one product of exponentials (ScrewChain), in which only the revolute joints turn
/// the tool. Once their angles are found (RotaryAxes), the TCP position is a linear function of the three
/// prismatic joints.
class GantryKinematics : public Kinematics {
  public:
    /// Returns the kinematics of a chain if it is such a machine, otherwise a message that names the
    /// obstacle. `ranges` has an entry for each joint, or is empty if no limits apply. A solution in range
    /// comes first if several exist.
    static tl::expected<std::shared_ptr<const GantryKinematics>, std::string> make(
        Chain chain, std::vector<JointRange> ranges = {});

    const Chain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    InverseKind inverse_kind() const override { return InverseKind::gantry; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }

    /// Returns joint values for `pose`. Two rotary axes reach two of three degrees of orientation. A pose
    /// that they can reach exactly is reached exactly. Any other pose has its tool axis (Z) matched; the turn
    /// about it is left to the machine, with the solution nearest to `near`. The first rotary axis keeps its
    /// value in `near` if it is parallel to the wanted tool axis and the pose does not define its position.
    /// Returns an error if the tool axis itself is out of reach by more than 1e-6 rad. Also returns an error
    /// if the rotary axes are positioned so that two slides move in the same direction.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;
    tl::expected<std::vector<rrs::JointPos>, std::string> solutions(const rrs::CartPos& pose,
                                                                    const rrs::JointPos& near) const override;

    /// Returns the head if two rotary axes between the slides and the tool pass through the TCP, at right
    /// angles to each other and the second one to the tool.
    std::optional<TiltingHead> tilting_head() const override;

  private:
    GantryKinematics(Chain chain, std::vector<JointRange> ranges);
    std::optional<std::string> analyze();
    std::optional<rrs::JointPos> joints_at(const rrs::CartPos& target,
                                           const RotaryAxes::Angles& angles) const;

    Chain chain_;
    std::vector<JointRange> ranges_;
    ScrewChain screws_;
    std::vector<int> rotary_joints_;  ///< In the order of the screws.
    RotaryAxes rotary_;
};

}  // namespace gsim::kinematics
