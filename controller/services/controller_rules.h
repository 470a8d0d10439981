#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include "controller/services/override_rules.h"

namespace gsim::rrs {

/// Which planner plans for a controller. Another one is another implementation of motion::MotionModel.
enum class PlannerKind {
    rest_to_rest,  ///< Each move begins and ends at rest.
    look_ahead,    ///< Speeds at the corners by one of the CornerRules, over a window of blocks.
    linuxcnc,      ///< The trajectory planner of LinuxCNC: blend arcs, parabolic blends, servo cycles.
    klipper,       ///< The look-ahead of Klipper: square corner velocity, minimum cruise ratio.
};

/// Whose planner PlannerKind::linuxcnc is.
enum class LinuxcncRelease {
    v2_9,
    v2_10,  ///< With straight ramps, or S-curves where the jerk is limited.
};

/// What limits the speed at a corner that is passed without a stop.
enum class CornerRule {
    stop,
    velocity_step,       ///< No joint's speed may jump by more than it stands (its max_speed_step, or
                         ///< speed_step_s).
    junction_deviation,  ///< The speed on an arc that would miss the corner by junction_deviation_mm.
    parabolic_blend,     ///< Rounded within a tolerance, on a parabola: the acceleration is constant.
    smooth_blend,        ///< Rounded within a tolerance, with an acceleration that grows and falls.
};

/// How the tool turns in linear and circular moves that are not rapid.
enum class OrientationRule {
    joints,        ///< By the angles of the rotary joints.
    great_circle,  ///< Its direction goes along the great circle, evenly with the length of the way.
};

/// What the speed of a block in the look-ahead window counts along.
enum class PathMeasure {
    tool,      ///< The tool's way; rotary axes go along in proportion.
    all_axes,  ///< The norm of all axes' ways, a degree as a millimetre (grbl's planner).
};

/// When the control waits at a word until all moves have been made.
enum class StopRule {
    always,
    on_change,  ///< Where the word changes something.
    never,
};

/// Whether the rule takes the tool off the programmed way.
constexpr bool is_blend(CornerRule rule) {
    return rule == CornerRule::parabolic_blend || rule == CornerRule::smooth_blend;
}

/// The rules by which a controller turns moves into motion: what its maker has built in and an operator
/// cannot change. Read from a controller file, each key open to change in a machine file; see
/// docs/machine-file.md.
struct ControllerRules {
    std::string model = "exact-stop";
    PlannerKind planner = PlannerKind::rest_to_rest;
    LinuxcncRelease linuxcnc_release = LinuxcncRelease::v2_9;

