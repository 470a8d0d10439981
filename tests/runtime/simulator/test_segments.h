#pragma once

#include <cmath>
#include <numbers>

#include "machine/file/machine_file.h"
#include "machine/model/machine.h"
#include "motion/segment/segment.h"

namespace gsim::simulation {

inline machine::Machine af5() {
    return machine::read_machine(machine::built_in_machine_toml(), "af5.toml").value();
}

/// Joint values of the built-in machine, in mm and rad.
inline rrs::JointPos joints(double x, double y, double z = 0, double b = 0, double c = 0) {
    rrs::JointPos values(5);
    values << x, y, z, b, c;
    return values;
}

constexpr double kSpeed_mm_s = 50;
constexpr double kAcceleration_mm_s2 = 100;  // 0.5 s and 12.5 mm to kSpeed_mm_s

/// Returns a straight segment between standstills at those values, its rotary joints in proportion. 100 mm
/// take 2.5 s.
inline motion::Segment line(rrs::TargetId id, double start_s, const rrs::JointPos& start,
                            const rrs::JointPos& end) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::linear;
    segment.target_id = id;
    segment.start_s = start_s;
    segment.start = start;
    segment.end = end;
    segment.length_mm = (end - start).head<3>().norm();
    segment.master = motion::TimeLaw::fastest(segment.length_mm, kSpeed_mm_s, kAcceleration_mm_s2);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

inline motion::Segment standstill(rrs::TargetId id, double start_s, const rrs::JointPos& at,
                                  double duration_s) {
    motion::Segment segment;
    segment.target_id = id;
    segment.start_s = start_s;
    segment.duration_s = duration_s;
    segment.start = segment.end = at;
    return segment;
}

/// A counterclockwise arc in XY about (x, y) at height 0, of angles in degrees.
inline motion::Segment arc(rrs::TargetId id, double start_s, double x, double y, double radius_mm,
                           double start_deg, double sweep_deg) {
    const double start_rad = start_deg * std::numbers::pi / 180;
    motion::Segment segment;
    segment.kind = motion::SegmentKind::circular;
    segment.target_id = id;
    segment.start_s = start_s;
    segment.position_joints = {0, 1, 2};
    segment.arc.center = {x, y, 0};
    segment.arc.u = {std::cos(start_rad), std::sin(start_rad), 0};
    segment.arc.v = {-std::sin(start_rad), std::cos(start_rad), 0};
    segment.arc.radius_mm = segment.arc.end_radius_mm = radius_mm;
    segment.arc.sweep_rad = sweep_deg * std::numbers::pi / 180;
    const auto point = [&](double phi_rad) {
        const Eigen::Vector3d at = segment.arc.at(phi_rad);
        return joints(at.x(), at.y(), at.z());
    };
    segment.start = point(0);
    segment.end = point(segment.arc.sweep_rad);
    segment.length_mm = segment.arc.length_mm();
    segment.master = motion::TimeLaw::fastest(segment.length_mm, kSpeed_mm_s, kAcceleration_mm_s2);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

}  // namespace gsim::simulation
