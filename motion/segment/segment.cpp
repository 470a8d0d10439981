#include "motion/segment/segment.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

// Returns the share of the path already covered: 0 to 1.
double path_share(const TimeLaw& law, double s) {
    return law.length() > 0 ? s / law.length() : 0;
}

void set_arc_state(const Segment& segment, const LawState& master, JointState& state) {
    const double phi = segment.arc.phi_at(master.s);
    const Eigen::Vector3d tangent = segment.arc.tangent(phi);
    write_position(segment.position_joints, segment.arc.at(phi), state.position);
    write_position(segment.position_joints, master.v * tangent, state.velocity);
    write_position(segment.position_joints,
                   master.a * tangent + master.v * master.v * segment.arc.curvature(phi), state.acceleration);
}

void set_orientation(const OrientationArc& travel, double share, rrs::JointPos& position) {
    const HeadAngles angles = travel.at(share * travel.length_rad()).angles;
    position[travel.turn_joint()] = angles.turn;
    position[travel.tilt_joint()] = angles.tilt;
}

/// `scale` is the share of the path per length that the leading law counts.
void set_orientation_state(const OrientationArc& travel, const LawState& master, double scale,
                           JointState& state) {
    const double rate = scale * travel.length_rad();
    const HeadState head = travel.at(master.s * rate);
    const double speed = master.v * rate;
    const auto set_joint = [&](int joint, double angle, double first, double second) {
        state.position[joint] = angle;
        state.velocity[joint] = first * speed;
        state.acceleration[joint] = first * master.a * rate + second * speed * speed;
    };
    set_joint(travel.turn_joint(), head.angles.turn, head.first.turn, head.second.turn);
    set_joint(travel.tilt_joint(), head.angles.tilt, head.first.tilt, head.second.tilt);
}

// A law that is shorter than its segment is at standstill from its end on.
LawState law_state(const Segment& segment, const TimeLaw& law, double t_s) {
    const bool waits = segment.is_uncoordinated() && t_s > law.duration_s();
    return waits ? LawState{law.length(), 0, 0} : law.at(t_s);
}

// Two simultaneous motions have no simple extremes; blends are short.
Range sampled_range(const Segment& segment, int joint) {
    constexpr int kSteps = 32;
    Range range{segment.start[joint], segment.start[joint]};
    for (int i = 1; i <= kSteps; ++i) {
        const double value = segment.position_at(segment.duration_s * i / kSteps)[joint];
        range = {std::min(range.min, value), std::max(range.max, value)};
    }
    return range;
}

// Each of two straight motions adds between 0 and its full distance.
bool is_linear_certainly_within(const Segment& segment, const Range& range, int joint) {
    const Segment& superimposed = *segment.superimposed;
    const auto is_straight = [](const Segment& one) {
        return one.kind != SegmentKind::circular && one.followers().empty();
    };
    if (!is_straight(segment) || !is_straight(superimposed)) return false;
    const double independent = segment.end[joint] - segment.start[joint];
    const double other = superimposed.end[joint] - superimposed.start[joint];
    return segment.start[joint] + std::min(independent, 0.0) + std::min(other, 0.0) >= range.min &&
           segment.start[joint] + std::max(independent, 0.0) + std::max(other, 0.0) <= range.max;
}

void add(const JointState& other, const rrs::JointPos& other_start, JointState& state) {
    state.position += other.position - other_start;
    state.velocity += other.velocity;
    state.acceleration += other.acceleration;
}

}  // namespace

rrs::JointPos Segment::end_position() const {
    return superimposed ? end + (superimposed->end - superimposed->start) : end;
}

rrs::JointPos Segment::position_at(double t_s) const {
    if (t_s >= duration_s) return end_position();
    if (t_s <= 0) return start;
    // A time law ends near its length by rounding, not at it, so the ends are handled above.
    const double s = master.at(t_s).s;
    rrs::JointPos position = start + path_share(master, s) * (end - start);
    if (kind == SegmentKind::circular) write_position(position_joints, arc.at(arc.phi_at(s)), position);
    if (orientation) set_orientation(*orientation, path_share(master, s), position);
    for (const Follower& follower : followers()) {
        position[follower.joint] = start[follower.joint] + follower.sign * follower.law.at(t_s).s;
    }
    if (superimposed) position += superimposed->position_at(t_s) - superimposed->start;
    return position;
}

