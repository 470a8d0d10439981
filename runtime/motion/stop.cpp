#include "runtime/motion/stop.h"

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/motion/law_cut.h"
#include "runtime/motion/ramp.h"
#include "runtime/motion/rest_law.h"

namespace gsim::motion {

namespace {

constexpr double kSameSpeed = 1e-12;  // relative
constexpr double kNoSpeed = 1e-9;     // of the highest speed
constexpr double kNoWay = 1e-9;       // of the whole

/// How far the lead and the followers of a segment have come.
struct Progress {
    double lead = 0;
    std::array<double, rrs::kMaxJoints> followers{};
};

Progress progress_at(const Segment& segment, double t_s) {
    Progress progress{segment.lead.at(t_s).s, {}};
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        progress.followers[i] = segment.followers()[i].law.at(t_s).s;
    return progress;
}

Progress end_of(const Segment& segment) {
    return progress_at(segment, segment.duration_s);
}

rrs::JointPos position_at(const Segment& segment, const Progress& progress) {
    const double length = segment.lead.length();
    const double share = length > 0 ? progress.lead / length : 0;
    rrs::JointPos position = segment.start + share * (segment.end - segment.start);
    if (segment.kind == SegmentKind::circular) {
        const Eigen::Vector3d point = segment.arc.at(segment.arc.phi_at(progress.lead));
        for (int axis = 0; axis < 3; ++axis) {
            const int joint = segment.position_joints[static_cast<std::size_t>(axis)];
            if (joint >= 0) position[joint] = point[axis];
        }
    }
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        position[follower.joint] = segment.start[follower.joint] + follower.sign * progress.followers[i];
    }
    return position;
}

/// The laws of a part of a segment.
struct Laws {
    TimeLaw lead;
    std::array<TimeLaw, rrs::kMaxJoints> followers;
    double duration_s = 0;
    double end_speed = 0;  ///< Of the lead, also where there is no way left for it.
};

/// The part of a segment that begins at `from` and goes by `laws`; `last`: to the very end.
Segment part_of(const Segment& segment, const Progress& from, const Laws& laws, bool last) {
    Segment part = segment;
    part.clear_followers();
    Progress to = from;
    to.lead = last ? end_of(segment).lead : from.lead + laws.lead.length();
    const double duration_s = laws.duration_s;
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        to.followers[i] += laws.followers[i].length();
        part.add_follower(follower.joint, follower.sign, laws.followers[i], follower.limits);
    }
    part.start = position_at(segment, from);
    part.end = last ? segment.end : position_at(segment, to);
    part.lead = laws.lead;
    part.duration_s = duration_s;
    if (segment.lead.length() > 0)
        part.length_mm = segment.length_mm * ((to.lead - from.lead) / segment.lead.length());
    if (segment.kind == SegmentKind::circular && to.lead > from.lead)
        part.arc = segment.arc.part(from.lead, to.lead);
    part.reaches_target = last && segment.reaches_target;
    return part;
}

Laws until(const Segment& segment, double t_s) {
    Laws laws{law_until(segment.lead, t_s), {}, t_s, segment.lead.at(t_s).v};
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        laws.followers[i] = law_until(segment.followers()[i].law, t_s);
    return laws;
}

/// All laws brake from `t_s` on; those that stand first wait for the others.
Laws braking(const Segment& segment, double t_s) {
    Laws laws{braking_law(segment.lead, t_s, segment.lead_limits), {}, 0, segment.lead.at(t_s).v};
    laws.duration_s = laws.lead.duration_s();
    if (laws.duration_s > 0) laws.end_speed = laws.lead.end_speed();
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        laws.followers[i] = braking_law(follower.law, t_s, follower.limits);
        laws.duration_s = std::max(laws.duration_s, laws.followers[i].duration_s());
    }
    if (segment.followers().empty()) return laws;
    laws.lead = law_and_rest(laws.lead, laws.duration_s);
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        laws.followers[i] = law_and_rest(laws.followers[i], laws.duration_s);
    return laws;
}

LawLimits no_faster(LawLimits limits, const TimeLaw& law) {
    limits.max_speed = std::min(limits.max_speed, law.peak_speed());
    return limits;
}

/// What the rest of a segment still has to do, as laws from rest to rest.
Laws rest_laws(const Segment& segment, const Progress& from) {
    const Progress end = end_of(segment);
    const double lead = std::max(end.lead - from.lead, 0.0);
    const LawLimits lead_limits = no_faster(segment.lead_limits, segment.lead);
    const double lead_s = lead > 0 ? fastest_rest_s(lead, lead_limits) : 0;
    std::array<double, rrs::kMaxJoints> least_s{};
    Laws laws;
    laws.duration_s = lead_s;
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        const double way = end.followers[i] - from.followers[i];
        if (way > 0) least_s[i] = fastest_rest_s(way, no_faster(follower.limits, follower.law));
        laws.duration_s = std::max(laws.duration_s, least_s[i]);
    }
    if (lead > 0) laws.lead = rest_law(lead, lead_limits, lead_s, laws.duration_s);
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        const double way = end.followers[i] - from.followers[i];
        if (way > 0)
            laws.followers[i] =
                rest_law(way, no_faster(follower.limits, follower.law), least_s[i], laws.duration_s);
    }
    return laws;
}

