#include "motion/dynamics/dynamics.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace gsim::dynamics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double kMetresPerMm = 1e-3;
// Speed below which a joint is at standstill. Joints that do not take part in a move have speeds by rounding:
// some 1e-12 of those of others. Joints that follow a numeric inverse are at standstill to 1e-9 mm, for a
// chord of a millisecond.
constexpr double kStandstillSpeed = 1e-5;  // mm/s, rad/s

Eigen::Isometry3d to_metres(const rrs::CartPos& pose) {
    Eigen::Isometry3d metres = pose;
    metres.translation() *= kMetresPerMm;
    return metres;
}

}  // namespace

/// State of a link in the outward recursion, in the world. The point is the origin of the frame after its
/// motion. It has no initial values, because an array of them exists for each instant.
struct Dynamics::State {
    Eigen::Isometry3d frame;
    Vector3d axis;
    Vector3d angular_velocity;      // rad/s
    Vector3d angular_acceleration;  // rad/s2
    Vector3d velocity;              // of the point, m/s
    Vector3d acceleration;          // the same, less gravity
};

/// Loads of the links from one on that act on the one before, about the point of that link.
struct Dynamics::Loads {
    Vector3d force = Vector3d::Zero();
    Vector3d torque = Vector3d::Zero();
};

Dynamics::Dynamics(const kinematics::Chain& chain, const DynamicsModel& model)
    : gravity_m_s2_(model.gravity_m_s2), drives_(model.drives) {
    const auto joints = static_cast<std::size_t>(chain.joint_count());
    if (model.links.size() != joints || model.drives.size() != joints)
        throw std::invalid_argument("a model of dynamics must have one link and one drive for each joint");
    for (int joint = 0; joint < chain.joint_count(); ++joint)
        slides_.push_back(chain.kind(joint) == rrs::JointKind::prismatic);
    tool_side_ = make_links(chain.tool_side(), model, model.tool, true);
    work_side_ = make_links(chain.work_side(), model, model.work, false);
}

// Bodies that are fixed past the last joint move with its link.
std::vector<Dynamics::Link> Dynamics::make_links(const kinematics::Branch& branch, const DynamicsModel& model,
                                                 const RigidBody& carried_body, bool tool) const {
    std::vector<Link> links;
    Eigen::Isometry3d fixed = to_metres(branch.base);
    for (const kinematics::Link& chain_link : branch.links) {
        const Eigen::Isometry3d after = to_metres(chain_link.after);
        const bool last = &chain_link == &branch.links.back();
        const Eigen::Isometry3d end = after * to_metres(branch.end);
        Link link{.joint = chain_link.joint,
                  .is_prismatic = chain_link.kind == rrs::JointKind::prismatic,
                  .before = fixed * to_metres(chain_link.before),
                  .body = moved(model.links[static_cast<std::size_t>(chain_link.joint)], after),
                  .hoses = {}};
        if (last) link.body = joined(link.body, moved(carried_body, end));
        for (Hose hose : model.hoses) {
            const bool is_on_joint = hose.end == HoseEnd::joint;
            const bool is_on_end = last && hose.end == (tool ? HoseEnd::tool : HoseEnd::work);
            if (!(is_on_joint ? hose.joint == chain_link.joint : is_on_end)) continue;
            hose.point_m = (is_on_joint ? after : end) * hose.point_m;
            link.hoses.push_back(hose);
        }
        links.push_back(std::move(link));
        fixed = after;
    }
    return links;
}

double Dynamics::in_si(int joint, double value) const {
    return slides_[static_cast<std::size_t>(joint)] ? value * kMetresPerMm : value;
}

void Dynamics::add_hoses(const Link& link, const State& state, Loads& loads) {
    for (const Hose& hose : link.hoses) {
        const Vector3d arm = state.frame.linear() * hose.point_m;
        const Vector3d displacement = hose.anchor_m - (state.frame.translation() + arm);
        const double elongation_m = displacement.norm() - hose.free_length_m;
        Vector3d drag_force = -hose.drag_n_s_per_m * (state.velocity + state.angular_velocity.cross(arm));
        if (elongation_m > 0 && displacement.norm() > 0)
            drag_force += hose.stiffness_n_per_m * elongation_m * displacement.normalized();
        loads.force -= drag_force;
        loads.torque -= arm.cross(drag_force);
    }
}

Dynamics::State Dynamics::world() {
    const Vector3d none = Vector3d::Zero();
    return {Eigen::Isometry3d::Identity(), none, none, none, none, none};
}

