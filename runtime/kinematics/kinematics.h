#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "runtime/rrs/types.h"

namespace gsim::kinematics {

class DhChain;

/// A head that turns the tool about its tip: one joint turns about an axis that stands still (the pole; the
/// vertical in most machines), the other one, behind it, tilts the tool away from the pole about an axis at
/// right angles to it and to the tool.
struct TiltingHead {
    int turn_joint = 0;
    int tilt_joint = 0;
    double tilt_at_zero_rad = 0;  ///< Angle from the pole to the tool with the tilting joint at 0.
};

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

    /// The head that turns the tool, where the machine has such a one.
    virtual std::optional<TiltingHead> tilting_head() const { return std::nullopt; }
};

}  // namespace gsim::kinematics
