#include "collision/pairs/two_machines_motion.h"

#include <algorithm>
#include <utility>

namespace gsim::cell {

namespace {

ChainMotion make_chain_motion(const MachineMotion& machine, double from_s, double to_s) {
    std::vector<JointAxis> axes = joint_axes(machine.kinematics, machine.joints_at(from_s));
    for (JointAxis& axis : axes) {
        axis.point_mm = machine.world * axis.point_mm;
        axis.direction = machine.world.linear() * axis.direction;
    }
    return {std::move(axes), machine.travel(from_s, to_s)};
}

double clamp_to_segment(const motion::Segment& segment, double t_s) {
    return std::clamp(t_s, 0.0, segment.duration_s);
}

}  // namespace

rrs::JointPos MachineMotion::joints_at(double t_s) const {
    return segment.position_at(clamp_to_segment(segment, from_s + t_s));
}

JointTravel MachineMotion::travel(double begin_s, double end_s) const {
    constexpr bool kOverTime = true;  // the other machine moves by different laws
    return joint_travel(segment, clamp_to_segment(segment, from_s + begin_s),
                        clamp_to_segment(segment, from_s + end_s), kOverTime);
}

LinkFrames TwoMachinesMotion::links_at(double t_s) const {
    LinkFrames all;
    for (const MachineMotion& machine : machines_) {
        const LinkFrames links = link_frames(machine.kinematics, machine.joints_at(t_s));
        all.reserve(2 * links.size());
        for (const rrs::CartPos& link : links) all.push_back(machine.world * link);
    }
    return all;
}

MotionPart TwoMachinesMotion::part(double from_s, const LinkFrames& from, double to_s,
                                   const LinkFrames& to) const {
    return {from_s, to_s, from, to,
            ChainMotion(make_chain_motion(machines_[0], from_s, to_s),
                        make_chain_motion(machines_[1], from_s, to_s))};
}

}  // namespace gsim::cell
