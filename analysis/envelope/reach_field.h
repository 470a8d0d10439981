#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "analysis/envelope/sweep.h"
#include "analysis/envelope/tail_set.h"

namespace gsim::envelope {

/// Distances from a set, at the nodes of a grid of cubes.
struct DistanceGrid {
    Vector3d low_mm;
    double step_mm = 1;
    Eigen::Array3i count;            ///< Of nodes, in each direction.
    std::vector<float> distance_mm;  ///< x fastest.
    Eigen::AlignedBox3d holds;       ///< The set is in here.
    double error_mm = 0;             ///< Of the distances at nodes, of those up to `band_mm`.
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
    /// Between nodes linear in each direction; outside, the distance from `holds`, which is no more.
    double at(const Vector3d& point) const;
    /// How far at() may be off, of what is nearer than the grid reaches: a distance changes by no more than
    /// one goes, and from the corners of a cube to any point in it that is half its diagonal at most.
    double error_between_mm() const;
};

/// What the tip of a chain reaches, as distances from it. From the last joint to the first: the distance from
/// the union of what a joint makes of a set is the least of the distances from the set along the way of the
/// joint, taken back. The last joints have a closed form (TailSet), of the one before them the nodes are
/// exact to a tolerance; each joint before that adds the error of the grid that it is looked up in.
class ReachField {
  public:
    /// `nodes` in the longest direction of each grid. The chain has joints, with finite ranges.
    ReachField(const TipChain& chain, int nodes);

    /// Of all joints.
    const DistanceGrid& grid() const { return grids_.back(); }
    /// All that is reached is where distances between nodes are no more than this.
    double level_mm() const { return grid().error_between_mm(); }
    /// Joint values that bring the tip about as near to a point as the field says.
    std::vector<double> nearest_values(const Vector3d& point) const;

  private:
    void build(const std::vector<Eigen::AlignedBox3d>& boxes, int nodes);
    std::vector<Eigen::AlignedBox3d> loose_boxes() const;
    std::vector<Eigen::AlignedBox3d> tight_boxes() const;
    void fill(std::size_t level);
    /// How exact the nodes of a grid are made, what it is looked up in apart.
    double tolerance_mm(std::size_t level) const { return kTolerance * grids_[level].step_mm; }
    NearestPass pass(std::size_t level, const Vector3d& point, double hint, const PassRule& rule) const;
    /// The joint that makes grid `level`; null where the closed form does it alone.
    const TipJoint* joint_of(std::size_t level) const;

    static constexpr double kTolerance = 0.25;  // of the step

    TipChain chain_;
    TailSet tail_;
    std::vector<DistanceGrid> grids_;  ///< Of the last joints first.
};

}  // namespace gsim::envelope
