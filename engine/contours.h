#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gsim::engine {

/// Which contours of a part are cut that need not be flat. A contour is a closed loop of edges of one face,
/// or a chain of edges that are asked for by their numbers.
struct ContourChoice {
    double tolerance_mm = 0.005;  ///< How far chords from point to point may be off an edge.
    /// "holes": loops within faces; "outlines": around them; "all"; "edges": those of `edges`, in chains.
    std::string kind = "holes";
    /// Only those of these faces: by number in the file ("#57"), name, layer or colour; empty: of all.
    std::vector<std::string> faces = {};
    /// Of these only those that have one of these edges: by number in the file ("#95" or "95"); empty: all.
    std::vector<std::string> edges = {};
    /// "x", "-x", "y" and so on: only those of faces that look to this side; empty: to any.
    std::string side = "z";
    /// Only those within: the low corner, then the high one.
    std::optional<std::array<double, 6>> box_mm = {};
    bool along_walls = true;  ///< The jet goes along the walls below the edges, which have to be straight.
};

/// Contours of a part, with the walls below them. Places and directions are those of its file, in mm or of
/// length 1.
struct Contours {
    using Triple = std::array<double, 3>;
    /// A point of an edge where the jet enters.
    struct Point {
        Triple position_mm = {};
        Triple normal = {};       ///< Of the face, out of the material.
        Triple tangent = {};      ///< Along the contour; material is to its left, seen from outside.
        Triple wall_normal = {};  ///< Of the face across the edge, out of the material.
        Triple along_wall = {};   ///< Straight down that face; 0 0 0 where it is not straight.
        double depth_mm = 0;      ///< How far that face reaches along it.
        Triple far_normal = {};   ///< That of the wall there; another one where the wall is twisted.
    };
    struct Edge {
        std::string name = {};  ///< For messages.
        std::vector<Point> points = {};
        double behind_mm = 0;    ///< How far along the jet it meets the part again; 0: it does not.
        std::string label = {};  ///< Its number in the file, for ContourChoice::edges; may be empty.
    };
    struct Contour {
        std::string face = {};  ///< For messages.
        bool is_hole = false;
        std::vector<Edge> edges = {};  ///< In order, the end of each the begin of the next.
        bool is_open = false;          ///< A chain of edges; else the last edge ends where the first begins.
    };
    /// An edge beside those that are cut.
    struct PartEdge {
        std::string name = {};  ///< For messages.
        std::vector<Triple> points_mm = {};
    };

    std::vector<Contour> contours = {};
    Triple low_mm = {}, high_mm = {};     ///< The box about all bodies.
    std::vector<std::string> notes = {};  ///< What was left out, in sentences.
    /// With chains of edges: what else of the part a jet could come into, but for the walls' lower ends.
    std::vector<PartEdge> other_edges = {};
};

}  // namespace gsim::engine
