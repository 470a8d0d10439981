#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "controller/services/types.h"

namespace gsim::kinematics {

class Chain;

/// How joint values are found for a pose; gantry: in closed form, numeric: step by step from several starts.
enum class InverseKind { none, gantry, numeric };

/// The range of a joint's value, mm or rad, and its name in sentences: where empty, its index.
struct JointRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::string name = {};
};

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

    /// The joints that the geometry was made of.
    virtual const Chain& chain() const = 0;
    virtual InverseKind inverse_kind() const = 0;
    /// Whether inverse() answers anything but an error.
    bool has_inverse() const { return inverse_kind() != InverseKind::none; }
    virtual int joint_count() const = 0;

    /// Pose of the tool centre point in the work frame (mm) for joint values in mm and rad.
    virtual rrs::CartPos forward(const rrs::JointPos& joints) const = 0;

    /// Joint values that give `pose`: the first of solutions(), or where finding all of them is slow, one
    /// that is close to `near`. The error is a sentence for the user.
    virtual tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                             const rrs::JointPos& near) const = 0;

    /// All joint values that give `pose`, at least one. Those within the joints' ranges come first, and of
    /// them those that reach all of the pose before those that match the tool's axis alone, the nearest to
    /// `near` first. Whole turns of a revolute joint follow `near`, as far as its range lets them; solutions
    /// that differ in whole turns alone count as one.
    virtual tl::expected<std::vector<rrs::JointPos>, std::string> solutions(
        const rrs::CartPos& pose, const rrs::JointPos& near) const = 0;

    /// The joints that line up where the tool has lost a direction to move in, by their indices; empty
    /// elsewhere, and where the inverse does not mind.
    virtual std::vector<int> lined_up(const rrs::JointPos&) const { return {}; }

    /// The joints that inverse() and solutions() leave where `near` has them (groups of axes).
    virtual std::vector<int> held_joints() const { return {}; }

    /// The head that turns the tool, where the machine has such a one.
    virtual std::optional<TiltingHead> tilting_head() const { return std::nullopt; }
};

}  // namespace gsim::kinematics
