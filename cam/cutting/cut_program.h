#pragma once

#include <span>
#include <string>
#include <vector>

#include "cam/cutting/cut_rules.h"
#include "cam/cutting/lead.h"
#include "toolpath/model/path.h"

namespace gsim::cutting {

/// Where the tool goes besides the contours, above the material's upper side.
struct ToolHeights {
    double safe_mm = 25;  ///< Of ways between cuts.
    double cut_mm = 3;    ///< Of the nozzle's tip while the jet is on.
};

struct ProgramOptions {
    std::string name;
    ToolHeights heights;
    /// Where the drawing's origin, on the material's upper side, lies in the work frame.
    path::Vector origin_mm{};
    /// How far the jet leans while it cuts, in deg, along edges that have no bevel of their own; above 0 the
    /// part is smaller at its lower side. The tool stands upright where it is 0.
    double bevel_deg = 0;
    double turn_feed_deg_min = 3600;  ///< Of the lean's turn in corners.
};

/// What makes cuts.
struct CutProgram {
    path::Program program;
    double turning_s = 0;  ///< With the jet on, while the tool turns in one place.
    std::size_t moving_pierces = 0;
};

/// The program that makes the cuts in that order, a path for each: rapid to its pierce at the safe height,
/// down, jet and abrasive on, pierce, lead-in, contour, lead-out, off, up.
///
/// `bevels_deg` has the bevels of what the contours come from (geometry::Vertex::source); it may be empty. A
/// jet that leans goes through the contour on the material's upper side, so the nozzle's tip is beside it, by
/// so much further that the kerf, which is wider there, still ends at the part.
CutProgram cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                       const CutRules& rules, std::span<const double> bevels_deg,
                       const ProgramOptions& options);

}  // namespace gsim::cutting
