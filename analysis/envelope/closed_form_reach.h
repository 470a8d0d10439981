#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

/// Set that the last joints of a chain make of the TCP, if its distance from a point has a closed form: the
/// start itself, an arc about one revolute joint, or the box of up to three slides at right angles.
class ClosedFormReach {
  public:
    explicit ClosedFormReach(const TcpChain& chain);

    /// Returns how many of the chain's joints it covers.
    std::size_t joint_count() const { return tail_.joints.size(); }
    double distance_mm(const Vector3d& point) const;
    /// Returns values of its joints that bring the TCP nearest to a point.
    std::vector<double> nearest_values(const Vector3d& point) const;
    /// Returns a box that holds it, with sides along the axes of the frame.
    Eigen::AlignedBox3d bounds() const;

  private:
    double nearest_angle(const Vector3d& point) const;

    TcpChain tail_;
};

}  // namespace gsim::envelope
