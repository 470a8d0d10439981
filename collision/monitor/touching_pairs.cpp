#include "collision/monitor/touching_pairs.h"

#include "collision/cell/placed_kinematics.h"

namespace gsim::cell {

std::vector<ItemPair> touching_pairs(const Cell& cell, const machine::Machine& machine,
                                     const rrs::JointPos& joints) {
    const auto kinematics = placed_kinematics(machine::make_kinematics(machine), cell.frames);
    const LinkFrames links = link_frames(*kinematics, joints);
    std::vector<ItemPair> touching;
    for (const CandidatePair& pair : candidate_pairs(cell, *kinematics)) {
        if (!pair.includes_jet && pair.bodies.are_in_contact(links)) touching.push_back(pair.items);
    }
    return touching;
}

}  // namespace gsim::cell
