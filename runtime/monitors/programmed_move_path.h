#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "motion/planner/motion_model.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Programmed path of the TCP on the part in one move: all axes in proportion.
class ProgrammedMovePath {
  public:
    /// Sets `position_joints`, which carry X, Y and Z of an arc (-1: none).
    ProgrammedMovePath(const motion::PathMove& move, const std::array<int, 3>& position_joints,
                       std::shared_ptr<WorkpieceTcp> tcp, const SourceLocation& location);

    rrs::TargetId id() const { return id_; }
    bool rapid() const { return rapid_; }
    const SourceLocation& location() const { return location_; }
    const std::shared_ptr<WorkpieceTcp>& tcp() const { return tcp_; }
    const Eigen::Vector3d& start() const { return ends_.front(); }
    const Eigen::Vector3d& end() const { return ends_.back(); }

    /// Returns points of the path in their order, the first at its start and the last at its end: two for a
    /// straight one.
    std::span<const Eigen::Vector3d> points();
    /// Returns the distance of a point from the path, mm; if that is no more than `cutoff`, any value up to
    /// it.
    double distance(const Eigen::Vector3d& point, double cutoff);

  private:
    struct Curve {
        motion::PathMove move;
        std::array<int, 3> position_joints;
        std::vector<Eigen::Vector3d> points = {};  ///< Once they are asked for.
    };

    Eigen::Vector3d at(double share) const;

    rrs::TargetId id_;
    bool rapid_;
    SourceLocation location_;
    std::shared_ptr<WorkpieceTcp> tcp_;
    std::array<Eigen::Vector3d, 2> ends_;
    std::unique_ptr<Curve> curve_;  ///< Null: the path is straight.
};

/// Returns the distance of a point from the line between two others, mm.
double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
                        const Eigen::Vector3d& end);
/// Returns the distance of a point from the chords of a curve through these points next to the nearest of
/// them, mm.
double distance_to_chords(const Eigen::Vector3d& point, std::span<const Eigen::Vector3d> curve);
/// Returns the distance of a point from a smooth curve through these points of it, at even steps of some
/// parameter, mm. Between three of them the curve is taken for a parabola.
double distance_to_curve(const Eigen::Vector3d& point, std::span<const Eigen::Vector3d> curve);

}  // namespace gsim::simulation
