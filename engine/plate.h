#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsim::engine {

/// How a flat part is to be looked at.
struct PlateChoice {
    double tolerance_mm = 0.005;  ///< How far arcs may be off the curves they stand for.
    bool flip = false;            ///< The other side of the plate is the upper one.
    /// "x", "-x", "y" and so on: the largest face that looks along this axis of the file is the upper side;
    /// empty: the largest one.
    std::string up = {};
};

/// The outlines of a flat part's upper side, lines and arcs, y upwards.
struct Plate {
    /// What a piece of an outline comes from.
    struct Source {
        std::string kind = {};  ///< "EDGE", for messages, as are the others but the bevel.
        std::string name = {};
        std::size_t line = 0;  ///< 0: not known.
        double bevel_deg = 0;  ///< How far the side below it leans; above 0 the part is smaller below.
    };
    /// A corner, and how the outline goes on from it: straight, or along an arc.
    struct Vertex {
        std::array<double, 2> position_mm = {};
        double bulge = 0;          ///< Tangent of a quarter of the arc's angle, above 0 counter-clockwise.
        std::uint32_t source = 0;  ///< Index in Plate::sources.
    };
    struct Outline {
        std::vector<Vertex> vertices = {};
        bool closed = false;
    };

    std::vector<Source> sources = {};
    std::vector<Outline> outlines = {};   ///< In any order, closed or not.
    std::vector<std::string> notes = {};  ///< What was left out, in sentences.
    double thickness_mm = 0;              ///< 0: not known.
};

}  // namespace gsim::engine
