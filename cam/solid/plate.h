#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "cam/drawing/drawing.h"

namespace gsim::solid {

struct PlateOptions {
    double tolerance_mm = 0.005;  ///< Max deviation of arcs from the curves they replace.
    bool flip = false;            ///< The other side of the plate is the upper one.
    /// "x", "-x", "y" and so on: bodies lie in the plane of the largest face that faces along this axis of
    /// the file; empty: of the largest one.
    std::string facing_axis;
};

/// A flat part, or several of one thickness in one plane.
struct Plate {
    /// The outlines of the upper side, each edge with the bevel of the adjacent side face. If the upper side
    /// faces along Z, positions are those of the file.
    drawing::Drawing drawing;
    double thickness_mm = 0;  ///< 0 if the file has no bodies, only curves or flat surfaces.
};

/// Reads the outlines of a STEP or IGES file; docs/autopath.md describes the supported elements. The error is
/// a message that names the file, entities and positions.
Result<Plate> read_plate(const std::filesystem::path& file, const PlateOptions& options);

}  // namespace gsim::solid
