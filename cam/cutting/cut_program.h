#pragma once

#include <span>
#include <string>
#include <vector>

#include "cam/cutting/cut_rules.h"
#include "cam/cutting/lead.h"
#include "toolpath/model/path.h"

namespace gsim::cutting {

/// Heights of the tool apart from the contours, above the material's upper side.
struct ToolHeights {
    double safe_mm = 25;  ///< For moves between cuts.
    double cut_mm = 3;    ///< Height of the nozzle's TCP, jet on.
};

struct ProgramOptions {
    std::string name;
    ToolHeights heights;
    /// Position of the drawing's origin, on the material's upper side, in the work frame.
    path::Vector origin_mm{};
    /// Tilt of the jet during a cut, in deg, along edges without their own bevel. If it is above 0, the part
    /// is smaller at its lower side. The tool is upright if it is 0.
    double bevel_deg = 0;
    double turn_feed_deg_min = 3600;  ///< Feed of the tilt's turn in corners.
};

/// A program that makes cuts.
struct CutProgram {
    path::Program program;
    double reorientation_s = 0;  ///< With the jet on, while the tool turns at a fixed position.
    std::size_t dynamic_pierces = 0;
};

/// Returns the program that makes the cuts in that order, with a path for each: rapid to its pierce at the
/// safe height, down, jet and abrasive on, pierce, lead-in, contour, lead-out, off, up.
///
/// `bevels_deg` contains the bevels of the sources of the contours (geometry::Vertex::source); it may be
/// empty. A tilted jet passes through the contour on the material's upper side, so the nozzle's TCP is offset
/// from it. The offset is increased by the amount that makes the kerf, which is wider there, still end at the
/// part.
CutProgram cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                       const CutRules& rules, std::span<const double> bevels_deg,
                       const ProgramOptions& options);

}  // namespace gsim::cutting
