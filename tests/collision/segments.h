#pragma once

#include <cmath>
#include <limits>

#include "machine/file/machine_file.h"
#include "motion/segment/segment.h"

namespace gsim::cell {

/// Speed and acceleration of a law.
struct Pace {
    double speed;
    double acceleration = std::numeric_limits<double>::infinity();
};

/// The machine that is built in, without its bodies.
inline machine::Machine af5() {
    machine::Machine machine = machine::read_machine(machine::built_in_machine_toml(), "af5.toml").value();
    machine.shapes.clear();
    machine.ignored.clear();
    return machine;
}

/// Joint values of the built-in machine, in mm and rad. Its tool points down, along -Z.
inline rrs::JointPos joints(double x, double y, double z, double b = 0, double c = 0) {
    rrs::JointPos values(5);
    values << x, y, z, b, c;
    return values;
}

/// Returns a line with all joints in proportion; the law is along the norm of their distances.
inline motion::Segment line(double start_s, const rrs::JointPos& from, const rrs::JointPos& to,
                            const Pace& motion_limits) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::linear;
    segment.start_s = start_s;
    segment.start = from;
    segment.end = to;
    segment.master =
        motion::TimeLaw::fastest((to - from).norm(), motion_limits.speed, motion_limits.acceleration);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

/// A full turn in XY, counterclockwise from the point right of the centre.
inline motion::Segment turn(double start_s, const rrs::JointPos& center, double radius_mm,
                            const Pace& motion_limits) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::circular;
    segment.start_s = start_s;
    segment.position_joints = {0, 1, 2};
    segment.arc.center = center.head<3>();
    segment.arc.radius_mm = segment.arc.end_radius_mm = radius_mm;
    segment.arc.sweep_rad = 2 * M_PI;
    segment.start = segment.end = center;
    segment.start[0] += radius_mm;
    segment.end[0] += radius_mm;
    segment.master =
        motion::TimeLaw::fastest(segment.arc.length_mm(), motion_limits.speed, motion_limits.acceleration);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

inline motion::Segment standstill(double start_s, const rrs::JointPos& at, double duration_s) {
    motion::Segment segment;
    segment.start_s = start_s;
    segment.start = segment.end = at;
    segment.duration_s = duration_s;
    return segment;
}

}  // namespace gsim::cell
