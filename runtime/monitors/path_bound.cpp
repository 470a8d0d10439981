#include "runtime/monitors/path_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "machine/model/torque_limit.h"

namespace gsim::simulation {

using motion::PathCaps;
using motion::Segment;
using motion::SegmentKind;
using rrs::JointPos;

namespace {

constexpr double kChangeTolerance = 1e-9;  // mm or rad: rounding of frames, which planners pass over
constexpr double kLimitRounding = 1 + 1e-9;

motion::JointLimits limits_of(const machine::Machine& machine) {
    const auto count = static_cast<Eigen::Index>(machine.axes.size());
    motion::JointLimits limits{JointPos(count), JointPos(count)};
    for (Eigen::Index joint = 0; joint < count; ++joint) {
        const machine::Axis& axis = machine.axes[static_cast<std::size_t>(joint)];
        const double unit = axis.kind == machine::AxisKind::rotary ? kRadPerDeg : 1;
        limits.max_speed[joint] = axis.max_speed * unit;
        limits.max_acceleration[joint] = std::max(axis.max_acceleration, axis.deceleration()) * unit;
        if (machine::is_torque_limited(machine) && machine::has_motor(axis))
            limits.max_acceleration[joint] = std::numeric_limits<double>::infinity();
    }
    return limits;
}

/// Returns the travel of each joint that moves in proportion to the path.
JointPos joint_changes(const Segment& segment) {
    JointPos changes = segment.end - segment.start;
    for (double& change : changes) {
        if (std::abs(change) <= kChangeTolerance) change = 0;
    }
    for (const motion::Follower& follower : segment.followers()) changes[follower.joint] = 0;
    if (segment.orientation)  // leaving joints out keeps the bound a bound
        changes[segment.orientation->turn_joint()] = changes[segment.orientation->tilt_joint()] = 0;
    if (segment.kind != SegmentKind::circular) return changes;
    for (const int joint : segment.position_joints) {
        if (joint >= 0) changes[joint] = 0;
    }
    return changes;
}

bool moves_position(const Segment& segment, const JointPos& changes) {
    if (segment.kind == SegmentKind::circular) return true;
    return std::any_of(segment.position_joints.begin(), segment.position_joints.end(),
                       [&](int joint) { return joint >= 0 && changes[joint] != 0; });
}

void lower(double& cap, double other) {
    cap = std::min(cap, other);
}

void apply_joint_limits(const motion::JointLimits& limits, const JointPos& q1, PathCaps& caps) {
    for (Eigen::Index joint = 0; joint < q1.size(); ++joint) {
        const double share = std::abs(q1[joint]);
        if (share < motion::kMinShare) continue;
        lower(caps.max_speed, limits.max_speed[joint] / share);
        lower(caps.max_acceleration, limits.max_acceleration[joint] / share);
        lower(caps.max_deceleration, limits.max_acceleration[joint] / share);
    }
}

/// Uses a fact of all points of any curve: the tangent has length 1, so the joints together are no slower.
void apply_norm_limits(const motion::JointLimits& limits, const Segment& segment, PathCaps& caps) {
    double speed2 = 0;
    double acceleration2 = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = segment.position_joints[axis];
        if (joint < 0 || segment.arc.max_share(static_cast<int>(axis)) < motion::kMinShare) continue;
        speed2 += limits.max_speed[joint] * limits.max_speed[joint];
        acceleration2 += limits.max_acceleration[joint] * limits.max_acceleration[joint];
    }
    lower(caps.max_speed, std::sqrt(speed2));
    lower(caps.max_acceleration, std::sqrt(acceleration2));
    lower(caps.max_deceleration, std::sqrt(acceleration2));
}

/// Returns caps that the motion keeps: an override can raise the feed, and some controllers exceed limits.
PathCaps raise_caps(const PathCaps& caps, const motion::TimeLaw& law, double length) {
    const double scale = length / law.length();
    const double acceleration =
        law.jumps() ? std::numeric_limits<double>::infinity() : law.peak_acceleration() * scale;
    return {std::max(caps.max_speed, law.peak_speed() * scale), std::max(caps.max_acceleration, acceleration),
            std::max(caps.max_deceleration, acceleration)};
}

/// Returns the joints on an arc: those of the position along its shape, the others in proportion.
motion::Curve make_curve(const Segment& segment, double length, const JointPos& q1) {
    const auto in_plane = [&](Eigen::Index axis) {
        return std::hypot(segment.arc.u[axis], segment.arc.v[axis]);
    };
    motion::Curve curve{length, segment.arc.sweep_rad, JointPos::Zero(q1.size()), {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = segment.position_joints[axis];
        if (joint >= 0)
            curve.max_q2[joint] = segment.arc.max_curvature() * in_plane(static_cast<Eigen::Index>(axis));
    }
    curve.at = [&segment, &q1](double s) {
        const double phi = segment.arc.phi_at(s);
        const Eigen::Vector3d point = segment.arc.at(phi);
        const Eigen::Vector3d tangent = segment.arc.tangent(phi);
        const Eigen::Vector3d curvature = segment.arc.curvature(phi);
        motion::CurvePoint at{s * q1, q1, JointPos::Zero(q1.size())};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int joint = segment.position_joints[axis];
            if (joint < 0) continue;
            const auto index = static_cast<Eigen::Index>(axis);
            at.q[joint] = point[index];
            at.q1[joint] = tangent[index];
            at.q2[joint] = curvature[index];
        }
        return at;
    };
    return curve;
}

}  // namespace

