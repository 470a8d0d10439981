#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include "controller/services/override_rules.h"

namespace gsim::rrs {

/// Planner of a controller. Another one is another implementation of motion::MotionModel.
enum class PlannerKind {
    rest_to_rest,  ///< Each move begins and ends at standstill.
    look_ahead,    ///< Speeds at the corners by one of the CornerRules, over a window of blocks.
    linuxcnc,      ///< The trajectory planner of LinuxCNC: blend arcs, parabolic blends, servo cycles.
    klipper,       ///< The look-ahead of Klipper: square corner velocity, minimum cruise ratio.
};

/// LinuxCNC release of the planner PlannerKind::linuxcnc.
enum class LinuxcncRelease {
    v2_9,
    v2_10,  ///< With straight ramps, or S-curves if the jerk is limited.
};

/// Rule that limits the speed at a corner that is passed without a stop.
enum class CornerRule {
    stop,
    velocity_step,       ///< Limited jump of each joint's speed (its max_speed_step, or speed_step_s).
    junction_deviation,  ///< The speed on an arc that would miss the corner by junction_deviation_mm.
    parabolic_blend,     ///< Rounded within a tolerance, on a parabola: the acceleration is constant.
    smooth_blend,        ///< Rounded within a tolerance, with an acceleration that grows and falls.
};

/// Orientation of the tool in linear and circular moves that are not rapid.
enum class OrientationRule {
    joints,        ///< By the angles of the rotary joints.
    great_circle,  ///< Its direction follows the great circle, evenly with the length of the path.
};

/// Path along which the speed of a block in the look-ahead window is measured.
enum class PathMeasure {
    tool,      ///< The tool's path; rotary axes move in proportion.
    all_axes,  ///< The norm of all axes' distances, a degree as a millimetre (grbl's planner).
};

/// Condition under which the controller waits at a word until all moves have been made.
enum class StopRule {
    always,
    on_change,  ///< If the word changes something.
    never,
};

/// True if the rule takes the tool off the programmed path.
constexpr bool is_blend(CornerRule rule) {
    return rule == CornerRule::parabolic_blend || rule == CornerRule::smooth_blend;
}

/// The rules by which a controller turns moves into motion: those built in by its maker, which an operator
/// cannot change. Read from a controller file; a machine file may change each key; see docs/machine-file.md.
struct ControllerRules {
    std::string model = "exact-stop";
    PlannerKind planner = PlannerKind::rest_to_rest;
    LinuxcncRelease linuxcnc_release = LinuxcncRelease::v2_9;