// Returns the state of the link that follows `before`, with its joint at `value` and these first and second
// derivatives.
Dynamics::State Dynamics::state_after(const State& before, const Link& link, double value, double rate,
                                      double second) {
    State state;
    state.frame = before.frame * link.before;
    state.axis = state.frame.linear().col(2);
    state.angular_velocity = before.angular_velocity;
    state.angular_acceleration = before.angular_acceleration;
    if (link.is_prismatic) {
        state.frame.translation() += value * state.axis;
    } else {
        state.frame.linear() =
            state.frame.linear() * Eigen::AngleAxisd(value, Vector3d::UnitZ()).toRotationMatrix();
        state.angular_velocity += rate * state.axis;
        state.angular_acceleration += second * state.axis + rate * before.angular_velocity.cross(state.axis);
    }
    const Vector3d arm = state.frame.translation() - before.frame.translation();
    const Vector3d rotational_velocity = before.angular_velocity.cross(arm);
    state.velocity = before.velocity + rotational_velocity;
    state.acceleration = before.acceleration + before.angular_acceleration.cross(arm) +
                         before.angular_velocity.cross(rotational_velocity);
    if (link.is_prismatic) {
        state.velocity += rate * state.axis;
        state.acceleration += second * state.axis + 2 * rate * before.angular_velocity.cross(state.axis);
    }
    return state;
}

void Dynamics::add_body(const RigidBody& body, const State& state, Loads& loads) {
    const Matrix3d turn = state.frame.linear();
    const Vector3d centre = turn * body.centre_m;
    const Vector3d force =
        body.mass_kg * (state.acceleration + state.angular_acceleration.cross(centre) +
                        state.angular_velocity.cross(state.angular_velocity.cross(centre)));
    const Vector3d angular_velocity = turn.transpose() * state.angular_velocity;
    const Vector3d angular_acceleration = turn.transpose() * state.angular_acceleration;
    const Vector3d inertial_torque = body.inertia_kg_m2 * angular_acceleration +
                                     angular_velocity.cross(body.inertia_kg_m2 * angular_velocity);
    loads.force += force;
    loads.torque += turn * inertial_torque + centre.cross(force);
}

// Speeds and accelerations are computed outwards, with gravity as an acceleration of the world upwards;
// forces inwards. `acceleration_only`: without gravity, speeds and hoses, so that the acceleration alone
// counts.
void Dynamics::add_efforts(const std::vector<Link>& links, const Motion& motion, bool acceleration_only,
                           Efforts& efforts) const {
    if (links.empty()) return;
    std::array<State, rrs::kMaxJoints> states;
    State before = world();
    if (!acceleration_only) before.acceleration = -gravity_m_s2_;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const int joint = links[i].joint;
        before = states[i] = state_after(before, links[i], in_si(joint, motion.position[joint]),
                                         acceleration_only ? 0 : in_si(joint, motion.velocity[joint]),
                                         in_si(joint, motion.acceleration[joint]));
    }
    Loads loads;  // of a link and all that follow it, about its point
    for (std::size_t i = links.size(); i-- > 0;) {
        add_body(links[i].body, states[i], loads);
        if (!acceleration_only) add_hoses(links[i], states[i], loads);
        efforts[links[i].joint] += (links[i].is_prismatic ? loads.force : loads.torque).dot(states[i].axis);
        if (i == 0) break;
        const Vector3d arm = states[i].frame.translation() - states[i - 1].frame.translation();
        loads.torque += arm.cross(loads.force);
    }
}

Efforts Dynamics::efforts(const Motion& motion) const {
    Efforts efforts = friction(motion.velocity, motion.sense);
    for (int joint = 0; joint < joint_count(); ++joint) {
        const JointDrive& drive = drives_[static_cast<std::size_t>(joint)];
        efforts[joint] += drive.rotor * in_si(joint, motion.acceleration[joint]) - drive.counterweight;
    }
    add_efforts(tool_side_, motion, false, efforts);
    add_efforts(work_side_, motion, false, efforts);
    return efforts;
}

Efforts Dynamics::inertial_efforts(const rrs::JointPos& position, const rrs::JointPos& acceleration) const {
    Efforts efforts(joint_count());
    for (int joint = 0; joint < joint_count(); ++joint)
        efforts[joint] = drives_[static_cast<std::size_t>(joint)].rotor * in_si(joint, acceleration[joint]);
    const Motion motion{.position = position, .velocity = {}, .acceleration = acceleration, .sense = {}};
    add_efforts(tool_side_, motion, true, efforts);
    add_efforts(work_side_, motion, true, efforts);
    return efforts;
}

Efforts Dynamics::friction(const rrs::JointPos& velocity, const rrs::JointPos& sense) const {
    Efforts efforts(joint_count());
    for (int joint = 0; joint < joint_count(); ++joint) {
        const JointDrive& drive = drives_[static_cast<std::size_t>(joint)];
        efforts[joint] =
            drive.coulomb_friction * sense[joint] + drive.viscous * in_si(joint, velocity[joint]);
    }
    return efforts;
}

rrs::JointPos Dynamics::powers_w(const Efforts& efforts, const rrs::JointPos& velocity) const {
    rrs::JointPos powers(joint_count());
    for (int joint = 0; joint < joint_count(); ++joint)
        powers[joint] = efforts[joint] * in_si(joint, velocity[joint]);
    return powers;
}

rrs::JointPos motion_directions(const rrs::JointPos& velocity) {
    return velocity.unaryExpr(
        [](double v) { return std::abs(v) <= kStandstillSpeed ? 0.0 : (v > 0 ? 1.0 : -1.0); });
}

}  // namespace gsim::dynamics
