#pragma once

#include <Eigen/Core>
#include <array>

namespace gsim::cell {

/// A point of the difference of two bodies, and the points of both that it comes from.
struct DifferencePoint {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d on_first = Eigen::Vector3d::Zero();
    Eigen::Vector3d on_second = Eigen::Vector3d::Zero();
};

/// Up to four points of a difference of bodies, and the point where their hull is nearest to the origin (C.
/// Ericson, Real-Time Collision Detection, 5.1 and 9.5).
class Simplex {
  public:
    int size() const { return count_; }
    bool contains(const Eigen::Vector3d& point) const;
    void add(const DifferencePoint& point) { corners_[static_cast<std::size_t>(count_++)] = point; }
    /// Keeps only the corners that carry the point nearest to the origin, and returns it. If four corners are
    /// left, the origin is inside.
    Eigen::Vector3d reduce();
    /// Returns the point of reduce(), on each of both bodies.
    DifferencePoint nearest() const;

  private:
    using Corners = std::array<int, 3>;

    const Eigen::Vector3d& at(int corner) const { return corners_[static_cast<std::size_t>(corner)].at; }
    void keep(const Corners& kept, int count, const Eigen::Vector3d& weights);
    void reduce_segment(int a, int b);
    void reduce_triangle(int a, int b, int c);
    void reduce_tetrahedron();

    std::array<DifferencePoint, 4> corners_;
    std::array<double, 4> weights_{};
    int count_ = 0;
};

}  // namespace gsim::cell
