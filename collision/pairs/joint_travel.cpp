#include "collision/pairs/joint_travel.h"

#include <algorithm>
#include <cmath>

namespace gsim::cell {

using motion::Segment;

namespace {

/// Part of the time of a segment.
struct Span {
    double from_s;
    double to_s;

    double duration_s() const { return to_s - from_s; }
    double distance(const motion::TimeLaw& law) const { return law.at(to_s).s - law.at(from_s).s; }
    // Returns the max distance of a function of time from its chord: an eighth of its largest second
    // derivative times the square of the time. An exception is a speed jump inside, if a law of unlimited
    // acceleration ends before the others. A law never runs backwards.
    double deviation(const motion::TimeLaw& law) const {
        if (law.duration_s() < to_s && law.jumps()) return distance(law);
        return std::min(distance(law), law.peak_acceleration() * duration_s() * duration_s() / 8);
    }
};

bool has_follower(const Segment& segment, int joint) {
    const auto followers = segment.followers();
    return std::any_of(followers.begin(), followers.end(),
                       [joint](const motion::Follower& follower) { return follower.joint == joint; });
}

// Adds the tool's motion on a great circle, which its two joints do not follow in proportion. The turning
// joint moves in one direction, the tilt no farther than the tool.
void add_orientation(const Segment& segment, const Span& span, bool over_time, JointTravel& travel) {
    const double scale = segment.orientation->length_rad() / segment.master.length();
    const double distance = scale * span.distance(segment.master);
    if (!(distance > 0)) return;
    const double from = scale * segment.master.at(span.from_s).s;
    const motion::OrientationArc part = segment.orientation->part(from, from + distance);
    const motion::HeadBounds bounds = part.bounds();
    const double turn = std::abs(part.at(distance).angles.turn - part.at(0).angles.turn);
    const double deviation = over_time ? scale * span.deviation(segment.master) : 0;
    const auto set_joint = [&](int joint, double joint_distance, double first, double second) {
        const auto index = static_cast<std::size_t>(joint);
        travel.distance[index] += joint_distance;
        travel.deviation[index] +=
            std::min(joint_distance, first * deviation + second * distance * distance / 8);
    };
    set_joint(part.turn_joint(), turn, bounds.first.turn, bounds.second.turn);
    set_joint(part.tilt_joint(), distance, bounds.first.tilt, bounds.second.tilt);
}

// `over_time`: true if something moves by another law, so "in proportion" means to the time. Otherwise it
// means to the distance of the leading law, and that law adds no deviation.
void add(const Segment& segment, const Span& span, bool over_time, JointTravel& travel) {
    if (segment.kind == motion::SegmentKind::rest) return;
    const double distance = span.distance(segment.master);
    const double deviation = over_time ? span.deviation(segment.master) : 0;
    if (segment.kind == motion::SegmentKind::circular) {
        travel.arc_joints = segment.position_joints;
        travel.arc_mm += distance;
        travel.arc_deviation_mm += deviation + segment.arc.max_curvature() * distance * distance / 8;
    }
    const double length = segment.master.length();
    if (segment.orientation && length > 0) add_orientation(segment, span, over_time, travel);
    for (int joint = 0; joint < segment.end.size(); ++joint) {
        if (!(length > 0) || has_follower(segment, joint)) continue;
        if (segment.kind == motion::SegmentKind::circular && travel.is_on_arc(joint)) continue;
        if (segment.orientation && segment.orientation->moves(joint)) continue;
        const double share = std::abs(segment.end[joint] - segment.start[joint]) / length;
        travel.distance[static_cast<std::size_t>(joint)] += share * distance;
        travel.deviation[static_cast<std::size_t>(joint)] += share * deviation;
    }
    for (const motion::Follower& follower : segment.followers()) {
        travel.distance[static_cast<std::size_t>(follower.joint)] += span.distance(follower.law);
        travel.deviation[static_cast<std::size_t>(follower.joint)] += span.deviation(follower.law);
    }
}

}  // namespace

bool JointTravel::is_on_arc(int joint) const {
    return std::find(arc_joints.begin(), arc_joints.end(), joint) != arc_joints.end();
}

bool JointTravel::moves() const {
    return arc_mm > 0 ||
           std::any_of(distance.begin(), distance.end(), [](double length) { return length > 0; });
}

JointTravel joint_travel(const Segment& segment, double from_s, double to_s, bool over_time) {
    JointTravel travel;
    const Span span{from_s, to_s};
    over_time = over_time || !segment.followers().empty() || segment.superimposed != nullptr;
    add(segment, span, over_time, travel);
    if (segment.superimposed) add(*segment.superimposed, span, over_time, travel);
    return travel;
}

}  // namespace gsim::cell
