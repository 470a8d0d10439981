#pragma once

#include <functional>

namespace gsim::cutting {

/// How the material is cut; each shop and material has its own.
struct CutRules {
    double kerf_mm = 0;       ///< > 0
    double speed_mm_min = 0;  ///< On straight lines, > 0.
    double pierce_s = 0;      ///< With the jet on and the nozzle at rest.
    /// The feed on an arc of a radius in mm; everywhere `speed_mm_min` where there is no function.
    std::function<double(double)> feed_on_arc_mm_min;
    /// The feed where the way turns by an angle in rad, for `corner_zone_mm` before and behind the corner.
    std::function<double(double)> feed_in_corner_mm_min;
    double corner_zone_mm = 0;
};

}  // namespace gsim::cutting