JointState Segment::at(double t_s) const {
    const LawState path = law_state(*this, master, t_s);
    const rrs::JointPos travel = end - start;
    const double scale = path_share(master, 1);
    JointState state{start + path.s * scale * travel, path.v * scale * travel, path.a * scale * travel};
    if (kind == SegmentKind::circular) set_arc_state(*this, path, state);
    if (orientation) set_orientation_state(*orientation, path, scale, state);
    for (const Follower& follower : followers()) {
        const LawState independent = law_state(*this, follower.law, t_s);
        state.position[follower.joint] = start[follower.joint] + follower.sign * independent.s;
        state.velocity[follower.joint] = follower.sign * independent.v;
        state.acceleration[follower.joint] = follower.sign * independent.a;
    }
    if (superimposed) add(superimposed->at(t_s), superimposed->start, state);
    if (t_s >= duration_s) state.position = end_position();
    if (t_s <= 0 && duration_s > 0) state.position = start;
    return state;
}

bool Segment::carries_path(int joint) const {
    if (is_uncoordinated()) return (uncoordinated >> static_cast<unsigned>(joint) & 1U) != 0;
    return std::find(position_joints.begin(), position_joints.end(), joint) != position_joints.end();
}

double Segment::path_speed_mm_s(double t_s) const {
    if (!superimposed && !is_uncoordinated()) return master.at(t_s).v * path_share(master, length_mm);
    const rrs::JointPos velocity = at(t_s).velocity;
    double square = 0;
    for (int joint = 0; joint < velocity.size(); ++joint) {
        if (carries_path(joint)) square += velocity[joint] * velocity[joint];
    }
    return std::sqrt(square);
}

double Segment::blended_length_mm() const {
    constexpr int kChords = 32;
    double length = 0;
    rrs::JointPos from = start;
    for (int i = 1; i <= kChords; ++i) {
        const rrs::JointPos to = position_at(duration_s * i / kChords);
        double square = 0;
        for (const int joint : position_joints) {
            if (joint >= 0) square += (to[joint] - from[joint]) * (to[joint] - from[joint]);
        }
        length += std::sqrt(square);
        from = to;
    }
    return length;
}

double Segment::peak_centripetal_mm_s2() const {
    if (kind != SegmentKind::circular) return 0;
    return master.peak_speed() * master.peak_speed() * arc.max_curvature();
}

bool Segment::is_certainly_within(const Range& range, int joint) const {
    if (superimposed) return is_linear_certainly_within(*this, range, joint);
    if (kind != SegmentKind::circular) {
        if (orientation) return false;
        const auto [min, max] = std::minmax(start[joint], end[joint]);
        return min >= range.min && max <= range.max;
    }
    const auto axis = std::find(position_joints.begin(), position_joints.end(), joint);
    if (axis == position_joints.end()) return false;
    const auto index = axis - position_joints.begin();
    if (arc.u[index] == 0 && arc.v[index] == 0 && arc.lift[index] == 0) {  // across the arc: no rounding
        const auto [min, max] = std::minmax({start[joint], end[joint], arc.center[index]});
        return min >= range.min && max <= range.max;
    }
    const Range circle = arc.bounds(static_cast<int>(index));
    if (circle.min - kArcRounding_mm >= range.min && circle.max + kArcRounding_mm <= range.max) return true;
    if (arc.lift[index] != 0) return false;
    const auto [min, max] = std::minmax(start[joint], end[joint]);
    const double margin_mm = arc.bulge_mm() + kArcRounding_mm;
    return min - margin_mm >= range.min && max + margin_mm <= range.max;
}

Range Segment::joint_range(int joint) const {
    if (superimposed) return sampled_range(*this, joint);
    const Range ends{std::min(start[joint], end[joint]), std::max(start[joint], end[joint])};
    if (orientation && joint == orientation->tilt_joint()) {
        const Range travel = orientation->tilt_range();
        return {std::min(ends.min, travel.min), std::max(ends.max, travel.max)};
    }
    if (kind != SegmentKind::circular) return ends;
    const auto axis = std::find(position_joints.begin(), position_joints.end(), joint);
    if (axis == position_joints.end()) return ends;
    const Range travel = arc.range(static_cast<int>(axis - position_joints.begin()));
    return {std::min(ends.min, travel.min), std::max(ends.max, travel.max)};
}

}  // namespace gsim::motion
