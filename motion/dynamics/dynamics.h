#pragma once

#include <vector>

#include "motion/dynamics/rigid_body.h"
#include "motion/kinematics/chain.h"

namespace gsim::dynamics {

/// Of the force of a joint that slides (N) or the torque of one that turns (Nm), in the sense of its value.
using Efforts = rrs::JointPos;

/// What moves one joint, seen at the joint. Units are N, m, kg of one that slides, and Nm, rad, kg m2 of one
/// that turns.
struct JointDrive {
    double coulomb = 0;        ///< Friction that does not depend on speed; N or Nm.
    double viscous = 0;        ///< Friction per speed; N s/m or Nm s/rad.
    double rotor = 0;          ///< What turns with the motor, reflected; kg or kg m2.
    double counterweight = 0;  ///< What a balance takes off the motor in the sense of the value; N or Nm.
};

/// What the end of a hose hangs on.
enum class HoseEnd { joint, tool, work };

/// A hose (or a cable) that is held at a point of the world and at one of a link. It is a tether: what is
/// beyond its free length pulls like a spring, shorter it is slack; and it is dragged by the link's point,
/// against the speed of that.
struct Hose {
    HoseEnd end = HoseEnd::tool;
    int joint = 0;  ///< Of HoseEnd::joint.
    Eigen::Vector3d point_m =
        Eigen::Vector3d::Zero();  ///< In the frame behind that joint, the tool's or the work's.
    Eigen::Vector3d anchor_m = Eigen::Vector3d::Zero();  ///< In the world.
    double free_length_m = 0;
    double stiffness_n_per_m = 0;
    double drag_n_s_per_m = 0;
};

/// 9.80665 m/s2 down the world's Z: standard gravity (CGPM 1901).
inline const Eigen::Vector3d kStandardGravity_m_s2{0, 0, -9.80665};

/// The masses of a chain and what acts on it.
struct DynamicsModel {
    Eigen::Vector3d gravity_m_s2 = kStandardGravity_m_s2;  ///< In the world.
    std::vector<RigidBody> links = {};    ///< For each joint, in the frame behind it (Chain::tool_frames()).
    RigidBody tool = {};                  ///< In the frame of the tool centre point.
    RigidBody work = {};                  ///< In the work frame.
    std::vector<JointDrive> drives = {};  ///< For each joint.
    std::vector<Hose> hoses = {};
};

/// Inverse dynamics of a chain: the forces and torques that its motors have to bring up for a motion, by the
/// recursion of Newton and Euler (Luh, Walker, Paul: On-Line Computational Scheme for Mechanical
/// Manipulators, 1980), in the frame of the world. The joints that carry the tool and those that carry the
/// work are two chains that share nothing but the world, which does not move. Immutable.
class Dynamics {
  public:
    /// `links` and `drives` of the model have an entry for each joint; throws std::invalid_argument
    /// otherwise.
    Dynamics(const kinematics::Chain& chain, const DynamicsModel& model);

    int joint_count() const { return static_cast<int>(drives_.size()); }

    /// Joint values (mm, rad), speeds and accelerations (per s, s2), and for each joint the sense in which
    /// Coulomb's friction holds against it: 1, -1, or 0 where it stands.
    struct Motion {
        rrs::JointPos position;
        rrs::JointPos velocity;
        rrs::JointPos acceleration;
        rrs::JointPos sense;
    };

    /// What the motors bring up, N or Nm.
    Efforts efforts(const Motion& motion) const;
    /// The part of efforts() that goes with the acceleration: the mass matrix times it, rotors among it. With
    /// a change of speed in its place it is the impulse for that, N s or Nm s.
    Efforts inertial(const rrs::JointPos& position, const rrs::JointPos& acceleration) const;
    /// The part of efforts() that friction at the joints takes.
    Efforts friction(const rrs::JointPos& velocity, const rrs::JointPos& sense) const;
    /// What each motor does to the machine, W: effort times speed.
    rrs::JointPos powers_w(const Efforts& efforts, const rrs::JointPos& velocity) const;

  private:
    struct Link {
        int joint;
        bool slides;
        Eigen::Isometry3d before;  ///< From the frame behind the motion of the link before, in m.
        RigidBody body;            ///< In the frame behind the motion.
        std::vector<Hose> hoses;   ///< With points in that frame.
    };
    struct State;
    struct Loads;

    std::vector<Link> links_of(const kinematics::Branch& branch, const DynamicsModel& model,
                               const RigidBody& carried, bool tool) const;
    void add_efforts(const std::vector<Link>& links, const Motion& motion, bool free, Efforts& efforts) const;
    static State world();
    static State behind(const State& before, const Link& link, double value, double rate, double second);
    static void add_body(const RigidBody& body, const State& state, Loads& loads);
    static void add_hoses(const Link& link, const State& state, Loads& loads);
    double in_si(int joint, double value) const;

    Eigen::Vector3d gravity_m_s2_;
    std::vector<JointDrive> drives_;
    std::vector<bool> slides_;  ///< By joint.
    std::vector<Link> tool_side_;
    std::vector<Link> work_side_;
};

/// The sense of each joint's speed: 0 where it stands, but for rounding.
rrs::JointPos senses(const rrs::JointPos& velocity);

}  // namespace gsim::dynamics
