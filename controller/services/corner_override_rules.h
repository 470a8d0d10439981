#pragma once

namespace gsim::rrs {

/// Automatic corner override (G62 of the 9/Series): the feed at inside corners of cutter compensation. It
/// applies from a distance before the corner to a distance past it.
struct CornerOverrideRules {
    double percent = 100;  ///< Of the programmed feed; 100: as it is.
    double before_mm = 0;
    double after_mm = 0;
    double max_angle_deg = 90;  ///< Max angle between the two moves of a corner to which it applies.

    bool operator==(const CornerOverrideRules&) const = default;
};

}  // namespace gsim::rrs
