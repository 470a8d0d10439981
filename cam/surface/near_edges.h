#pragma once

#include <span>
#include <string>
#include <vector>

#include "cam/solid/contours.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Which edges of walls: where the jet enters, or where it leaves.
enum class WallEnd { upper, lower };

/// All edges of what is cut, to be asked how near a jet comes to them.
class NearEdges {
  public:
    NearEdges(std::span<const solid::WallContour> contours, const JetShape& jet,
              WallEnd which = WallEnd::upper);

    /// A place of a part, and how far the jet's middle is from it.
    struct Nearest {
        double distance_mm = 0;
        Vector place = Vector::Zero();
        std::string edge = {};
    };
    /// The nearest place of an edge to the jet whose middle goes through a point, between its tip and its
    /// exit.
    Nearest nearest(const Vector& middle, const Vector& axis, double depth_mm) const;

  private:
    struct Place {
        Vector at;
        std::size_t contour = 0, edge = 0;
    };
    struct Group {
        Vector middle;
        double radius_mm = 0;
        std::vector<Place> places;
    };

    std::span<const solid::WallContour> contours_;
    JetShape jet_;
    std::vector<Group> groups_;
};

}  // namespace gsim::surface
