#pragma once

#include <functional>
#include <optional>

namespace gsim::cutting {

/// How the material is cut; each shop and material has its own.
struct CutRules {
    double kerf_mm = 0;       ///< > 0
    double speed_mm_min = 0;  ///< On straight lines, > 0.
    double pierce_s = 0;      ///< With the jet on and the nozzle at rest.
    /// The same while it goes to and fro at the beginning of the lead; none: it rests. Where there is no
    /// lead, or one that is shorter than the kerf, it rests all the same.
    std::optional<double> moving_pierce_s = {};
    /// The feed on an arc of a radius in mm; everywhere `speed_mm_min` where there is no function.
    std::function<double(double)> feed_on_arc_mm_min = {};
    /// The feed where the way turns by an angle in rad, for `corner_zone_mm` before and behind the corner.
    std::function<double(double)> feed_in_corner_mm_min = {};
    double corner_zone_mm = 0;
    /// The feed on a straight line where the jet goes through so many mm; everywhere `speed_mm_min` where
    /// there is no function.
    std::function<double(double)> speed_at_depth_mm_min = {};
    /// How far the jet leans over the waste, in deg, at a feed in mm/min, so that the kerf, which closes
    /// downwards, leaves a side as it is meant to be; where there is no function sides keep their taper.
    std::function<double(double)> straightening_lean_deg = {};
};

}  // namespace gsim::cutting