    /// Blocks that are known ahead, the one under way included; the newest of them is planned to end at rest.
    std::size_t look_ahead_blocks = 100;
    /// Corners in continuous mode (G64), and in exact path mode (G61).
    CornerRule corner = CornerRule::stop;
    CornerRule exact_path_corner = CornerRule::stop;
    /// The control has no exact path mode: what asks for it is an exact stop, smooth joints or not.
    bool exact_path_stops = false;
    double junction_deviation_mm = 0.01;
    /// How far a blend may miss its corner where the program sets no tolerance (G64 P); 0: corners are exact.
    double blend_tolerance_mm = 0.05;
    double blend_tolerance_deg = 0.5;  ///< The same of the rotary joints, whatever the program says.
    /// The jump of speed that a joint without a max_speed_step stands: what its acceleration makes in this
    /// time.
    double speed_step_s = 0.01;
    bool stop_between_rapid_and_feed = true;
    /// Ramps keep the joints' jerk limits (S-curves); else they are straight.
    bool limit_jerk = false;
    /// With limit_jerk: ramps are driven in steps of this time, the acceleration the same in each, and
    /// planned by a mean acceleration (grblHAL's ENABLE_JERK_ACCELERATION; motion/profile/stepped_ramps.h).
    /// 0: exact S-curves. Needs chords for arcs.
    double ramp_step_s = 0;
    PathMeasure path_measure = PathMeasure::tool;
    /// What F counts along in a move of rotary axes and of others, where path_measure is all_axes (grblHAL:
    /// $701 = 1 is the tool's way).
    PathMeasure feed_measure = PathMeasure::tool;
    /// Share of the acceleration limit that the way round a curve may take; what is left of it is for
    /// speeding up and slowing down. From 1 on the two are limited by themselves: ramps on curves have all of
    /// the limit, and the joints more than it (as where a control's limit of the centripetal acceleration is
    /// a figure of its own). Infinite: curves do not slow the motion.
    double centripetal_share = 0.866;
    /// Share of the acceleration limits for moves in continuous mode: controls that overlay the end of a move
    /// with the beginning of the next one give each a part.
    double continuous_acceleration_share = 1;
    /// Of PlannerKind::look_ahead: what the control takes to make a block ready, so that no move is made in
    /// less; 0: no time.
    double block_time_s = 0;
    /// Arcs become chords that lie off the circle by this much; 0: they stay arcs.
    double arc_chord_tolerance_mm = 0;
    /// Splines become chords by halving steps of the parameter until the middle of each lies off the curve by
    /// this much at most, in the sum of its coordinates (grblHAL); 0: pairs of arcs, as in LinuxCNC.
    double spline_chord_tolerance_mm = 0;
    /// Of PlannerKind::klipper: arcs become the greatest number of equal chords that are as long as this at
    /// least on the arc; 0: the control knows no arcs.
    double arc_resolution_mm = 0;
    /// Of PlannerKind::klipper: the speed at a right angle.
    double square_corner_velocity_mm_s = 5;
    /// Of PlannerKind::klipper: the share of a move, or of several that go faster and slower again, that is
    /// passed at one speed at least.
    double minimum_cruise_ratio = 0.5;
    /// How far G10 of the dialect `klipper` draws the filament back, and how fast; 0: the control does not.
    double retract_length_mm = 0;
    double retract_speed_mm_s = 20;
    /// How much farther G11 pushes it than G10 drew it back, and how fast.
    double unretract_extra_length_mm = 0;
    double unretract_speed_mm_s = 10;
    /// The feed of an arc in inverse time mode counts once for each chord, in mm/min (grbl 1.1).
    bool inverse_time_of_chords = false;
    /// How far the tip may leave its way where the joints go curved ways to keep it there (tool-centre-point
    /// control, Cartesian targets): these ways become lines of the joints.
    double tcp_tolerance_mm = 0.001;
    OrientationRule orientation = OrientationRule::joints;
    /// The joints beside the tool's path (rotary ones, and a second set of linear ones) arrive with it, but
    /// by ramps of their own; else all joints of a linear or circular move go in proportion at every instant.
    /// Of PlannerKind::rest_to_rest alone: the others know no such moves.
    bool own_ramps = false;
    /// All joints of a rapid move arrive together, in proportion; else each goes by its own limits and
    /// arrives when it does, so that the way is no straight line ("dog-leg"). Then of
    /// PlannerKind::rest_to_rest alone.
    bool interpolated_rapids = true;
    double least_feed_mm_min = 0;  ///< A lower one is raised to it.

    double settle_s = 0;  ///< Time at each exact stop until the axes are in position.
    /// Gain of the axes' position loops: they follow with a speed of this times the following error. Exact
    /// stops wait, in front of settle_s, until the error is within the band of each joint; 0: they do not.
    double position_gain_1_s = 0;
    double in_position_mm = 0.01;
    double in_position_deg = 0.01;
    /// Where this control differs from others in what stops it, by word as it is printed ("G92.1";
    /// docs/stops.md).
    std::map<std::string, StopRule, std::less<>> stops;
    OverrideRules overrides = {};
    // Of the drilling cycles of RS274/NGC:
    double peck_clearance_mm = 0.254;  ///< G73 backs off by it, and G83 comes back by rapid to as far above.
    double peck_dwell_s = 0;           ///< G73 and G83 wait at the bottom of each peck.
    bool pecks_feed_down =
        false;                  ///< G83 leaves the hole as after the last peck, and feeds all the way down.
    bool boring_cycles = true;  ///< G85, G86 and G89 bore; else they are read, and nothing moves.
    double rest_s = 0;        ///< Time at each stop that waits for the program's next block (dwell, M code).
    double dwell_step_s = 0;  ///< Dwells are raised to a multiple of it; 0: they are not.
    double servo_period_s = 0;  ///< Of the controller's position loop; 0: continuous.

    /// Automatic corner override (G62 of the 9/Series): the feed at inside corners of cutter compensation, in
    /// percent of the programmed one (100: as it is), from so far before the corner to so far behind it,
    /// where the angle between the two moves is at most corner_override_angle_deg.
    double corner_override_percent = 100;
    double corner_override_before_mm = 0;
    double corner_override_after_mm = 0;
    double corner_override_angle_deg = 90;

    /// Whether the planner can do OrientationRule::great_circle: one that knows lines in joint space alone
    /// cannot.
    bool has_great_circles() const {
        return planner != PlannerKind::linuxcnc && planner != PlannerKind::klipper &&
               arc_chord_tolerance_mm <= 0;
    }

    bool operator==(const ControllerRules&) const = default;
};

}  // namespace gsim::rrs
