#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsim::engine {

/// Options for reading a flat part.
struct PlateReadOptions {
    double tolerance_mm = 0.005;  ///< Max deviation of arcs from the curves they replace.
    bool flip = false;            ///< The other side of the plate is the upper one.
    /// "x", "-x", "y" and so on: the largest face that faces along this axis of the file is the upper side;
    /// empty: the largest one.
    std::string up = {};
};

/// The outlines of a flat part's upper side, lines and arcs, y upwards.
struct Plate {
    /// The source of a part of an outline.
    struct Source {
        std::string kind = {};  ///< "EDGE", for messages, as are the others but the bevel.
        std::string name = {};
        std::size_t line = 0;  ///< 0: not known.
        double bevel_deg = 0;  ///< Tilt of the side below it; above 0 the part is smaller below.
    };
    /// A corner, and the continuation of the outline: straight, or along an arc.
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
    std::vector<std::string> notes = {};  ///< Messages about omitted elements.
    double thickness_mm = 0;              ///< 0: not known.
};

}  // namespace gsim::engine
