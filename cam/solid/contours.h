#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::solid {

/// A place or a direction in the file's frame, in mm or of length 1.
using Triple = std::array<double, 3>;

/// Which contours of a part's faces are read, and what for. A contour is a closed loop of edges of one face,
/// or a chain of edges that were asked for by their numbers.
struct ContourOptions {
    double tolerance_mm = 0.005;  ///< How far chords from point to point may be off an edge.
    /// "holes": loops within faces; "outlines": around them; "all"; "edges": those of `edges`, in chains.
    std::string kind = "holes";
    /// Only those of these faces: by number in the file ("#57"), name, layer or colour; empty: of all.
    std::vector<std::string> faces = {};
    /// Of these only those that have one of these edges: by number in the file ("#95" or "95"); empty: all.
    std::vector<std::string> edges = {};
    /// "z", "-x": only those of faces that look to this side of the file, on the middle of their contour.
    std::string side = "z";
    std::optional<std::array<double, 6>> box_mm = {};  ///< Only those within: low corner, high corner.
    bool along_walls = true;  ///< The jet goes along the walls, which have to be straight that way.
};

/// A point of an edge where the jet enters.
struct WallPoint {
    Triple position_mm{};
    Triple normal{};       ///< Of the face, out of the material.
    Triple tangent{};      ///< Along the contour; material is to its left, seen from outside.
    Triple wall_normal{};  ///< Of the face across the edge, out of the material.
    Triple along_wall{};   ///< Straight down that face, into the material; 0 0 0 where it is not straight.
    double depth_mm = 0;   ///< How far that face reaches along it.
    Triple far_normal{};   ///< That of the wall there; another one where the wall is twisted.
};

struct WallEdge {
    std::string name;                    ///< "edge #12 of the plane face #40": in messages.
    std::vector<WallPoint> points = {};  ///< Two or more.
    /// How far along the jet, from the edge on, it meets the part again behind the wall; 0: it does not.
    double behind_mm = 0;
    std::string label = {};  ///< Its number in the file, "#12"; empty where it has none.
};

/// Edges in order, the end of each the begin of the next, and of the last that of the first unless it is
/// open.
struct WallContour {
    std::string face;  ///< "the plane face #40 at (1, 2, 3)"; of a chain, that of its first edge.
    bool is_hole = false;
    std::vector<WallEdge> edges = {};
    bool is_open = false;
};

/// An edge beside those that are cut.
struct PartEdge {
    std::string name;                    ///< "edge #12": in messages.
    std::vector<Triple> points_mm = {};  ///< With chords as close as the tolerance says.
};

/// The contours of a part that need not be flat, with the walls below them.
struct WallContours {
    std::vector<WallContour> contours;
    Triple low_mm{}, high_mm{};      ///< The box about all bodies.
    std::vector<std::string> notes;  ///< What of the part is left out, in sentences.
    /// With chains of edges: what else of the part a jet could come into. Without the lower ends of the
    /// walls.
    std::vector<PartEdge> other_edges = {};
};

/// Reads contours of a STEP or IGES file with bodies in it; docs/autopath.md says what is understood. The
/// error is a sentence that names the file, faces and places.
tl::expected<WallContours, std::string> read_contours(const std::filesystem::path& file,
                                                      const ContourOptions& options);

}  // namespace gsim::solid
