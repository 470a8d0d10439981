#pragma once

#include <span>
#include <string>
#include <vector>

#include "cam/solid/contours.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Which edges of walls: where the jet enters, or where it leaves.
enum class WallEnd { upper, lower };

/// All edges of what is cut, to be asked how near a jet comes to them, and others of the part.
class NearEdges {
  public:
    NearEdges(std::span<const solid::WallContour> contours, const JetShape& jet,
              WallEnd which = WallEnd::upper, std::span<const solid::PartEdge> others = {});

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
        const std::string* edge = nullptr;  ///< Its name.
    };
    struct Group {
        Vector middle;
        double radius_mm = 0;
        std::vector<Place> places;
    };

    void add_line(const Vector& from, const Vector& to, const std::string& edge, std::vector<Place>& places);

    JetShape jet_;
    std::vector<Group> groups_;
};

}  // namespace gsim::surface
