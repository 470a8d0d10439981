#pragma once

#include <string>

#include <tl/expected.hpp>

#include "runtime/rrs/types.h"

namespace gsim::kinematics {

class DhChain;

/// The geometry of one machine: joints to tool pose and back. Immutable.
class Kinematics {
  public:
    virtual ~Kinematics() = default;

    /// The chain of joints that the geometry was made of.
    virtual const DhChain& chain() const = 0;
    /// Whether inverse() answers anything but an error.
    virtual bool has_inverse() const = 0;
    virtual int joint_count() const = 0;

    /// Pose of the tool centre point in the world frame (mm) for joint values in mm and rad.
    virtual rrs::CartPos forward(const rrs::JointPos& joints) const = 0;

    /// Joint values that give `pose`, of all solutions the one nearest to `near`; joint ranges are not looked
    /// at, but for whole turns of a revolute joint, which follow `near`. The error is a sentence for the
    /// user.
    virtual tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                             const rrs::JointPos& near) const = 0;
};

}  // namespace gsim::kinematics
