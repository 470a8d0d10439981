#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/outputs/path_style.h"

namespace gsim::simulation {

/// Corner of a polyline; the style is that of the line that ends here.
struct PathPoint {
    Eigen::Vector2d at_mm;
    PathStyle style;
};

/// Reduction of a path, point by point, to a polyline of few points that stays near it. Points are omitted as
/// long as those in between are within a tolerance of the straight line (Reumann and Witkam). Each time the
/// polyline grows too long the tolerance doubles.
class PathThinner {
  public:
    static constexpr std::size_t kMaxPoints = 20000;

    void add(const Eigen::Vector2d& at_mm, PathStyle style);
    /// Returns the polyline up to the last point added.
    std::vector<PathPoint> points() const;

  private:
    void push(const PathPoint& point);
    void store_last();
    bool continues_line(const Eigen::Vector2d& at_mm) const;
    void coarsen();

    double tolerance_mm_ = 1e-3;
    std::vector<PathPoint> kept_;
    std::optional<PathPoint> last_;             // seen, not kept yet
    std::optional<Eigen::Vector2d> direction_;  // of the line from the last kept point
};

}  // namespace gsim::simulation
