#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/kinematics/kinematics.h"
#include "runtime/rrs/types.h"

namespace gsim::kinematics {

/// One row of a Denavit-Hartenberg table in the standard convention, Rz(theta) Tz(d) Tx(a) Rx(alpha). The
/// joint's value is added to d (prismatic) or to theta (revolute).
struct DhLink {
    rrs::JointKind kind = rrs::JointKind::prismatic;
    double theta_rad = 0;
    double d_mm = 0;
    double a_mm = 0;
    double alpha_rad = 0;
};

/// A serial chain of Denavit-Hartenberg links between a base frame (world to the first joint) and a tool
/// frame (last link to the tool centre point). Immutable.
class DhChain {
  public:
    /// At most kMaxJoints links; throws std::invalid_argument beyond.
    DhChain(const rrs::CartPos& base, const std::vector<DhLink>& links, const rrs::CartPos& tool);

    int joint_count() const { return static_cast<int>(joints_.size()); }
    rrs::JointKind kind(int joint) const { return joints_[static_cast<std::size_t>(joint)].kind; }
    /// What the chain was made of.
    const rrs::CartPos& base() const { return base_; }
    const std::vector<DhLink>& links() const { return links_; }
    const rrs::CartPos& tool() const { return tool_; }

    /// The tool centre point in the world. `joints` holds joint_count() values.
    rrs::CartPos forward(const rrs::JointPos& joints) const;

    /// joint_count() + 2 frames in the world: the base, the frame of each link behind its joint, the tool.
    /// Joint i moves along or about the Z axis of frame i.
    std::vector<rrs::CartPos> frames(const rrs::JointPos& joints) const;

  private:
    struct Joint {
        rrs::JointKind kind;
        rrs::CartPos link;  // the row at joint value 0
    };

    rrs::CartPos base_;
    std::vector<DhLink> links_;
    std::vector<Joint> joints_;
    rrs::CartPos tool_;
};

/// The kinematics of any serial chain: forward only.
class ChainKinematics : public Kinematics {
  public:
    explicit ChainKinematics(DhChain chain) : chain_(std::move(chain)) {}

    const DhChain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    bool has_inverse() const override { return false; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }
    /// Always the error that this machine has no inverse.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;

  private:
    DhChain chain_;
};

}  // namespace gsim::kinematics
