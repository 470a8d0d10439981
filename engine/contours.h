#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gsim::engine {

/// The contours of a part, which may be curved, that are cut. A contour is a closed loop of edges of one
/// face, or a chain of edges requested by their numbers.
struct ContourSelection {
    double tolerance_mm = 0.005;  ///< Max deviation of chords from an edge.
    /// "holes": loops within faces; "outlines": around them; "all"; "edges": those of `edges`, in chains.
    std::string kind = "holes";
    /// Only contours of these faces: by number in the file ("#57"), name, layer or colour; empty: of all.
    std::vector<std::string> faces = {};
    /// Only those with one of these edges: by number in the file ("#95" or "95"); empty: all.
    std::vector<std::string> edges = {};
    /// "x", "-x", "y" and so on: only those of faces that face this side; empty: any side.
    std::string side = "z";
    /// Only those within: the low corner, then the high one.
    std::optional<std::array<double, 6>> box_mm = {};
    bool along_walls = true;  ///< The jet runs along the walls below the edges, which have to be straight.
};

/// Contours of a part, with the walls below them. Positions and directions are those of its file, in mm or of
/// length 1.
struct Contours {
    using Vec3 = std::array<double, 3>;
    /// A point of an edge at which the jet enters.
    struct Point {
        Vec3 position_mm = {};
        Vec3 normal = {};       ///< Normal of the face, out of the material.
        Vec3 tangent = {};      ///< Along the contour; material is to its left, seen from outside.
        Vec3 wall_normal = {};  ///< Normal of the face across the edge, out of the material.
        Vec3 along_wall = {};   ///< Straight down that face; 0 0 0 if it is not straight.
        double depth_mm = 0;    ///< Length of that face along it.
        Vec3 exit_normal = {};  ///< Wall normal at that end; different if the wall is twisted.
    };
    struct Edge {
        std::string name = {};  ///< For messages.
        std::vector<Point> points = {};
        double next_surface_mm = 0;  ///< Distance along the jet at which it meets the part again; 0: never.
        std::string label = {};      ///< Its number in the file, for ContourSelection::edges; may be empty.
    };
    struct Contour {
        std::string face = {};  ///< For messages.
        bool is_hole = false;
        std::vector<Edge> edges = {};  ///< In order, the end of each the begin of the next.
        bool is_open = false;  ///< A chain of edges; else the last edge ends at the start of the first.
    };
    /// An edge that is not cut.
    struct PartEdge {
        std::string name = {};  ///< For messages.
        std::vector<Vec3> points_mm = {};
    };

    std::vector<Contour> contours = {};
    Vec3 low_mm = {}, high_mm = {};       ///< The box about all bodies.
    std::vector<std::string> notes = {};  ///< Messages about omitted elements.
    /// For chains of edges: other edges of the part that a jet could hit, except the walls' lower ends.
    std::vector<PartEdge> other_edges = {};
};

}  // namespace gsim::engine
