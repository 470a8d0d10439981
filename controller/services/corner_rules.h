#pragma once

namespace gsim::rrs {

/// Rule that limits the speed at a corner that is passed without a stop.
enum class CornerRule {
    stop,
    velocity_step,       ///< Limited jump of each joint's speed (its max_speed_step, or speed_step_s).
    junction_deviation,  ///< The speed on an arc that would miss the corner by junction_deviation_mm.
    parabolic_blend,     ///< Rounded within a tolerance, on a parabola: the acceleration is constant.
    smooth_blend,        ///< Rounded within a tolerance, with an acceleration that grows and falls.
};

/// True if the rule takes the tool off the programmed path.
constexpr bool is_blend(CornerRule rule) {
    return rule == CornerRule::parabolic_blend || rule == CornerRule::smooth_blend;
}

/// How the controller passes the corners between moves.
struct CornerRules {
    CornerRule continuous = CornerRule::stop;  ///< In continuous mode (G64).
    CornerRule exact_path = CornerRule::stop;  ///< In exact path mode (G61).
    /// True if the controller has no exact path mode: a request for it is an exact stop, at smooth junctions
    /// or not.
    bool exact_path_stops = false;
    double junction_deviation_mm = 0.01;
    /// Max distance of a blend from its corner if the program sets no tolerance (G64 P); 0: corners are
    /// exact.
    double blend_tolerance_mm = 0.05;
    double blend_tolerance_deg = 0.5;  ///< The same of the rotary joints, whatever the program says.
    /// Permitted jump of speed of a joint without a max_speed_step, as the time in which its acceleration
    /// makes this jump.
    double speed_step_s = 0.01;
    bool stop_between_rapid_and_feed = true;

    bool operator==(const CornerRules&) const = default;
};

}  // namespace gsim::rrs