/// The rest of a segment, from rest. Where the segment was to be passed with a speed, it is planned to end
/// with it for now.
Segment rest_of(const Segment& segment, const Progress& from) {
    Laws laws = rest_laws(segment, from);
    const double exit = segment.lead.end_speed();
    const double lead = segment.lead.length() - from.lead;
    if (exit > 0 && lead > 0) {
        const LawLimits limits = no_faster(segment.lead_limits, segment.lead);
        const double end = std::min(exit, reachable_speed(lead, 0, limits.acceleration, limits.jerk));
        laws.lead = TimeLaw::between(lead, 0, end, limits);
        laws.duration_s = laws.lead.duration_s();
    }
    return part_of(segment, from, laws, true);
}

/// Whether a part that goes on from `from` by `laws` comes to the end of its segment.
bool reaches_end(const Segment& segment, const Progress& from, const Laws& laws) {
    const auto reaches = [](double done, double law, double whole) {
        return whole - done - law <= kNoWay * whole;
    };
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const double whole = segment.followers()[i].law.length();
        if (!reaches(from.followers[i], laws.followers[i].length(), whole)) return false;
    }
    return reaches(from.lead, laws.lead.length(), segment.lead.length());
}

/// The speed at the end of a part; rounding is none.
double exit_speed(const Laws& laws, const TimeLaw& planned) {
    const double speed = std::min(laws.end_speed, planned.end_speed());
    return speed > kNoSpeed * planned.peak_speed() ? speed : 0;
}

/// The laws by which a whole segment is passed that is entered at a lower speed than planned.
Laws braking_through(const Segment& segment, double start_speed) {
    Laws laws;
    laws.lead =
        braking_law(segment.lead.length(), start_speed, segment.lead.end_speed(), segment.lead_limits);
    laws.duration_s = laws.lead.duration_s();
    laws.end_speed = laws.lead.end_speed();
    return laws;
}

void put(std::vector<Segment>& list, Segment segment, double& clock_s) {
    segment.start_s = clock_s;
    clock_s += segment.duration_s;
    if (segment.duration_s > 0) list.push_back(std::move(segment));
}

void stop_rest(std::vector<Segment>& planned, double at_s, StoppedMotion& stopped) {
    Segment& dwell = planned.front();
    const double done_s = std::clamp(at_s - dwell.start_s, 0.0, dwell.duration_s);
    stopped.position = dwell.start;
    Segment done = dwell;
    done.duration_s = done_s;
    done.reaches_target = false;
    if (done_s > 0) stopped.done.push_back(done);
    dwell.duration_s -= done_s;
    stopped.rest = std::move(planned);
}

}  // namespace

StoppedMotion stop_motion(std::vector<Segment> planned, double at_s) {
    StoppedMotion stopped;
    if (planned.front().kind == SegmentKind::rest || !(planned.front().duration_s > 0)) {
        stop_rest(planned, at_s, stopped);
        return stopped;
    }
    const Segment& first = planned.front();
    const double t_s = std::clamp(at_s - first.start_s, 0.0, first.duration_s);
    double clock_s = first.start_s;
    put(stopped.done, part_of(first, {}, until(first, t_s), false), clock_s);
    Progress from = progress_at(first, t_s);
    Laws laws = braking(first, t_s);
    std::size_t index = 0;
    while (reaches_end(planned[index], from, laws)) {
        const Segment& segment = planned[index];
        const double speed = exit_speed(laws, segment.lead);
        put(stopped.braking, part_of(segment, from, laws, true), clock_s);
        stopped.position = segment.end;
        if (++index == planned.size()) return stopped;
        if (speed == 0) {
            stopped.rest.assign(planned.begin() + static_cast<std::ptrdiff_t>(index), planned.end());
            return stopped;
        }
        laws = braking_through(planned[index], speed);
        from = {};
    }
    const Segment part = part_of(planned[index], from, laws, false);
    put(stopped.braking, part, clock_s);
    stopped.position = part.end;
    from.lead += laws.lead.length();
    for (std::size_t i = 0; i < part.followers().size(); ++i) from.followers[i] += laws.followers[i].length();
    stopped.rest.push_back(rest_of(planned[index], from));
    stopped.rest.insert(stopped.rest.end(), planned.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                        planned.end());
    return stopped;
}

void restart_motion(std::vector<Segment>& rest, double start_s) {
    double speed = 0;
    for (Segment& segment : rest) {
        segment.start_s = start_s;
        if (speed < segment.lead.start_speed() * (1 - kSameSpeed)) {
            const LawLimits limits = no_faster(segment.lead_limits, segment.lead);
            const double length = segment.lead.length();
            const double end = std::min(segment.lead.end_speed(),
                                        reachable_speed(length, speed, limits.acceleration, limits.jerk));
            segment.lead = TimeLaw::between(length, speed, end, limits);
            segment.duration_s = segment.lead.duration_s();
        }
        speed = segment.lead.end_speed();
        start_s = segment.end_s();
    }
}

}  // namespace gsim::motion
