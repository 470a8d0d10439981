#pragma once

#include <vector>

#include "motion/dynamics/rigid_body.h"
#include "motion/kinematics/chain.h"

namespace gsim::dynamics {

/// Forces of joints that slide (N) or torques of those that turn (Nm), in the sense of their values.
using Efforts = rrs::JointPos;

/// The drive of one joint, seen at the joint. Units are N, m, kg for a joint that slides, and Nm, rad, kg m2
/// for one that turns.
struct JointDrive {
    double coulomb_friction = 0;  ///< Friction that does not depend on speed; N or Nm.
    double viscous = 0;           ///< Friction per speed; N s/m or Nm s/rad.
    double rotor = 0;             ///< Inertia that turns with the motor, reflected; kg or kg m2.
    double counterweight =
        0;  ///< Load that a balance takes off the motor in the sense of the value; N or Nm.
};

/// Part to which the end of a hose is attached.
enum class HoseEnd { joint, tool, work };

/// A hose (or a cable) that is held at a point of the world and at one of a link. It is a tether: beyond its
/// free length it pulls like a spring, if shorter it is slack. It also drags at the link's point, against the
/// speed of that point.
struct Hose {
    HoseEnd end = HoseEnd::tool;
    int joint = 0;  ///< For HoseEnd::joint.
    Eigen::Vector3d point_m =
        Eigen::Vector3d::Zero();  ///< In the frame after that joint, the tool's or the work's.
    Eigen::Vector3d anchor_m = Eigen::Vector3d::Zero();  ///< In the world.
    double free_length_m = 0;
    double stiffness_n_per_m = 0;
    double drag_n_s_per_m = 0;
};

/// 9.80665 m/s2 down the world's Z: standard gravity (CGPM 1901).
inline const Eigen::Vector3d kStandardGravity_m_s2{0, 0, -9.80665};

/// The masses of a chain and the effects that act on it.
struct DynamicsModel {
    Eigen::Vector3d gravity_m_s2 = kStandardGravity_m_s2;  ///< In the world.
    std::vector<RigidBody> links = {};    ///< For each joint, in the frame after it (Chain::tool_frames()).
    RigidBody tool = {};                  ///< In the frame of the tool centre point.
    RigidBody work = {};                  ///< In the work frame.
    std::vector<JointDrive> drives = {};  ///< For each joint.
    std::vector<Hose> hoses = {};
};

/// Inverse dynamics of a chain: the forces and torques that its motors need for a motion, by the recursion of
/// Newton and Euler (Luh, Walker, Paul: On-Line Computational Scheme for Mechanical Manipulators, 1980), in
/// the frame of the world. The joints that carry the tool and those that carry the work are two chains that
/// share only the world, which does not move. Immutable.
class Dynamics {
  public:
    /// Takes a model with an entry of `links` and `drives` for each joint; throws std::invalid_argument
    /// otherwise.
    Dynamics(const kinematics::Chain& chain, const DynamicsModel& model);

    int joint_count() const { return static_cast<int>(drives_.size()); }

    /// Joint values (mm, rad), speeds and accelerations (per s, s2), and for each joint the sense of motion
    /// that Coulomb's friction opposes: 1, -1, or 0 at standstill.
    struct Motion {
        rrs::JointPos position;
        rrs::JointPos velocity;
        rrs::JointPos acceleration;
        rrs::JointPos sense;
    };

    /// Returns the efforts of the motors, N or Nm.
    Efforts efforts(const Motion& motion) const;
    /// Returns the part of efforts() due to the acceleration: the mass matrix times it, including rotors.
    /// With a change of speed instead of the acceleration it is the impulse for that, N s or Nm s.
    Efforts inertial_efforts(const rrs::JointPos& position, const rrs::JointPos& acceleration) const;
    /// Returns the part of efforts() due to friction at the joints.
    Efforts friction(const rrs::JointPos& velocity, const rrs::JointPos& sense) const;
    /// Returns the power of each motor into the machine, W: effort times speed.
    rrs::JointPos powers_w(const Efforts& efforts, const rrs::JointPos& velocity) const;

  private:
    struct Link {
        int joint;
        bool is_prismatic;
        Eigen::Isometry3d before;  ///< From the frame after the motion of the link before, in m.
        RigidBody body;            ///< In the frame after the motion.
        std::vector<Hose> hoses;   ///< With points in that frame.
    };
    struct State;
    struct Loads;

    std::vector<Link> make_links(const kinematics::Branch& branch, const DynamicsModel& model,
                                 const RigidBody& carried_body, bool tool) const;
    void add_efforts(const std::vector<Link>& links, const Motion& motion, bool acceleration_only,
                     Efforts& efforts) const;
    static State world();
    static State state_after(const State& before, const Link& link, double value, double rate, double second);
    static void add_body(const RigidBody& body, const State& state, Loads& loads);
    static void add_hoses(const Link& link, const State& state, Loads& loads);
    double in_si(int joint, double value) const;

    Eigen::Vector3d gravity_m_s2_;
    std::vector<JointDrive> drives_;
    std::vector<bool> slides_;  ///< By joint.
    std::vector<Link> tool_side_;
    std::vector<Link> work_side_;
};

/// Returns the sense of each joint's speed: 0 at standstill, within rounding.
rrs::JointPos motion_directions(const rrs::JointPos& velocity);

}  // namespace gsim::dynamics
