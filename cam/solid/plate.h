#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "cam/drawing/drawing.h"

namespace gsim::solid {

struct PlateOptions {
    double tolerance_mm = 0.005;  ///< How far arcs may be off the curves they stand for.
    bool flip = false;            ///< The other side of the plate is the upper one.
    /// "x", "-x", "y" and so on: bodies lie in the plane of the largest face that looks along this axis of
    /// the file; empty: of the largest one.
    std::string along;
};

/// A flat part, or several of one thickness in one plane.
struct Plate {
    /// The outlines of the upper side, each edge with the bevel of the side face at it. Where the upper side
    /// looks along Z, places are those of the file.
    drawing::Drawing drawing;
    double thickness_mm = 0;  ///< 0 where the file has no bodies, but curves or flat surfaces alone.
};

/// Reads the outlines of a STEP or IGES file; docs/autopath.md says what is understood. The error is a
/// sentence that names the file, entities and places.
tl::expected<Plate, std::string> read_plate(const std::filesystem::path& file, const PlateOptions& options);

}  // namespace gsim::solid
