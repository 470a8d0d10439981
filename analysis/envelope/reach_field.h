#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "analysis/envelope/closed_form_reach.h"
#include "analysis/envelope/closest_approach.h"

namespace gsim::envelope {

/// Distances from a set, at the nodes of a grid of cubes.
struct DistanceGrid {
    Vector3d low_mm;
    double step_mm = 1;
    Eigen::Array3i count;            ///< Nodes in each direction.
    std::vector<float> distance_mm;  ///< x fastest.
    Eigen::AlignedBox3d set_bounds;  ///< The set is in here.
    double error_mm = 0;             ///< Error of the distances at nodes, up to `band_mm`.
    double band_mm = 0;              ///< Distances beyond are lower bounds.

    Vector3d node(const Eigen::Array3i& index) const {
        return low_mm + step_mm * index.cast<double>().matrix();
    }
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count.y()) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(count.x()) +
               static_cast<std::size_t>(x);
    }
    /// Interpolates linearly between nodes in each direction; outside, returns the distance from
    /// `set_bounds`, which is not larger.
    double at(const Vector3d& point) const;
    /// Returns the max error of at() for distances within the grid's reach. A distance changes by at most the
    /// travel, which from the corners of a cube to any point in it is at most half its diagonal.
    double interpolation_error_mm() const;
};

/// Reach of the TCP of a chain, as distances from it. It is computed from the last joint to the first. A
/// joint makes a union of a set; the distance from it is the smallest distance from the set along the path of
/// the joint, taken back. The last joints have a closed form (ClosedFormReach). For the one before them the
/// nodes are exact to a tolerance; each joint before that adds the error of the grid from which it is
/// computed.
class ReachField {
  public:
    /// Builds the grids, with `nodes` in the longest direction of each. The chain has joints, with finite
    /// ranges.
    ReachField(const TcpChain& chain, int nodes);

    /// Returns the grid of all joints.
    const DistanceGrid& grid() const { return grids_.back(); }
    /// Returns the level: distances between nodes are at most this at all reached points.
    double iso_level_mm() const { return grid().interpolation_error_mm(); }
    /// Returns joint values that bring the TCP about as near to a point as the field says.
    std::vector<double> nearest_values(const Vector3d& point) const;

  private:
    void build(const std::vector<Eigen::AlignedBox3d>& boxes, int nodes);
    std::vector<Eigen::AlignedBox3d> loose_boxes() const;
    std::vector<Eigen::AlignedBox3d> tight_boxes() const;
    void fill(std::size_t level);
    /// Returns the accuracy of the nodes of a grid, without that of the grid from which they are computed.
    double tolerance_mm(std::size_t level) const { return kTolerance * grids_[level].step_mm; }
    ClosestApproach pass(std::size_t level, const Vector3d& point, double hint,
                         const ApproachAccuracy& rule) const;
    /// Returns the joint that makes grid `level`; null if the closed form does it alone.
    const TcpJoint* level_joint(std::size_t level) const;

    static constexpr double kTolerance = 0.25;  // of the step

    TcpChain chain_;
    ClosedFormReach tail_;
    std::vector<DistanceGrid> grids_;  ///< Last joints first.
};

}  // namespace gsim::envelope
