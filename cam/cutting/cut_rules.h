#pragma once

#include <functional>
#include <optional>

namespace gsim::cutting {

/// Rules for cutting the material; each shop and material has its own.
struct CutRules {
    double kerf_mm = 0;       ///< > 0
    double speed_mm_min = 0;  ///< On straight lines, > 0.
    double pierce_s = 0;      ///< With the jet on and the nozzle at standstill.
    /// The same while the nozzle moves back and forth at the beginning of the lead; none: it is at
    /// standstill. It is also at standstill without a lead or if the lead is shorter than the kerf.
    std::optional<double> dynamic_pierce_s = {};
    /// The feed on an arc of a radius in mm; `speed_mm_min` everywhere without a function.
    std::function<double(double)> feed_on_arc_mm_min = {};
    /// The feed if the path turns by an angle in rad, for `corner_zone_mm` on both sides of the corner.
    std::function<double(double)> feed_in_corner_mm_min = {};
    double corner_zone_mm = 0;
    /// The feed on a straight line if the jet passes through so many mm; `speed_mm_min` everywhere without a
    /// function.
    std::function<double(double)> speed_at_depth_mm_min = {};
    /// Taper compensation: tilt of the jet over the waste, in deg, at a feed in mm/min. It gives a side its
    /// intended shape although the kerf gets narrower downwards. Without a function, sides keep their taper.
    std::function<double(double)> taper_compensation_deg = {};
};

}  // namespace gsim::cutting