    /// Number of blocks known ahead, including the current one; the newest of them is planned to end at
    /// standstill.
    std::size_t look_ahead_blocks = 100;
    /// Corner rules in continuous mode (G64), and in exact path mode (G61).
    CornerRule corner = CornerRule::stop;
    CornerRule exact_path_corner = CornerRule::stop;
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
    /// True if ramps keep the joints' jerk limits (S-curves); else they are straight.
    bool limit_jerk = false;
    /// Time step of ramps with limit_jerk: the acceleration is constant in each step, and ramps are planned
    /// by a mean acceleration (grblHAL's ENABLE_JERK_ACCELERATION; motion/profile/stepped_ramps.h). 0: exact
    /// S-curves. Needs chords for arcs.
    double ramp_step_s = 0;
    PathMeasure path_measure = PathMeasure::tool;
    /// Path along which F is measured in a move of rotary axes and of others, if path_measure is all_axes
    /// (grblHAL: $701 = 1 is the tool's path).
    PathMeasure feed_measure = PathMeasure::tool;
    /// Share of the acceleration limit that motion round a curve may take; the remainder is for speeding up
    /// and slowing down. From 1 on the two are limited separately: ramps on curves have the full limit, and
    /// the joints more than it. This is so if a controller has a separate limit of the centripetal
    /// acceleration. Infinite: curves do not slow the motion.
    double centripetal_share = 0.866;
    /// Share of the acceleration limits for moves in continuous mode: controllers that overlay the end of a
    /// move with the beginning of the next one give each a part.
    double continuous_acceleration_share = 1;
    /// For PlannerKind::look_ahead: time that the controller needs to prepare a block, so that no move takes
    /// less; 0: no time.
    double block_time_s = 0;
    /// Distance from the circle of the chords that replace an arc; 0: arcs stay arcs.
    double arc_chord_tolerance_mm = 0;
    /// Max distance of chords from a spline. Steps of the parameter are halved until the middle of each is
    /// off the curve by this at most, in the sum of its coordinates (grblHAL). 0: pairs of arcs, as in
    /// LinuxCNC.
    double spline_chord_tolerance_mm = 0;
    /// For PlannerKind::klipper: min length on the arc of a chord. Arcs become the largest number of equal
    /// chords of that length; 0: the controller knows no arcs.
    double arc_resolution_mm = 0;
    /// For PlannerKind::klipper: the speed at a right angle.
    double square_corner_velocity_mm_s = 5;
    /// For PlannerKind::klipper: min share of a move, or of several that speed up and slow down again, that
    /// is passed at one speed.
    double minimum_cruise_ratio = 0.5;
    /// Distance by which G10 of the dialect `klipper` retracts the filament, and its speed; 0: the controller
    /// does not.
    double retract_length_mm = 0;
    double retract_speed_mm_s = 20;
    /// Additional distance by which G11 pushes it farther than G10 retracted it, and its speed.
    double unretract_extra_length_mm = 0;
    double unretract_speed_mm_s = 10;
    /// True if the feed of an arc in inverse time mode counts once for each chord, in mm/min (grbl 1.1).
    bool inverse_time_per_chord = false;
    /// Max distance of the TCP from its path if the joints move on curved paths to keep it there
    /// (tool-centre-point control, Cartesian targets): these paths become lines of the joints.
    double tcp_tolerance_mm = 0.001;
    OrientationRule orientation = OrientationRule::joints;
    /// True if the joints outside the tool's path (rotary ones, and a second set of linear ones) arrive with
    /// it, but by independent ramps. Else all joints of a linear or circular move run in proportion at every
    /// instant. Only for PlannerKind::rest_to_rest: the others know no such moves.
    bool independent_ramps = false;
    /// True if all joints of a rapid move arrive together, in proportion. Else each moves by its own limits
    /// and arrives at its own time, so that the path is not a straight line ("dog-leg"). The latter is only
    /// for PlannerKind::rest_to_rest.
    bool interpolated_rapids = true;
    double min_feed_mm_min = 0;  ///< A lower one is raised to it.

    double settle_s = 0;  ///< Time at each exact stop until the axes are in position.
    /// Gain of the axes' position loops: they follow with a speed of this times the following error. Exact
    /// stops wait, before settle_s, until the error is within the band of each joint; 0: they do not.
    double position_gain_1_s = 0;
    double in_position_mm = 0.01;
    double in_position_deg = 0.01;
    /// Differences of this controller from others in the words that stop it, by word as it is printed
    /// ("G92.1"; docs/stops.md).
    std::map<std::string, StopRule, std::less<>> stops;
    OverrideRules overrides = {};
    // Drilling cycles of RS274/NGC:
    double peck_clearance_mm = 0.254;  ///< G73 backs off by it, and G83 comes back by rapid to as far above.
    double peck_dwell_s = 0;           ///< G73 and G83 wait at the bottom of each peck.
    bool pecks_feed_down =
        false;  ///< G83 leaves the hole as after the last peck, and feeds the full distance down.
    bool boring_cycles = true;  ///< G85, G86 and G89 bore; else they are read without motion.
    double dwell_s = 0;       ///< Time at each stop that waits for the program's next block (dwell, M code).
    double dwell_step_s = 0;  ///< Dwells are raised to a multiple of it; 0: they are not.
    double servo_period_s = 0;  ///< Period of the controller's position loop; 0: continuous.

    /// Automatic corner override (G62 of the 9/Series): the feed at inside corners of cutter compensation, in
    /// percent of the programmed one (100: as it is). It applies from a distance before the corner to a
    /// distance after it, if the angle between the two moves is at most corner_override_angle_deg.
    double corner_override_percent = 100;
    double corner_override_before_mm = 0;
    double corner_override_after_mm = 0;
    double corner_override_angle_deg = 90;

    /// True if the planner supports OrientationRule::great_circle; one that knows only lines in joint space
    /// does not.
    bool has_great_circles() const {
        return planner != PlannerKind::linuxcnc && planner != PlannerKind::klipper &&
               arc_chord_tolerance_mm <= 0;
    }

    bool operator==(const ControllerRules&) const = default;
};

}  // namespace gsim::rrs
