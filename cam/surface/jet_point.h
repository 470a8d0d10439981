#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace gsim::surface {

using Vector = Eigen::Vector3d;

inline Vector to_vector(const std::array<double, 3>& values) {
    return {values[0], values[1], values[2]};
}

/// The jet's position while it cuts a point of an edge. Directions have the length 1.
struct JetPoint {
    Vector edge_mm;                 ///< On the contour, at the jet's entry.
    Vector normal;                  ///< Face normal there, out of the material.
    Vector tangent;                 ///< Along the contour; material to its left.
    Vector lateral;                 ///< From the edge to the jet's middle, across its axis.
    Vector axis;                    ///< From the TCP up to the nozzle.
    Vector low_mm;                  ///< On the wall's lower edge, at the jet's exit.
    Vector lower_offset_direction;  ///< From there to the jet's middle, across its axis.
    double depth_mm = 0;            ///< Wall depth, along the jet.
    std::size_t edge = 0;           ///< Index in the contour.
    bool is_fixed = false;          ///< No move may pass it by.
    double corner_rad = 0;          ///< Turn of the path in a near corner; 0: no corner.
};

/// A corner of a wall's lower edge that closes although the upper edge has none: a jet does not reach into
/// it.
struct LowerCorner {
    Vector lower_edge_mm;  ///< Point of the lower edge.
    double turn_deg = 0;   ///< Turn of the edge.
    double uncut_mm = 0;   ///< Material between it and the jet.
    std::size_t edge = 0;  ///< Index in the contour, of the edge before it.
};

/// The path of the jet for a contour. Material is to its left.
struct JetPath {
    /// The last point equals the first one, unless the path is open.
    std::vector<JetPoint> points;
    bool is_hole = false;
    bool is_open = false;
    std::string name;                ///< Name of the contour, for messages.
    std::vector<std::string> edges;  ///< Their names.
    std::vector<LowerCorner> lower_corners;
};

/// The shape of the jet at a point: its width, and the height of the TCP over the face.
struct JetShape {
    double kerf_mm = 0;
    double height_mm = 0;
};

/// Returns the position of the jet's center, offset from the edge.
Vector jet_center(const JetPoint& at, const JetShape& jet);

/// Returns its position at the wall's lower edge.
Vector lower_jet_center(const JetPoint& at, const JetShape& jet);

/// Returns the TCP, at this height over the plane that touches the face at the edge.
Vector tcp_position(const JetPoint& at, const JetShape& jet);

}  // namespace gsim::surface
