#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "controller/services/types.h"

namespace gsim::motion {

/// Limits of each joint, in the order of the joints (mm or rad, s). Joints that have none here are unlimited.
struct JointLimits {
    rrs::JointPos max_speed;
    rrs::JointPos max_acceleration;  ///< Both ways.
};

/// Limits of the motion along the path, whatever the joints could do, the same all along a piece.
struct PathCaps {
    double max_speed = std::numeric_limits<double>::infinity();
    double max_acceleration = std::numeric_limits<double>::infinity();
    double max_deceleration = std::numeric_limits<double>::infinity();
};

/// The joints at a place of a curve, and their first and second derivatives by the length of path.
struct CurvePoint {
    rrs::JointPos q;  ///< Counted from anywhere; only differences matter.
    rrs::JointPos q1;
    rrs::JointPos q2;
};

/// A piece of path in joint space, twice continuously differentiable.
struct Curve {
    double length = 0;
    /// The angle by which the direction turns on the way (an arc: its sweep). It sets how fine the grid is; a
    /// wrong one makes the bound loose or slow, not wrong.
    double turn_rad = 0;
    /// For each joint a value that |q2| does not pass anywhere on the curve. The bound relies on it.
    rrs::JointPos max_q2;
    std::function<CurvePoint(double s)> at;  ///< For s from 0 to length.
};

/// How much work goes into a bound. Finer and longer make it tighter; it is a lower bound with any values.
struct TimeBoundGrid {
    double cell_rad = 1.0 / 64;    ///< A curve is cut into cells that turn by no more than this.
    std::size_t window = 1 << 14;  ///< The most pieces (lines, cells of curves) that wait for later ones.
};

/// The least time in which any controller could go along a path within its limits: time-optimal path
/// parametrisation (Bobrow, Dubowsky, Gibson 1985), where every choice left open falls to the low side.
///
/// The path is at rest at its start, at its end and at stops. In between its speed is continuous, but its
/// direction may jump where two pieces meet, at any speed: what a corner costs is the controller's
/// affair. Jerk is unlimited. Lengths are mm or rad, as the caller has it, one measure from
/// change_measure() to change_measure(). Lines are exact; curves are bounded from below cell by cell.
///
/// A length that is not above 0 adds nothing; a limit that is not above 0 (or not a number) limits nothing.
/// Lengths and limits beyond 1e100 count as 1e100.
class TimeBound {
  public:
    explicit TimeBound(JointLimits limits, TimeBoundGrid grid = {});

    /// Forgets the path; the next one starts at rest.
    void begin();
    /// A piece whose limits are the same all along it: a line, or an arc under limits of its path alone.
    void add_line(double length, const PathCaps& caps);
    /// A line in joint space; `q1` are the derivatives of the joints by the length of path.
    void add_line(double length, const rrs::JointPos& q1, const PathCaps& caps);
    /// A curve, along which a joint's |q2 v^2 + q1 a| keeps its limit of acceleration.
    void add_curve(const Curve& curve, const PathCaps& caps);
    /// The machine is at rest here.
    void stop();
    /// Lengths count differently from here on (mm of the tool, then rad of a rotary joint), so that the
    /// speeds before and after have nothing to do with each other.
    void change_measure();

    /// The bound for the path so far, as if it ended here. Looks through the window. Right within rounding.
    double bound_s() const;

  private:
    /// The limits of something that moves a way between two places: the path, or one joint.
    struct Reach {
        double speed2;
        double acceleration;
        double deceleration;
    };
    /// A joint in a cell of a curve.
    struct JointCell {
        double share2_start;  // q1^2
        double share2_end;
        double gain;      // the most by which the square of its speed can change in the cell
        double distance;  // the least that it travels
        Reach reach;
    };
    /// A line or a cell of a curve; joint_count entries of joints_ belong to it.
    struct Piece {
        double length;
        Reach reach;
        double start_speed2;  // the highest that can be had, looking back
        std::size_t joint_count;
    };
    /// How far a pass from the end of the window has come: what lies before has yet to be looked at.
    struct Backward {
        std::size_t pieces;
        std::size_t joints;
        double speed2;
        double time_s;
    };

    static Reach reach_of(const PathCaps& caps);
    static double least_s(double length, double start2, double end2, const Reach& reach);
    double node_speed2(const CurvePoint& point, const Reach& path) const;
    void add_cell(double length, const CurvePoint& start, const CurvePoint& end, const Curve& curve,
                  const Reach& path);
    bool add_joint_cell(Eigen::Index joint, double length, const CurvePoint& start, const CurvePoint& end,
                        double max_q2);
    void add_piece(const Piece& piece, double start_cap2, double end_cap2);
    Backward at_front(double speed2) const { return {pieces_.size(), joints_.size(), speed2, 0}; }
    void go_back(Backward& pass, std::size_t first) const;
    void settle_all(double end2);
    void settle_older_half();

    JointLimits limits_;
    TimeBoundGrid grid_;
    std::vector<Piece> pieces_;      // the window
    std::vector<JointCell> joints_;  // of its curves, piece after piece
    double front_speed2_ = 0;        // the highest at the end of the last piece, looking back
    double settled_s_ = 0;           // the bound for the pieces that left the window
};

}  // namespace gsim::motion
