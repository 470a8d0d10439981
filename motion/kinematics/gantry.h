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

/// Three prismatic joints in different directions and up to two revolute joints, in any order, each on the
/// tool's or the work's side: gantries and mills with head-head, head-table or table-table rotary axes, the
/// tip on the rotation point or off it. The inverse is in closed form. Seen from the work the machine is one
/// product of exponentials (ScrewChain), in which the revolute joints alone turn the tool; with their angles
/// found (RotaryAxes), the tip's place is a linear function of the three prismatic joints.
class GantryKinematics : public Kinematics {
  public:
    /// Takes a chain if it is such a machine; otherwise a sentence that says what is in the way. `ranges` of
    /// all joints, or none where there are no limits: of several solutions one in range comes first.
    static tl::expected<std::shared_ptr<const GantryKinematics>, std::string> make(
        Chain chain, std::vector<JointRange> ranges = {});

    const Chain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    InverseKind inverse_kind() const override { return InverseKind::gantry; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }

    /// Two rotary axes reach two of three degrees of orientation. A pose that they reach exactly is reached
    /// exactly; of any other its tool axis (Z) is matched and the turn about it is left to the machine, with
    /// the solution nearest to `near`. Where the first rotary axis is parallel to the wanted tool axis and
    /// the pose does not say where it should stand, it stays at its value in `near`. An error where the tool
    /// axis itself is out of reach by more than 1e-6 rad, or where the rotary axes stand so that two slides
    /// go the same way.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;
    tl::expected<std::vector<rrs::JointPos>, std::string> solutions(const rrs::CartPos& pose,
                                                                    const rrs::JointPos& near) const override;

    /// Where there are two rotary axes between the slides and the tool, through the tip, at right angles to
    /// each other and the second one to the tool.
    std::optional<TiltingHead> tilting_head() const override;

  private:
    GantryKinematics(Chain chain, std::vector<JointRange> ranges);
    std::optional<std::string> study();
    std::optional<rrs::JointPos> joints_at(const rrs::CartPos& target,
                                           const RotaryAxes::Angles& angles) const;

    Chain chain_;
    std::vector<JointRange> ranges_;
    ScrewChain screws_;
    std::vector<int> rotary_joints_;  ///< In the order of the screws.
    RotaryAxes rotary_;
};

}  // namespace gsim::kinematics
