#pragma once

#include <array>

#include "collision/pairs/link_motion.h"

namespace gsim::cell {

/// Motion of a machine from an instant of a segment on.
struct MachineMotion {
    const kinematics::Kinematics& kinematics;
    const rrs::CartPos& world;  ///< World of the machine in that of both.
    const motion::Segment& segment;
    double from_s;  ///< Since the start of the segment.

    /// Returns the joint values at a time since that instant; past the end of the segment the machine is at
    /// standstill.
    rrs::JointPos joints_at(double t_s) const;
    /// Returns the travel between two such times.
    JointTravel travel(double from_s, double to_s) const;
};

/// Two machines in one world, both from an instant on. Links and joints of the second are numbered on from
/// those of the first. All arguments must outlive this.
class TwoMachinesMotion final : public LinkMotion {
  public:
    TwoMachinesMotion(const MachineMotion& first, const MachineMotion& second) : machines_{first, second} {}

    LinkFrames links_at(double t_s) const override;

  private:
    MotionPart part(double from_s, const LinkFrames& from, double to_s, const LinkFrames& to) const override;

    std::array<MachineMotion, 2> machines_;
};

}  // namespace gsim::cell
