#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "machine/model/joint_box.h"

namespace gsim::envelope {

using Eigen::Vector3d;

/// Sine of the angle below which two directions count as parallel.
inline constexpr double kParallel = 1e-9;

/// Returns true for parallel unit vectors, in either sense.
bool is_parallel(const Vector3d& a, const Vector3d& b);

/// Joint as it moves the TCP relative to the work: along or about a line in the work frame, by a value of the
/// joint (mm, rad) between two ends.
struct TcpJoint {
    int joint;
    rrs::JointKind kind;
    Vector3d point_mm;
    Vector3d direction;  ///< Unit vector.
    double low;
    double high;

    bool is_slide() const { return kind == rrs::JointKind::prismatic; }
    /// Returns a point as moved by the joint.
    Vector3d transformed(const Vector3d& point, double value) const;
};

/// TCP in the work frame as a product of exponentials without its rotation (kinematics::ScrewChain): the
/// first joint moves what all others have made of the start. Only joints that move the TCP.
struct TcpChain {
    std::vector<TcpJoint> joints;
    Vector3d start_mm;

    Vector3d tcp(const std::vector<double>& values) const;
};

/// Returns the chain of a machine with joints that move over the box; those without a range there are fixed.
TcpChain tcp_chain(const machine::Machine& machine, const machine::JointBox& box);

/// Returns the chain of two joints, first < second in `full_chain`, with all others at home.
TcpChain pair_chain(const TcpChain& full_chain, std::size_t first, std::size_t second,
                    const rrs::JointPos& home);

}  // namespace gsim::envelope
