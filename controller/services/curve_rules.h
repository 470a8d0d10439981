#pragma once

namespace gsim::rrs {

/// Chords by which the controller replaces curves.
struct CurveRules {
    /// Distance from the circle of the chords that replace an arc; 0: arcs stay arcs.
    double arc_chord_tolerance_mm = 0;
    /// Max distance of chords from a spline. Steps of the parameter are halved until the middle of each is
    /// off the curve by this at most, in the sum of its coordinates (grblHAL). 0: pairs of arcs, as in
    /// LinuxCNC.
    double spline_chord_tolerance_mm = 0;
    /// True if the feed of an arc in inverse time mode counts once for each chord, in mm/min (grbl 1.1).
    bool inverse_time_per_chord = false;

    bool operator==(const CurveRules&) const = default;
};

}  // namespace gsim::rrs
