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
constexpr double kStands = 1e-5;  // mm/s, rad/s

Eigen::Isometry3d in_metres(const rrs::CartPos& pose) {
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
    Vector3d turning;       // rad/s
    Vector3d turning_rate;  // rad/s2
    Vector3d velocity;      // of the point, m/s
    Vector3d acceleration;  // the same, less gravity
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
        throw std::invalid_argument("a model of dynamics has not one link and one drive for each joint");
    for (int joint = 0; joint < chain.joint_count(); ++joint)
        slides_.push_back(chain.kind(joint) == rrs::JointKind::prismatic);
    tool_side_ = links_of(chain.tool_side(), model, model.tool, true);
    work_side_ = links_of(chain.work_side(), model, model.work, false);
}

// Bodies that are fixed after the last joint move with its link.
std::vector<Dynamics::Link> Dynamics::links_of(const kinematics::Branch& branch, const DynamicsModel& model,
                                               const RigidBody& carried, bool tool) const {
    std::vector<Link> links;
    Eigen::Isometry3d fixed = in_metres(branch.base);
    for (const kinematics::Link& of_chain : branch.links) {
        const Eigen::Isometry3d after = in_metres(of_chain.after);
        const bool last = &of_chain == &branch.links.back();
        const Eigen::Isometry3d end = after * in_metres(branch.end);
        Link link{.joint = of_chain.joint,
                  .slides = of_chain.kind == rrs::JointKind::prismatic,
                  .before = fixed * in_metres(of_chain.before),
                  .body = moved(model.links[static_cast<std::size_t>(of_chain.joint)], after),
                  .hoses = {}};
        if (last) link.body = joined(link.body, moved(carried, end));
        for (Hose hose : model.hoses) {
            const bool on_joint = hose.end == HoseEnd::joint;
            const bool on_end = last && hose.end == (tool ? HoseEnd::tool : HoseEnd::work);
            if (!(on_joint ? hose.joint == of_chain.joint : on_end)) continue;
            hose.point_m = (on_joint ? after : end) * hose.point_m;
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
        const Vector3d way = hose.anchor_m - (state.frame.translation() + arm);
        const double beyond_m = way.norm() - hose.free_length_m;
        Vector3d pull = -hose.drag_n_s_per_m * (state.velocity + state.turning.cross(arm));
        if (beyond_m > 0 && way.norm() > 0) pull += hose.stiffness_n_per_m * beyond_m * way.normalized();
        loads.force -= pull;
        loads.torque -= arm.cross(pull);
    }
}

Dynamics::State Dynamics::world() {
    const Vector3d none = Vector3d::Zero();
    return {Eigen::Isometry3d::Identity(), none, none, none, none, none};
}

// Returns the state of the link after `before`, with its joint at `value` and these first and second
// derivatives.
Dynamics::State Dynamics::behind(const State& before, const Link& link, double value, double rate,
                                 double second) {
    State state;
    state.frame = before.frame * link.before;
    state.axis = state.frame.linear().col(2);
    state.turning = before.turning;
    state.turning_rate = before.turning_rate;
    if (link.slides) {
        state.frame.translation() += value * state.axis;
    } else {
        state.frame.linear() =
            state.frame.linear() * Eigen::AngleAxisd(value, Vector3d::UnitZ()).toRotationMatrix();
        state.turning += rate * state.axis;
        state.turning_rate += second * state.axis + rate * before.turning.cross(state.axis);
    }
    const Vector3d arm = state.frame.translation() - before.frame.translation();
    const Vector3d swing = before.turning.cross(arm);
    state.velocity = before.velocity + swing;
    state.acceleration = before.acceleration + before.turning_rate.cross(arm) + before.turning.cross(swing);
    if (link.slides) {
        state.velocity += rate * state.axis;
        state.acceleration += second * state.axis + 2 * rate * before.turning.cross(state.axis);
    }
    return state;
}

void Dynamics::add_body(const RigidBody& body, const State& state, Loads& loads) {
    const Matrix3d turn = state.frame.linear();
    const Vector3d centre = turn * body.centre_m;
    const Vector3d force = body.mass_kg * (state.acceleration + state.turning_rate.cross(centre) +
                                           state.turning.cross(state.turning.cross(centre)));
    const Vector3d turning = turn.transpose() * state.turning;
    const Vector3d turning_rate = turn.transpose() * state.turning_rate;
    const Vector3d spin = body.inertia_kg_m2 * turning_rate + turning.cross(body.inertia_kg_m2 * turning);
    loads.force += force;
    loads.torque += turn * spin + centre.cross(force);
}

// Speeds and accelerations are computed outwards, with gravity as an acceleration of the world upwards;
// forces inwards. `free`: without gravity, speeds and hoses, so that the acceleration alone counts.
void Dynamics::add_efforts(const std::vector<Link>& links, const Motion& motion, bool free,
                           Efforts& efforts) const {
    if (links.empty()) return;
    std::array<State, rrs::kMaxJoints> states;
    State before = world();
    if (!free) before.acceleration = -gravity_m_s2_;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const int joint = links[i].joint;
        before = states[i] =
            behind(before, links[i], in_si(joint, motion.position[joint]),
                   free ? 0 : in_si(joint, motion.velocity[joint]), in_si(joint, motion.acceleration[joint]));
    }
    Loads loads;  // of a link and all links after it, about its point
    for (std::size_t i = links.size(); i-- > 0;) {
        add_body(links[i].body, states[i], loads);
        if (!free) add_hoses(links[i], states[i], loads);
        efforts[links[i].joint] += (links[i].slides ? loads.force : loads.torque).dot(states[i].axis);
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

Efforts Dynamics::inertial(const rrs::JointPos& position, const rrs::JointPos& acceleration) const {
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
        efforts[joint] = drive.coulomb * sense[joint] + drive.viscous * in_si(joint, velocity[joint]);
    }
    return efforts;
}

rrs::JointPos Dynamics::powers_w(const Efforts& efforts, const rrs::JointPos& velocity) const {
    rrs::JointPos powers(joint_count());
    for (int joint = 0; joint < joint_count(); ++joint)
        powers[joint] = efforts[joint] * in_si(joint, velocity[joint]);
    return powers;
}

rrs::JointPos senses(const rrs::JointPos& velocity) {
    return velocity.unaryExpr([](double v) { return std::abs(v) <= kStands ? 0.0 : (v > 0 ? 1.0 : -1.0); });
}

}  // namespace gsim::dynamics
