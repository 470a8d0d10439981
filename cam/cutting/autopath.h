#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/cutting/cut_program.h"
#include "cam/cutting/layout.h"

namespace gsim::cutting {

struct AutopathOptions {
    double gap_mm = 0.02;      ///< Ends that are nearer than this are joined.
    double lead_mm = 0;        ///< Radius of leads; 0: three kerfs.
    geometry::Point start_mm;  ///< Where the tool is before.
    ProgramOptions program;
};

/// What a path cuts.
struct CutSummary {
    std::size_t outlines = 0;  ///< Contours of the drawing.
    std::size_t pierces = 0;
    std::size_t without_leads = 0;
    double cut_mm = 0;     ///< Way with the jet on: leads and contours.
    double travel_mm = 0;  ///< Between the cuts, over the material.
    /// At the feeds of the path, without pierces or the time that a machine takes to speed up.
    double cut_s = 0;
    double slower_s = 0;  ///< Of that, what curves and corners take more than straight lines of their length.
    double turning_s = 0;        ///< Of that, turning in one place.
    double straightening_s = 0;  ///< Of that, what leaning against the taper adds.
    std::size_t moving_pierces = 0;
};

struct Autopath {
    path::Program program;
    CutSummary summary;
    std::vector<std::string> notes;  ///< Sentences: what is not cut as it was drawn.
    /// What each path of the program cuts, for messages; "" where that is said by its name alone.
    std::vector<std::string> cuts = {};
};

/// From a drawing to the path that cuts it. The error is a sentence that names entities and places.
tl::expected<Autopath, std::string> autopath(drawing::Drawing drawing, const CutRules& rules,
                                             const AutopathOptions& options);

}  // namespace gsim::cutting
