#pragma once

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

inline KDL::Frame to_kdl(const rrs::CartPos& pose) {
    const Eigen::Matrix3d r = pose.linear();
    return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
            KDL::Vector(pose.translation().x(), pose.translation().y(), pose.translation().z())};
}

inline rrs::CartPos from_kdl(const KDL::Frame& frame) {
    rrs::CartPos pose = rrs::CartPos::Identity();
    for (int row = 0; row < 3; ++row) {
        pose.translation()[row] = frame.p[row];
        for (int column = 0; column < 3; ++column) pose.linear()(row, column) = frame.M(row, column);
    }
    return pose;
}

inline KDL::Segment fixed(const rrs::CartPos& pose) {
    return KDL::Segment(KDL::Joint(KDL::Joint::None), to_kdl(pose));
}

/// Adds a link in KDL's form: rows of a table by KDL's own reading of them.
inline void add_link(const Link& link, KDL::Chain& chain) {
    const KDL::Joint joint(link.kind == rrs::JointKind::revolute ? KDL::Joint::RotZ : KDL::Joint::TransZ);
    if (link.row) {
        const DhLink& row = *link.row;
        chain.addSegment(
            KDL::Segment(joint, KDL::Frame::DH(row.a_mm, row.alpha_rad, row.d_mm, row.theta_rad)));
    } else {
        chain.addSegment(fixed(link.before));
        chain.addSegment(KDL::Segment(joint, to_kdl(link.after)));
    }
}

/// The end of a branch in the world by the Orocos Kinematics and Dynamics Library.
inline rrs::CartPos kdl_end(const Branch& branch, const rrs::JointPos& joints) {
    KDL::Chain chain;
    KDL::JntArray values(static_cast<unsigned>(branch.links.size()));
    chain.addSegment(fixed(branch.base));
    for (const Link& link : branch.links) {
        values(chain.getNrOfJoints()) = joints[link.joint];
        add_link(link, chain);
    }
    chain.addSegment(fixed(branch.end));
    KDL::Frame frame;
    KDL::ChainFkSolverPos_recursive(chain).JntToCart(values, frame);
    return from_kdl(frame);
}

/// Chain::forward() by KDL.
inline rrs::CartPos kdl_forward(const Chain& chain, const rrs::JointPos& joints) {
    return kdl_end(chain.work_side(), joints).inverse() * kdl_end(chain.tool_side(), joints);
}

}  // namespace gsim::kinematics
