#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::solid {

/// A position or a direction in the file's frame, in mm or of length 1.
using Vec3 = std::array<double, 3>;

/// Options for the contours to read from a part's faces. A contour is a closed loop of edges of one face, or
/// a chain of edges requested by their numbers.
struct ContourOptions {
    double tolerance_mm = 0.005;  ///< Max deviation of chords from an edge.
    /// "holes": loops within faces; "outlines": around them; "all"; "edges": those of `edges`, in chains.
    std::string kind = "holes";
    /// Only contours of these faces: by number in the file ("#57"), name, layer or colour; empty: of all.
    std::vector<std::string> faces = {};
    /// Only those with one of these edges: by number in the file ("#95" or "95"); empty: all.
    std::vector<std::string> edges = {};
    /// "z", "-x": only those of faces that face this side of the file, on average along their contour.
    std::string side = "z";
    std::optional<std::array<double, 6>> box_mm = {};  ///< Only those within: low corner, high corner.
    bool along_walls = true;  ///< The jet runs along the walls, which have to be straight in that direction.
};

/// A point of an edge where the jet enters.
struct WallPoint {
    Vec3 position_mm{};
    Vec3 normal{};        ///< Normal of the face, out of the material.
    Vec3 tangent{};       ///< Along the contour; material is to its left, seen from outside.
    Vec3 wall_normal{};   ///< Normal of the face across the edge, out of the material.
    Vec3 along_wall{};    ///< Straight down that face, into the material; 0 0 0 if it is not straight.
    double depth_mm = 0;  ///< Length of that face along it.
    Vec3 exit_normal{};   ///< Wall normal at that end; different if the wall is twisted.
};

struct WallEdge {
    std::string name;                    ///< "edge #12 of the plane face #40": in messages.
    std::vector<WallPoint> points = {};  ///< Two or more.
    /// Distance from the edge, along the jet, to the point where it meets the part again past the wall; 0: it
    /// does not.
    double next_surface_mm = 0;
    std::string label = {};  ///< Its number in the file, "#12"; empty if it has none.
};

/// Edges in order: the end of each is the beginning of the next. The last one ends at the beginning of the
/// first unless the contour is open.
struct WallContour {
    std::string face;  ///< "the plane face #40 at (1, 2, 3)"; of a chain, that of its first edge.
    bool is_hole = false;
    std::vector<WallEdge> edges = {};
    bool is_open = false;
};

/// An edge that is not cut.
struct PartEdge {
    std::string name;                  ///< "edge #12": in messages.
    std::vector<Vec3> points_mm = {};  ///< With chords as close as the tolerance says.
};

/// The contours of a part that may be curved, with the walls below them.
struct WallContours {
    std::vector<WallContour> contours;
    Vec3 low_mm{}, high_mm{};        ///< The box about all bodies.
    std::vector<std::string> notes;  ///< Messages about omitted elements of the part.
    /// For chains of edges: other edges of the part that a jet could hit. Without the lower ends of the
    /// walls.
    std::vector<PartEdge> other_edges = {};
};

/// Reads contours of a STEP or IGES file that contains bodies; docs/autopath.md describes the supported
/// elements. The error message names the file, faces and positions.
Result<WallContours> read_contours(const std::filesystem::path& file, const ContourOptions& options);

}  // namespace gsim::solid
