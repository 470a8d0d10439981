#include "collision/cell/machine_bodies.h"

#include <algorithm>
#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/pairs/candidate_pairs.h"
#include "motion/kinematics/chain.h"

namespace gsim::cell {

MachineBodies machine_bodies(const Cell& cell,
                             const std::shared_ptr<const kinematics::Kinematics>& machine_kinematics) {
    MachineBodies machine{placed_kinematics(machine_kinematics, cell.frames), {}};
    const int links = machine.kinematics->chain().joint_count() + 1;
    for (std::size_t item = 0; item < cell.items.size(); ++item) {
        const Role role = cell.items[item].role;
        const Body body = make_body(cell, item);
        const bool is_machine = role == Role::machine || role == Role::jet;
        if (body.link >= links || (body.link == 0 && !is_machine)) continue;
        std::vector<int> joints = joints_to(*machine.kinematics, body.link);
        std::reverse(joints.begin(), joints.end());
        machine.bodies.push_back({item, role, body, std::move(joints)});
    }
    return machine;
}

JointReach joint_reach(const MachineBodies& machine, const rrs::JointPos& joints) {
    const LinkFrames links = link_frames(*machine.kinematics, joints);
    const ChainMotion chain(joint_axes(*machine.kinematics, joints), {});
    JointReach reach_mm{};
    for (const CarriedBody& carried_body : machine.bodies)
        chain.expand(reach_mm, carried_body.body.ball(links), carried_body.joints);
    return reach_mm;
}

}  // namespace gsim::cell
