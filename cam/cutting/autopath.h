#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"
#include "cam/cutting/cut_program.h"
#include "cam/cutting/layout.h"

namespace gsim::cutting {

struct AutopathOptions {
    double gap_mm = 0.02;      ///< Ends that are nearer than this are joined.
    double lead_mm = 0;        ///< Radius of leads; 0: three kerfs.
    geometry::Point start_mm;  ///< Tool position before the program.
    ProgramOptions program;
};

/// The amount of cutting in a path.
struct CutSummary {
    std::size_t outlines = 0;  ///< Contours of the drawing.
    std::size_t pierces = 0;
    std::size_t without_leads = 0;
    double cut_mm = 0;     ///< Path length with the jet on: leads and contours.
    double travel_mm = 0;  ///< Between the cuts, over the material.
    /// Time at the feeds of the path, without pierces and without acceleration of the machine.
    double cut_s = 0;
    double slowdown_s =
        0;  ///< Part of it: extra time of curves and corners over straight lines of their length.
    double reorientation_s = 0;       ///< Part of it: turning at a fixed position.
    double taper_compensation_s = 0;  ///< Part of it: extra time for taper compensation.
    std::size_t dynamic_pierces = 0;
};

struct Autopath {
    path::Program program;
    CutSummary summary;
    std::vector<std::string> notes;  ///< Messages: deviations of the cuts from the drawing.
    /// The object that each path of the program cuts, for messages; "" if its name alone says it.
    std::vector<std::string> cuts = {};
};

/// Returns the path that cuts a drawing, or an error message that names entities and positions.
Result<Autopath> autopath(drawing::Drawing drawing, const CutRules& rules, const AutopathOptions& options);

}  // namespace gsim::cutting
