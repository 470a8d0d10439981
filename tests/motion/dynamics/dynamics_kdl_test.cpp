// Efforts against those of the Orocos Kinematics and Dynamics Library, and the time of both.
#include <chrono>
#include <iostream>

#include <gtest/gtest.h>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "motion/dynamics/dynamics.h"
#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

KDL::Vector to_kdl(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

// KDL knows no units: lengths are m here.
KDL::Frame to_kdl(const rrs::CartPos& pose) {
    const Eigen::Matrix3d r = pose.linear();
    return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
            to_kdl(Eigen::Vector3d(pose.translation() / 1000))};
}

KDL::RigidBodyInertia to_kdl(const RigidBody& body) {
    const Eigen::Matrix3d& i = body.inertia_kg_m2;
    const KDL::RotationalInertia moments(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    return KDL::RigidBodyInertia(body.mass_kg, to_kdl(body.centre_m), moments);
}

KDL::Chain kdl_chain(const Branch& branch, const DynamicsModel& model) {
    KDL::Chain chain;
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), to_kdl(branch.base)));
    for (const Link& link : branch.links) {
        const bool turns = link.kind == rrs::JointKind::revolute;
        chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), to_kdl(link.before)));
        chain.addSegment(KDL::Segment(KDL::Joint(turns ? KDL::Joint::RotZ : KDL::Joint::TransZ),
                                      to_kdl(link.after),
                                      to_kdl(model.links[static_cast<std::size_t>(link.joint)])));
    }
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), to_kdl(branch.end), to_kdl(model.tool)));
    return chain;
}

KDL::JntArray in_si(const Chain& chain, const rrs::JointPos& values) {
    KDL::JntArray array(static_cast<unsigned>(values.size()));
    for (int i = 0; i < values.size(); ++i)
        array(static_cast<unsigned>(i)) =
            chain.kind(i) == rrs::JointKind::prismatic ? values[i] / 1000 : values[i];
    return array;
}

DynamicsModel plain_model(Random& random, int joints) {
    DynamicsModel model = random.model(joints);
    model.hoses.clear();
    for (JointDrive& drive : model.drives) drive = {};
    return model;
}

TEST(DynamicsAgainstKdl, EffortsAgreeOnRandomChains) {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Chain chain = random.chain(6, 0);
        const DynamicsModel model = plain_model(random, 6);
        const KDL::Chain theirs = kdl_chain(chain.tool_side(), model);
        KDL::ChainIdSolver_RNE solver(theirs, to_kdl(model.gravity_m_s2));
        const rrs::JointPos q = random.joints(6, 3);
        const rrs::JointPos v = random.joints(6, 3);
        const rrs::JointPos a = random.joints(6, 20);
        KDL::JntArray torques(6);
        const KDL::Wrenches none(theirs.getNrOfSegments(), KDL::Wrench::Zero());
        ASSERT_EQ(solver.CartToJnt(in_si(chain, q), in_si(chain, v), in_si(chain, a), none, torques), 0);
        const Efforts efforts = Dynamics(chain, model).efforts({q, v, a, motion_directions(v)});
        EXPECT_LT((efforts - torques.data).norm(), 1e-12 * efforts.norm()) << i;
    }
}

// The choice between both is based on this (docs/dynamics.md); it asserts no times.
TEST(DynamicsAgainstKdl, PrintsTimeOfBoth) {
    constexpr int kRounds = 20'000;
    Random random(12);
    const Chain chain = random.chain(6, 0);
    const DynamicsModel model = plain_model(random, 6);
    const KDL::Chain theirs = kdl_chain(chain.tool_side(), model);
    KDL::ChainIdSolver_RNE solver(theirs, to_kdl(model.gravity_m_s2));
    const Dynamics dynamics(chain, model);
    const rrs::JointPos q = random.joints(6, 3);
    const KDL::JntArray values = in_si(chain, q);
    const KDL::Wrenches none(theirs.getNrOfSegments(), KDL::Wrench::Zero());
    KDL::JntArray torques(6);
    double sum = 0;
    const auto time_ns = [&](const auto& once) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < kRounds; ++i) once();
        return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() /
               kRounds;
    };
    const double ours = time_ns([&] { sum += dynamics.efforts({q, q, q, q})[0]; });
    const double kdl = time_ns([&] {
        solver.CartToJnt(values, values, values, none, torques);
        sum += torques(0);
    });
    EXPECT_NE(sum, 0);
    std::cout << "six joints: " << ours << " ns, KDL " << kdl << " ns\n";
}

}  // namespace
}  // namespace gsim::dynamics
