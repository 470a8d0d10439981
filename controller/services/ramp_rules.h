#pragma once

namespace gsim::rrs {

/// How a move speeds up and slows down, and how much of the acceleration limits its ramps get.
struct RampRules {
    /// True if ramps keep the joints' jerk limits (S-curves); else they are straight.
    bool limit_jerk = false;
    /// Time step of ramps with limit_jerk: the acceleration is constant in each step, and ramps are planned
    /// by a mean acceleration (grblHAL's ENABLE_JERK_ACCELERATION; motion/profile/stepped_ramps.h). 0: exact
    /// S-curves. Needs chords for arcs.
    double step_s = 0;
    /// Share of the acceleration limit that motion round a curve may take; the remainder is for speeding up
    /// and slowing down. From 1 on the two are limited separately: ramps on curves have the full limit, and
    /// the joints more than it. This is so if a controller has a separate limit of the centripetal
    /// acceleration. Infinite: curves do not slow the motion.
    double centripetal_share = 0.866;
    /// Share of the acceleration limits for moves in continuous mode: controllers that overlay the end of a
    /// move with the beginning of the next one give each a part.
    double continuous_acceleration_share = 1;

    bool operator==(const RampRules&) const = default;
};

}  // namespace gsim::rrs
