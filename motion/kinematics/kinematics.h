#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "controller/services/types.h"

namespace gsim::kinematics {

class Chain;

/// Method that finds joint values for a pose; gantry: in closed form, numeric: step by step from several
/// starts.
enum class InverseKind { none, gantry, numeric };

/// Range of a joint's value, mm or rad, and its name in messages. An empty name means its index.
struct JointRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::string name = {};
};

/// Head that turns the tool about the TCP. One joint turns about a fixed axis (the pole; vertical in most
/// machines). The other joint, further along the chain, tilts the tool away from the pole about an axis at
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

    /// Returns the joints from which the geometry was made.
    virtual const Chain& chain() const = 0;
    virtual InverseKind inverse_kind() const = 0;
    /// True if inverse() can return anything but an error.
    bool has_inverse() const { return inverse_kind() != InverseKind::none; }
    virtual int joint_count() const = 0;

    /// Returns the pose of the TCP in the work frame (mm) for joint values in mm and rad.
    virtual rrs::CartPos forward(const rrs::JointPos& joints) const = 0;

    /// Returns joint values that give `pose`: the first of solutions(), or one close to `near` if finding all
    /// of them is slow. The error is a message for the user.
    virtual tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                             const rrs::JointPos& near) const = 0;

    /// Returns all joint values that give `pose`, at least one. Solutions within the joint ranges come first.
    /// Among them, those that reach the full pose come before those that match only the tool axis, the
    /// nearest to `near` first. Full turns of a revolute joint follow `near` as far as its range allows.
    /// Solutions that differ only in full turns count as one.
    virtual tl::expected<std::vector<rrs::JointPos>, std::string> solutions(
        const rrs::CartPos& pose, const rrs::JointPos& near) const = 0;

    /// Returns the indices of the joints that line up if the tool has lost a direction to move in. Returns an
    /// empty list elsewhere, and if that does not affect the inverse.
    virtual std::vector<int> aligned_joints(const rrs::JointPos&) const { return {}; }

    /// Returns the joints that inverse() and solutions() keep at their values in `near` (groups of axes).
    virtual std::vector<int> fixed_joints() const { return {}; }

    /// Returns the head that turns the tool, if the machine has one.
    virtual std::optional<TiltingHead> tilting_head() const { return std::nullopt; }
};

}  // namespace gsim::kinematics
