#pragma once

#include <span>
#include <string>
#include <vector>

#include "cam/solid/contours.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Edges of walls: at the jet's entry or at its exit.
enum class WallEnd { upper, lower };

/// All edges to be cut, and others of the part, for queries of their distance to a jet.
class EdgeProximity {
  public:
    EdgeProximity(std::span<const solid::WallContour> contours, const JetShape& jet,
                  WallEnd wall_end = WallEnd::upper, std::span<const solid::PartEdge> others = {});

    /// A position of a part, and the distance of the jet's center from it.
    struct NearestSample {
        double distance_mm = 0;
        Vector position = Vector::Zero();
        std::string edge = {};
    };
    /// Returns the nearest position of an edge to the jet whose center passes through a point, between its
    /// TCP and its exit.
    NearestSample nearest(const Vector& middle, const Vector& axis, double depth_mm) const;

  private:
    struct EdgePoint {
        Vector at;
        const std::string* edge = nullptr;  ///< Its name.
    };
    struct Group {
        Vector middle;
        double radius_mm = 0;
        std::vector<EdgePoint> samples;
    };

    void add_line(const Vector& from, const Vector& to, const std::string& edge,
                  std::vector<EdgePoint>& samples);

    JetShape jet_;
    std::vector<Group> groups_;
};

}  // namespace gsim::surface
