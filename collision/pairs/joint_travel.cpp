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
    double way(const motion::TimeLaw& law) const { return law.at(to_s).s - law.at(from_s).s; }
    // Returns the max distance of a function of time from its chord: an eighth of its largest second
    // derivative times the square of the time. An exception is a speed jump inside, if a law of unlimited
    // acceleration ends before the others. A law never runs backwards.
    double bend(const motion::TimeLaw& law) const {
        if (law.duration_s() < to_s && law.jumps()) return way(law);
        return std::min(way(law), law.peak_acceleration() * duration_s() * duration_s() / 8);
    }
};

bool is_followed(const Segment& segment, int joint) {
    const auto followers = segment.followers();
    return std::any_of(followers.begin(), followers.end(),
                       [joint](const motion::Follower& follower) { return follower.joint == joint; });
}

// Adds the tool's motion on a great circle, which its two joints do not follow in proportion. The turning
// joint moves in one direction, the tilt no farther than the tool.
void add_orientation(const Segment& segment, const Span& span, bool by_time, JointTravel& travel) {
    const double scale = segment.orientation->length_rad() / segment.lead.length();
    const double way = scale * span.way(segment.lead);
    if (!(way > 0)) return;
    const double from = scale * segment.lead.at(span.from_s).s;
    const motion::OrientationArc part = segment.orientation->part(from, from + way);
    const motion::HeadBounds bounds = part.bounds();
    const double turn = std::abs(part.at(way).angles.turn - part.at(0).angles.turn);
    const double bend = by_time ? scale * span.bend(segment.lead) : 0;
    const auto put = [&](int joint, double joint_way, double first, double second) {
        const auto index = static_cast<std::size_t>(joint);
        travel.way[index] += joint_way;
        travel.bend[index] += std::min(joint_way, first * bend + second * way * way / 8);
    };
    put(part.turn_joint(), turn, bounds.first.turn, bounds.second.turn);
    put(part.tilt_joint(), way, bounds.first.tilt, bounds.second.tilt);
}

// `by_time`: true if something moves by another law, so "in proportion" means to the time. Otherwise it means
// to the distance of the leading law, and that law adds no deviation.
void add(const Segment& segment, const Span& span, bool by_time, JointTravel& travel) {
    if (segment.kind == motion::SegmentKind::rest) return;
    const double way = span.way(segment.lead);
    const double bend = by_time ? span.bend(segment.lead) : 0;
    if (segment.kind == motion::SegmentKind::circular) {
        travel.arc_joints = segment.position_joints;
        travel.arc_mm += way;
        travel.arc_bend_mm += bend + segment.arc.max_curvature() * way * way / 8;
    }
    const double length = segment.lead.length();
    if (segment.orientation && length > 0) add_orientation(segment, span, by_time, travel);
    for (int joint = 0; joint < segment.end.size(); ++joint) {
        if (!(length > 0) || is_followed(segment, joint)) continue;
        if (segment.kind == motion::SegmentKind::circular && travel.on_arc(joint)) continue;
        if (segment.orientation && segment.orientation->moves(joint)) continue;
        const double share = std::abs(segment.end[joint] - segment.start[joint]) / length;
        travel.way[static_cast<std::size_t>(joint)] += share * way;
        travel.bend[static_cast<std::size_t>(joint)] += share * bend;
    }
    for (const motion::Follower& follower : segment.followers()) {
        travel.way[static_cast<std::size_t>(follower.joint)] += span.way(follower.law);
        travel.bend[static_cast<std::size_t>(follower.joint)] += span.bend(follower.law);
    }
}

}  // namespace

bool JointTravel::on_arc(int joint) const {
    return std::find(arc_joints.begin(), arc_joints.end(), joint) != arc_joints.end();
}

bool JointTravel::moves() const {
    return arc_mm > 0 || std::any_of(way.begin(), way.end(), [](double length) { return length > 0; });
}

JointTravel travel_of(const Segment& segment, double from_s, double to_s, bool by_time) {
    JointTravel travel;
    const Span span{from_s, to_s};
    by_time = by_time || !segment.followers().empty() || segment.beside != nullptr;
    add(segment, span, by_time, travel);
    if (segment.beside) add(*segment.beside, span, by_time, travel);
    return travel;
}

}  // namespace gsim::cell
