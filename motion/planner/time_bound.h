#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "controller/services/types.h"

namespace gsim::motion {

/// Limits of each joint, in the order of the joints (mm or rad, s). Joints without a limit here are
/// unlimited.
struct JointLimits {
    rrs::JointPos max_speed;
    rrs::JointPos max_acceleration;  ///< In both directions.
};

/// Limits of the motion along the path, independent of what the joints could do, the same all along a part.
struct PathCaps {
    double max_speed = std::numeric_limits<double>::infinity();
    double max_acceleration = std::numeric_limits<double>::infinity();
    double max_deceleration = std::numeric_limits<double>::infinity();
};

/// Joints at a position of a curve, and their first and second derivatives by path length.
struct CurvePoint {
    rrs::JointPos q;  ///< Counted from anywhere; only differences matter.
    rrs::JointPos q1;
    rrs::JointPos q2;
};

/// Part of a path in joint space, twice continuously differentiable.
struct Curve {
    double length = 0;
    /// Angle by which the direction turns on the path (an arc: its sweep). It sets how fine the grid is; a
    /// wrong one makes the bound loose or slow, not wrong.
    double turn_rad = 0;
    /// Value for each joint that |q2| does not exceed anywhere on the curve. The bound relies on it.
    rrs::JointPos max_q2;
    std::function<CurvePoint(double s)> at;  ///< For s from 0 to length.
};

/// Effort for a bound. A finer and longer grid makes it tighter; it is a lower bound with any values.
struct TimeBoundGrid {
    double cell_rad = 1.0 / 64;    ///< A curve is cut into cells that turn by no more than this.
    std::size_t window = 1 << 14;  ///< Max number of parts (lines, cells of curves) that wait for later ones.
};

/// Least time in which any controller could move along a path within its limits: time-optimal path
/// parametrisation (Bobrow, Dubowsky, Gibson 1985). Every open choice falls to the low side.
///
/// The path is at standstill at its start, at its end and at stops. Its speed is continuous in between, but
/// its direction may jump at the junction of two parts, at any speed: the cost of a corner depends on the
/// controller. Jerk is unlimited. Lengths are mm or rad, as the caller chooses, one measure from
/// change_measure() to change_measure(). Lines are exact; curves are bounded from below cell by cell.
///
/// A length that is not above 0 adds nothing; a limit that is not above 0 (or not a number) limits nothing.
/// Lengths and limits beyond 1e100 count as 1e100.
class TimeBound {
  public:
    explicit TimeBound(JointLimits limits, TimeBoundGrid grid = {});

    /// Drops the path; the next one starts at standstill.
    void begin();
    /// Adds a part with the same limits all along it: a line, or an arc under limits of only its path.
    void add_line(double length, const PathCaps& caps);
    /// Adds a line in joint space; `q1` are the derivatives of the joints by path length.
    void add_line(double length, const rrs::JointPos& q1, const PathCaps& caps);
    /// Adds a curve, along which a joint's |q2 v^2 + q1 a| keeps its acceleration limit.
    void add_curve(const Curve& curve, const PathCaps& caps);
    /// Notes that the machine is at standstill here.
    void stop();
    /// Changes the measure of lengths from here on (mm of the tool, then rad of a rotary joint), so that the
    /// speeds on both sides are unrelated.
    void change_measure();

    /// Returns the bound for the path so far, as if it ended here. Evaluates the window. The bound is right
    /// within rounding.
    double bound_s() const;

  private:
    /// Limits of something that moves along a path between two positions: the path, or one joint.
    struct MotionLimits {
        double speed2;
        double acceleration;
        double deceleration;
    };
    /// A joint in a cell of a curve.
    struct JointCell {
        double slope_squared_start;  // q1^2
        double slope_squared_end;
        double gain;      // the largest change of its squared speed in the cell
        double distance;  // its smallest travel
        MotionLimits motion_limits;
    };
    /// Line or cell of a curve; joint_count entries of joints_ belong to it.
    struct SubSegment {
        double length;
        MotionLimits motion_limits;
        double start_speed2;  // the highest that can be had, looking back
        std::size_t joint_count;
    };
    /// Progress of a pass from the end of the window; the part before is not checked yet.
    struct BackwardPass {
        std::size_t sub_segments;
        std::size_t joints;
        double speed2;
        double time_s;
    };

    static MotionLimits squared_limits(const PathCaps& caps);
    static double min_time_s(double length, double start2, double end2, const MotionLimits& motion_limits);
    double node_speed2(const CurvePoint& point, const MotionLimits& path) const;
    void add_cell(double length, const CurvePoint& start, const CurvePoint& end, const Curve& curve,
                  const MotionLimits& path);
    bool add_joint_cell(Eigen::Index joint, double length, const CurvePoint& start, const CurvePoint& end,
                        double max_q2);
    void add_sub_segment(const SubSegment& sub_segment, double start_cap2, double end_cap2);
    BackwardPass start_backward_pass(double speed2) const {
        return {sub_segments_.size(), joints_.size(), speed2, 0};
    }
    void run_backward_pass(BackwardPass& pass, std::size_t first) const;
    void finalize_all(double end2);
    void finalize_older_half();

    JointLimits limits_;
    TimeBoundGrid grid_;
    std::vector<SubSegment> sub_segments_;  // the window
    std::vector<JointCell> joints_;         // of its curves, part by part
    double front_speed2_ = 0;               // the highest at the end of the last part, looking back
    double finalized_s_ = 0;                // the bound for the parts that left the window
};

}  // namespace gsim::motion
