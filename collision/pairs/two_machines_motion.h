#pragma once

#include <array>

#include "collision/pairs/link_motion.h"

namespace gsim::cell {

/// How a machine goes on from an instant of a segment.
struct MachineStretch {
    const kinematics::Kinematics& kinematics;
    const rrs::CartPos& world;  ///< Of the machine, in the world of both.
    const motion::Segment& segment;
    double from_s;  ///< Since the start of the segment.

    /// At a time since that instant; where the segment has ended the machine stands.
    rrs::JointPos joints_at(double t_s) const;
    /// Between two such times.
    JointTravel travel(double from_s, double to_s) const;
};

/// Two machines in one world, both from an instant on. The links of the second are numbered behind those of
/// the first, and so are its joints. All must outlive this.
class TwoMachinesMotion final : public LinkMotion {
  public:
    TwoMachinesMotion(const MachineStretch& first, const MachineStretch& second) : machines_{first, second} {}

    LinkFrames links_at(double t_s) const override;

  private:
    MotionPart part(double from_s, const LinkFrames& from, double to_s, const LinkFrames& to) const override;

    std::array<MachineStretch, 2> machines_;
};

}  // namespace gsim::cell