PathBound::PathBound(const machine::Machine& machine)
    : machine_(machine), limits_(limits_of(machine)), bound_(limits_) {}

void PathBound::on_segment(const Segment& segment, const MoveInfo& info) {
    if (segment.kind == SegmentKind::rest) return standstill(segment, info);
    if (segment.superimposed) {
        bound_.change_measure();
        measure_.reset();
        at_standstill_ = false;
        return;
    }
    if (!(segment.duration_s > 0) || !(segment.master.length() > 0)) return;
    const SegmentPath path = segment_path(segment);
    continue_measure(path.measure);
    const PathCaps caps = path_caps(segment, info, path);
    if (segment.kind == SegmentKind::circular) {
        add_arc(segment, path, caps);
    } else {
        add_line(path, caps, segment.master);
    }
}

void PathBound::standstill(const Segment& segment, const MoveInfo& info) {
    bound_.stop();
    at_standstill_ = true;
    if (info.kind == MoveKind::dwell) dwells_.add(segment.duration_s);
}

void PathBound::continue_measure(Measure measure) {
    const bool same = measure_ == measure && measure != Measure::separate;
    if (!at_standstill_ && !same) bound_.change_measure();
    measure_ = measure;
    at_standstill_ = false;
}

PathBound::SegmentPath PathBound::segment_path(const Segment& segment) const {
    const JointPos changes = joint_changes(segment);
    if (segment.kind == SegmentKind::joint)
        return {Measure::separate, segment.master.length(), changes / segment.master.length()};
    if (segment.length_mm > 0) {
        const Measure measure = moves_position(segment, changes) ? Measure::position : Measure::secondary;
        return {measure, segment.length_mm, changes / segment.length_mm};
    }
    return {segment.orientation ? Measure::direction : Measure::rotary, segment.master.length(),
            changes / segment.master.length()};
}

/// Returns the caps that the program and the machine's path limits set, whatever the joints could do.
PathCaps PathBound::path_caps(const Segment& segment, const MoveInfo& info, const SegmentPath& path) const {
    const bool is_client_target = !info.timed && !(info.feed_per_min > 0) && info.kind != MoveKind::rapid;
    if (path.measure == Measure::separate || is_client_target) return {};
    const bool moves_tcp = segment.length_mm > 0;
    PathCaps caps;
    if (info.kind == MoveKind::rapid) {
        if (moves_tcp) {
            caps.max_speed = machine_.path.max_rapid_mm_s;
            caps.max_acceleration = caps.max_deceleration = machine_.path.max_rapid_acceleration_mm_s2;
        }
        return caps;
    }
    if (moves_tcp) {
        caps.max_speed = machine_.path.max_feed_mm_s;
        caps.max_acceleration = caps.max_deceleration = machine_.path.max_acceleration_mm_s2;
    }
    const double unit = moves_tcp ? 1 : kRadPerDeg;
    if (!info.timed) lower(caps.max_speed, info.feed_per_min / kSecondsPerMinute * unit);
    return caps;
}

void PathBound::add_line(const SegmentPath& path, PathCaps caps, const motion::TimeLaw& law) {
    apply_joint_limits(limits_, path.q1, caps);
    bound_.add_line(path.length, raise_caps(caps, law, path.length));
}

void PathBound::add_arc(const Segment& segment, const SegmentPath& path, const PathCaps& caps) {
    if (is_within_limits(segment, path)) {
        bound_.add_curve(make_curve(segment, path.length, path.q1),
                         raise_caps(caps, segment.master, path.length));
        return;
    }
    PathCaps relaxed_caps = caps;
    apply_norm_limits(limits_, segment, relaxed_caps);
    add_line(path, relaxed_caps, segment.master);
}

/// Returns true if no joint can have got more speed or acceleration than it has. Peak speed and peak
/// acceleration are assumed to meet at the largest share of the joint in the path.
bool PathBound::is_within_limits(const Segment& segment, const SegmentPath& path) const {
    if (segment.master.jumps()) return false;
    const double speed = segment.master.peak_speed();
    const double acceleration = segment.master.peak_acceleration();
    const double centripetal = segment.peak_centripetal_mm_s2();
    const auto is_within_limit = [&](Eigen::Index joint, double in_plane, double straight,
                                     double in_plane_share) {
        const double joint_speed_bound = speed * (in_plane * in_plane_share + straight);
        const double max_joint_acceleration =
            in_plane * std::hypot(in_plane_share * acceleration, centripetal) + straight * acceleration;
        return joint_speed_bound <= limits_.max_speed[joint] * kLimitRounding &&
               max_joint_acceleration <= limits_.max_acceleration[joint] * kLimitRounding;
    };
    for (Eigen::Index joint = 0; joint < path.q1.size(); ++joint) {
        if (!is_within_limit(joint, 0, std::abs(path.q1[joint]), 0)) return false;
    }
    const Eigen::Vector3d ascent = segment.arc.lift / path.length;
    const double in_plane_share = std::sqrt(std::max(0.0, 1 - ascent.squaredNorm()));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = segment.position_joints[axis];
        const auto index = static_cast<Eigen::Index>(axis);
        const double in_plane = std::hypot(segment.arc.u[index], segment.arc.v[index]);
        if (joint >= 0 && !is_within_limit(joint, in_plane, std::abs(ascent[index]), in_plane_share))
            return false;
    }
    return true;
}

}  // namespace gsim::simulation
