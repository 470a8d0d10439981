#include "motion/segment/segment.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

// Returns the share of the path already covered: 0 to 1.
double share_of(const TimeLaw& law, double s) {
    return law.length() > 0 ? s / law.length() : 0;
}

void put_arc_state(const Segment& segment, const LawState& lead, JointState& state) {
    const double phi = segment.arc.phi_at(lead.s);
    const Eigen::Vector3d tangent = segment.arc.tangent(phi);
    put_position(segment.position_joints, segment.arc.at(phi), state.position);
    put_position(segment.position_joints, lead.v * tangent, state.velocity);
    put_position(segment.position_joints, lead.a * tangent + lead.v * lead.v * segment.arc.curvature(phi),
                 state.acceleration);
}

void put_orientation(const OrientationArc& way, double share, rrs::JointPos& position) {
    const HeadAngles angles = way.at(share * way.length_rad()).angles;
    position[way.turn_joint()] = angles.turn;
    position[way.tilt_joint()] = angles.tilt;
}

/// `scale` is the share of the path per length that the leading law counts.
void put_orientation_state(const OrientationArc& way, const LawState& lead, double scale, JointState& state) {
    const double rate = scale * way.length_rad();
    const HeadState head = way.at(lead.s * rate);
    const double speed = lead.v * rate;
    const auto put = [&](int joint, double angle, double first, double second) {
        state.position[joint] = angle;
        state.velocity[joint] = first * speed;
        state.acceleration[joint] = first * lead.a * rate + second * speed * speed;
    };
    put(way.turn_joint(), head.angles.turn, head.first.turn, head.second.turn);
    put(way.tilt_joint(), head.angles.tilt, head.first.tilt, head.second.tilt);
}

// A law that is shorter than its segment is at standstill after its end.
LawState state_of(const Segment& segment, const TimeLaw& law, double t_s) {
    const bool waits = segment.joints_go_apart() && t_s > law.duration_s();
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
bool surely_straight_within(const Segment& segment, const Range& range, int joint) {
    const Segment& beside = *segment.beside;
    const auto straight = [](const Segment& one) {
        return one.kind != SegmentKind::circular && one.followers().empty();
    };
    if (!straight(segment) || !straight(beside)) return false;
    const double own = segment.end[joint] - segment.start[joint];
    const double other = beside.end[joint] - beside.start[joint];
    return segment.start[joint] + std::min(own, 0.0) + std::min(other, 0.0) >= range.min &&
           segment.start[joint] + std::max(own, 0.0) + std::max(other, 0.0) <= range.max;
}

void add(const JointState& other, const rrs::JointPos& other_start, JointState& state) {
    state.position += other.position - other_start;
    state.velocity += other.velocity;
    state.acceleration += other.acceleration;
}

}  // namespace

rrs::JointPos Segment::end_position() const {
    return beside ? end + (beside->end - beside->start) : end;
}

rrs::JointPos Segment::position_at(double t_s) const {
    if (t_s >= duration_s) return end_position();
    if (t_s <= 0) return start;
    // A time law ends near its length by rounding, not at it, so the ends are handled above.
    const double s = lead.at(t_s).s;
    rrs::JointPos position = start + share_of(lead, s) * (end - start);
    if (kind == SegmentKind::circular) put_position(position_joints, arc.at(arc.phi_at(s)), position);
    if (orientation) put_orientation(*orientation, share_of(lead, s), position);
    for (const Follower& follower : followers()) {
        position[follower.joint] = start[follower.joint] + follower.sign * follower.law.at(t_s).s;
    }
    if (beside) position += beside->position_at(t_s) - beside->start;
    return position;
}

JointState Segment::at(double t_s) const {
    const LawState path = state_of(*this, lead, t_s);
    const rrs::JointPos way = end - start;
    const double scale = share_of(lead, 1);
    JointState state{start + path.s * scale * way, path.v * scale * way, path.a * scale * way};
    if (kind == SegmentKind::circular) put_arc_state(*this, path, state);
    if (orientation) put_orientation_state(*orientation, path, scale, state);
    for (const Follower& follower : followers()) {
        const LawState own = state_of(*this, follower.law, t_s);
        state.position[follower.joint] = start[follower.joint] + follower.sign * own.s;
        state.velocity[follower.joint] = follower.sign * own.v;
        state.acceleration[follower.joint] = follower.sign * own.a;
    }
    if (beside) add(beside->at(t_s), beside->start, state);
    if (t_s >= duration_s) state.position = end_position();
    if (t_s <= 0 && duration_s > 0) state.position = start;
    return state;
}

bool Segment::carries_path(int joint) const {
    if (joints_go_apart()) return (apart >> static_cast<unsigned>(joint) & 1U) != 0;
    return std::find(position_joints.begin(), position_joints.end(), joint) != position_joints.end();
}

double Segment::path_speed_mm_s(double t_s) const {
    if (!beside && !joints_go_apart()) return lead.at(t_s).v * share_of(lead, length_mm);
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
    return lead.peak_speed() * lead.peak_speed() * arc.max_curvature();
}

bool Segment::surely_within(const Range& range, int joint) const {
    if (beside) return surely_straight_within(*this, range, joint);
    if (kind != SegmentKind::circular) {
        if (orientation) return false;
        const auto [least, most] = std::minmax(start[joint], end[joint]);
        return least >= range.min && most <= range.max;
    }
    const auto axis = std::find(position_joints.begin(), position_joints.end(), joint);
    if (axis == position_joints.end()) return false;
    const auto index = axis - position_joints.begin();
    if (arc.u[index] == 0 && arc.v[index] == 0 && arc.lift[index] == 0) {  // across the arc: no rounding
        const auto [least, most] = std::minmax({start[joint], end[joint], arc.center[index]});
        return least >= range.min && most <= range.max;
    }
    const Range circle = arc.bounds(static_cast<int>(index));
    if (circle.min - kArcRounding_mm >= range.min && circle.max + kArcRounding_mm <= range.max) return true;
    if (arc.lift[index] != 0) return false;
    const auto [least, most] = std::minmax(start[joint], end[joint]);
    const double beyond_mm = arc.bulge_mm() + kArcRounding_mm;
    return least - beyond_mm >= range.min && most + beyond_mm <= range.max;
}

Range Segment::joint_range(int joint) const {
    if (beside) return sampled_range(*this, joint);
    const Range ends{std::min(start[joint], end[joint]), std::max(start[joint], end[joint])};
    if (orientation && joint == orientation->tilt_joint()) {
        const Range way = orientation->tilt_range();
        return {std::min(ends.min, way.min), std::max(ends.max, way.max)};
    }
    if (kind != SegmentKind::circular) return ends;
    const auto axis = std::find(position_joints.begin(), position_joints.end(), joint);
    if (axis == position_joints.end()) return ends;
    const Range way = arc.range(static_cast<int>(axis - position_joints.begin()));
    return {std::min(ends.min, way.min), std::max(ends.max, way.max)};
}

}  // namespace gsim::motion
