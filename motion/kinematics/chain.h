#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "controller/services/types.h"

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

/// One joint of a chain and its fixed transformations: `before`, then the joint's motion along or about Z,
/// then `after`.
struct Link {
    int joint = 0;  ///< Index of its value in a JointPos.
    rrs::JointKind kind = rrs::JointKind::prismatic;
    rrs::CartPos before = rrs::CartPos::Identity();
    rrs::CartPos after = rrs::CartPos::Identity();
    std::optional<DhLink> row = std::nullopt;  ///< The row that it was made of, if it was.
};

/// Returns a link for a row of a Denavit-Hartenberg table: all fixed transformations follow the motion.
Link make_link(int joint, const DhLink& row);

/// Joints in sequence: from the world over `base` to the first one, from the last one to `end`.
struct Branch {
    rrs::CartPos base = rrs::CartPos::Identity();
    std::vector<Link> links = {};
    rrs::CartPos end = rrs::CartPos::Identity();
};

/// A machine as two branches from the world: joints that carry the tool, and joints that carry the work. The
/// pose of the tool in programs and services is that of the one end relative to the other. Without joints of
/// the work, and with its frame at the world's, that is the tool in the world. Immutable.
class Chain {
  public:
    /// Takes both branches. The ends are the tool centre point and the work frame. Each joint from 0 up is in
    /// one link, at most kMaxJoints; throws std::invalid_argument otherwise. `idle_joints` are in none: they
    /// are slides that carry neither, such as a filament feed.
    explicit Chain(Branch tool_side, Branch work_side = {}, std::vector<int> idle_joints = {});

    int joint_count() const { return static_cast<int>(kinds_.size()); }
    rrs::JointKind kind(int joint) const { return kinds_[static_cast<std::size_t>(joint)]; }
    const Branch& tool_side() const { return tool_side_; }
    const Branch& work_side() const { return work_side_; }
    const std::vector<int>& idle_joints() const { return idle_joints_; }

    /// Returns the tool centre point in the work frame. `joints` holds joint_count() values.
    rrs::CartPos forward(const rrs::JointPos& joints) const;

    /// Returns frames in the world, two more than the tool's side has links: its base, the end of each link,
    /// the tool.
    std::vector<rrs::CartPos> tool_frames(const rrs::JointPos& joints) const;
    /// Returns the same for the work's side; the last one is the work frame.
    std::vector<rrs::CartPos> work_frames(const rrs::JointPos& joints) const;
    /// Returns a frame in the world for each joint, in the order of their values: the joint moves along or
    /// about its Z. That of an idle joint is the world's.
    std::vector<rrs::CartPos> joint_frames(const rrs::JointPos& joints) const;

  private:
    Branch tool_side_;
    Branch work_side_;
    std::vector<int> idle_joints_;
    std::vector<rrs::JointKind> kinds_;
    bool work_is_world_ = false;
};

/// Returns the same machine, moved completely in the world by `shift`: joints that carry the work move along;
/// without any, the work frame stays at its position.
Chain moved(const Chain& chain, const rrs::CartPos& shift);

}  // namespace gsim::kinematics
