#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace gsim::surface {

using Vector = Eigen::Vector3d;

inline Vector vector_of(const std::array<double, 3>& values) {
    return {values[0], values[1], values[2]};
}

/// Where the jet is as it cuts a point of an edge. Directions have the length 1.
struct JetPoint {
    Vector edge_mm;         ///< On the contour, where the jet enters.
    Vector normal;          ///< Of the face there, out of the material.
    Vector tangent;         ///< Along the contour; material to its left.
    Vector aside;           ///< From the edge to the jet's middle, across its axis.
    Vector axis;            ///< From the tip up to the nozzle.
    Vector low_mm;          ///< On the wall's lower edge, where the jet leaves.
    Vector low_aside;       ///< From there to the jet's middle, across its axis.
    double depth_mm = 0;    ///< Of the wall, along the jet.
    std::size_t edge = 0;   ///< Index in the contour.
    bool stays = false;     ///< No move may pass it by.
    double corner_rad = 0;  ///< By how much the way turns in a corner near to it; 0: there is none.
};

/// A corner of a wall's lower edge that closes where the upper edge has none: a jet does not reach into it.
struct LowCorner {
    Vector place_mm;       ///< Of the lower edge.
    double turn_deg = 0;   ///< Of the edge there.
    double stays_mm = 0;   ///< Material between it and the jet.
    std::size_t edge = 0;  ///< Index in the contour, of the edge before it.
};

/// A contour's way of the jet. Material is to its left.
struct JetWay {
    /// The last is where the first is, unless it is open.
    std::vector<JetPoint> points;
    bool is_hole = false;
    bool is_open = false;
    std::string name;                ///< Of the contour, for messages.
    std::vector<std::string> edges;  ///< Their names.
    std::vector<LowCorner> low_corners;
};

/// How a jet is made of a point: its width, and how high the tip stands over the face.
struct JetShape {
    double kerf_mm = 0;
    double height_mm = 0;
};

/// Where the jet's middle is beside the edge.
Vector middle_of(const JetPoint& at, const JetShape& jet);

/// Where it is beside the wall's lower edge.
Vector low_middle_of(const JetPoint& at, const JetShape& jet);

/// The tip, so high over the plane that touches the face at the edge.
Vector tip_of(const JetPoint& at, const JetShape& jet);

}  // namespace gsim::surface
