#pragma once

#include <utility>

#include "motion/kinematics/dh_chain.h"
#include "motion/kinematics/kinematics.h"

namespace gsim::kinematics {

/// The kinematics of any chain: forward only.
class ChainKinematics : public Kinematics {
  public:
    explicit ChainKinematics(Chain chain) : chain_(std::move(chain)) {}

    const Chain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    InverseKind inverse_kind() const override { return InverseKind::none; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }
    /// Returns always the error that this machine has no inverse.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;
    tl::expected<std::vector<rrs::JointPos>, std::string> solutions(const rrs::CartPos& pose,
                                                                    const rrs::JointPos& near) const override;

  private:
    Chain chain_;
};

}  // namespace gsim::kinematics
