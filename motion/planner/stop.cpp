#include "motion/planner/stop.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "motion/exact_stop/apart_move.h"
#include "motion/path/arc_part.h"
#include "motion/path/axis_space.h"
#include "motion/profile/blend_pace.h"
#include "motion/profile/law_cut.h"
#include "motion/profile/ramp.h"
#include "motion/profile/rest_law.h"

namespace gsim::motion {

namespace {

constexpr double kAsPlanned = 1e-12;      // relative
constexpr double kNoShareOfSpeed = 1e-9;  // of the highest speed
constexpr double kNoShareOfWay = 1e-9;    // of the full path

/// Distances that the leading law and the followers of a segment have covered.
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

Progress progress_at_end(const Segment& segment) {
    return progress_at(segment, segment.duration_s);
}

rrs::JointPos position_at(const Segment& segment, const Progress& progress) {
    const double length = segment.lead.length();
    const double share = length > 0 ? progress.lead / length : 0;
    rrs::JointPos position = segment.start + share * (segment.end - segment.start);
    if (segment.kind == SegmentKind::circular)
        put_position(segment.position_joints, segment.arc.at(segment.arc.phi_at(progress.lead)), position);
    if (segment.orientation) {
        const OrientationArc& way = *segment.orientation;
        const HeadAngles angles = way.at(share * way.length_rad()).angles;
        position[way.turn_joint()] = angles.turn;
        position[way.tilt_joint()] = angles.tilt;
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
    double end_speed = 0;  ///< Speed of the leading law, also if no distance remains for it.
};

/// Returns the part of the orientation path between two positions of the leading law, or null if that does
/// not move.
std::shared_ptr<const OrientationArc> orientation_part(const Segment& segment, double from, double to) {
    if (!(to > from)) return nullptr;
    const OrientationArc& way = *segment.orientation;
    const double scale = way.length_rad() / segment.lead.length();
    return std::make_shared<const OrientationArc>(way.part(from * scale, to * scale));
}

/// The part has no arc if the leading law does not move and only followers do.
void set_arc_part(const Arc& arc, double from_mm, double to_mm, Segment& segment) {
    const std::optional<Arc> part = arc_part(arc, from_mm, to_mm);
    segment.kind = part ? SegmentKind::circular : SegmentKind::linear;
    if (part) segment.arc = *part;
}

/// Returns the part of a segment that begins at `from` and runs by `laws`; `last`: to the very end.
Segment part_of(const Segment& segment, const Progress& from, const Laws& laws, bool last) {
    Segment part = segment;
    part.clear_followers();
    Progress to = from;
    to.lead = last ? progress_at_end(segment).lead : from.lead + laws.lead.length();
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
    if (segment.joints_go_apart())
        part.length_mm = apart_way_mm(part, duration_s);
    else if (segment.lead.length() > 0)
        part.length_mm = segment.length_mm * ((to.lead - from.lead) / segment.lead.length());
    if (segment.kind == SegmentKind::circular) set_arc_part(segment.arc, from.lead, to.lead, part);
    if (segment.orientation) part.orientation = orientation_part(segment, from.lead, to.lead);
    part.reaches_target = last && segment.reaches_target;
    return part;
}

Laws until(const Segment& segment, double t_s) {
    Laws laws{law_until(segment.lead, t_s), {}, t_s, segment.lead.at(t_s).v};
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        laws.followers[i] = law_until(segment.followers()[i].law, t_s);
    return laws;
}

/// All laws brake from `t_s` on; those that stop first wait for the others.
Laws braking(const Segment& segment, double t_s) {
    Laws laws{braking_law(segment.lead, t_s, segment.lead_limits), {}, 0, segment.lead.at(t_s).v};
    laws.duration_s = laws.lead.duration_s();
    if (laws.duration_s > 0) laws.end_speed = laws.lead.end_speed();
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        if (t_s < follower.law.duration_s())
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

/// Returns the remaining motion of a segment, as laws from standstill to standstill.
Laws rest_laws(const Segment& segment, const Progress& from) {
    const Progress end = progress_at_end(segment);
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
    const auto time_s = [&](double own_s) { return segment.joints_go_apart() ? own_s : laws.duration_s; };
    if (lead > 0) laws.lead = rest_law(lead, lead_limits, lead_s, time_s(lead_s));
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        const double way = end.followers[i] - from.followers[i];
        if (way > 0)
            laws.followers[i] =
                rest_law(way, no_faster(follower.limits, follower.law), least_s[i], time_s(least_s[i]));
    }
    return laws;
}

/// Returns the remainder of a segment, from standstill. It is planned for now to end with the speed with
/// which the segment was to be passed, if any.
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

/// True if a part that continues from `from` by `laws` reaches the end of its segment.
bool reaches_end(const Segment& segment, const Progress& from, const Laws& laws) {
    const auto reaches = [](double done, double law, double whole) {
        return whole - done - law <= kNoShareOfWay * whole;
    };
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const double whole = segment.followers()[i].law.length();
        if (!reaches(from.followers[i], laws.followers[i].length(), whole)) return false;
    }
    return reaches(from.lead, laws.lead.length(), segment.lead.length());
}

/// Returns the speed at the end of a part; a speed within rounding is 0.
double exit_speed(const Laws& laws, const TimeLaw& planned) {
    const double speed = std::min(laws.end_speed, planned.end_speed());
    return speed > kNoShareOfSpeed * planned.peak_speed() ? speed : 0;
}

/// Returns the laws for passing a full segment that is entered at a lower speed than planned.
Laws braking_through(const Segment& segment, double start_speed) {
    Laws laws;
    laws.lead =
        braking_law(segment.lead.length(), start_speed, segment.lead.end_speed(), segment.lead_limits);
    laws.duration_s = laws.lead.duration_s();
    laws.end_speed = laws.lead.end_speed();
    return laws;
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

/// Planned motion that is followed while it brakes.
class Brakes {
  public:
    Brakes(std::vector<Segment> planned, const rrs::JointPos& acceleration)
        : planned_(std::move(planned)), acceleration_(acceleration), clock_s_(planned_.front().start_s) {}

    StoppedMotion stop(double at_s);

  private:
    void put(std::vector<Segment>& list, Segment segment);
    bool pass_first(double t_s);
    bool pass_single(const Segment& segment, Progress from, const Laws& laws);
    bool pass_blend(const Segment& blend, double from_s);
    void leave_from(std::size_t index);

    std::vector<Segment> planned_;
    const rrs::JointPos& acceleration_;
    double clock_s_;
    double rate_ = 1;  ///< Share of the planned speed at the end of the last passed segment.
    StoppedMotion stopped_;
};

StoppedMotion Brakes::stop(double at_s) {
    if (planned_.front().kind == SegmentKind::rest || !(planned_.front().duration_s > 0)) {
        stop_rest(planned_, at_s, stopped_);
        return std::move(stopped_);
    }
    bool passed = pass_first(std::clamp(at_s - clock_s_, 0.0, planned_.front().duration_s));
    std::size_t next = 1;
    for (; passed && rate_ > 0 && next < planned_.size(); ++next) {
        const Segment& segment = planned_[next];
        passed = segment.beside
                     ? pass_blend(segment, 0)
                     : pass_single(segment, {}, braking_through(segment, rate_ * segment.lead.start_speed()));
    }
    leave_from(next);
    return std::move(stopped_);
}

void Brakes::put(std::vector<Segment>& list, Segment segment) {
    segment.start_s = clock_s_;
    clock_s_ += segment.duration_s;
    if (segment.duration_s > 0) list.push_back(std::move(segment));
}

/// Returns true if the segment that has been active for `t_s` is braked beyond its end.
bool Brakes::pass_first(double t_s) {
    const Segment& first = planned_.front();
    if (first.beside) {
        put(stopped_.done, segment_until(first, t_s));
        return pass_blend(first, t_s);
    }
    put(stopped_.done, segment_until(first, t_s));
    return pass_single(first, progress_at(first, t_s), braking(first, t_s));
}

bool Brakes::pass_single(const Segment& segment, Progress from, const Laws& laws) {
    const bool passed = reaches_end(segment, from, laws);
    const Segment part = part_of(segment, from, laws, passed);
    put(stopped_.braking, part);
    stopped_.position = part.end;
    if (passed) {
        const double speed = exit_speed(laws, segment.lead);
        rate_ = speed > 0 ? speed / segment.lead.end_speed() : 0;
        return true;
    }
    from.lead += laws.lead.length();
    for (std::size_t i = 0; i < part.followers().size(); ++i) from.followers[i] += laws.followers[i].length();
    stopped_.rest.push_back(rest_of(segment, from));
    return false;
}

bool Brakes::pass_blend(const Segment& blend, double from_s) {
    BlendPace pace{{}, from_s, 0};
    if (!stands(blend, from_s)) pace = slow_down(blend, from_s, rate_, acceleration_);
    for (Segment& part : pace.parts) put(stopped_.braking, std::move(part));
    stopped_.position = blend.position_at(pace.until_s);
    if (pace.until_s >= blend.duration_s) {
        rate_ = stands(blend, blend.duration_s) ? 0 : pace.rate;
        return true;
    }
    stopped_.rest.push_back(blend_part(blend, pace.until_s, blend.duration_s));
    return false;
}

void Brakes::leave_from(std::size_t index) {
    const auto first = planned_.begin() + static_cast<std::ptrdiff_t>(index);
    stopped_.rest.insert(stopped_.rest.end(), std::make_move_iterator(first),
                         std::make_move_iterator(planned_.end()));
}

/// Returns the ratio of the speed at the end of a segment to the planned start speed of the next one.
double entry_rate(double speed, const Segment& next) {
    const double planned = next.lead.start_speed();
    return speed < planned * (1 - kAsPlanned) ? speed / planned : 1;
}

/// Plans a segment without a superimposed motion to start at a lower speed than planned.
void start_slower(double speed, Segment& segment) {
    const LawLimits limits = no_faster(segment.lead_limits, segment.lead);
    const double length = segment.lead.length();
    const double end =
        std::min(segment.lead.end_speed(), reachable_speed(length, speed, limits.acceleration, limits.jerk));
    segment.lead = TimeLaw::between(length, speed, end, limits);
    segment.duration_s = segment.lead.duration_s();
}

}  // namespace

Segment segment_until(const Segment& segment, double t_s) {
    if (segment.beside) return blend_part(segment, 0, t_s);
    return part_of(segment, {}, until(segment, t_s), false);
}

StoppedMotion stop_motion(std::vector<Segment> planned, double at_s, const rrs::JointPos& acceleration) {
    return Brakes(std::move(planned), acceleration).stop(at_s);
}

std::vector<Segment> restart_motion(std::vector<Segment> rest, const rrs::JointPos& acceleration) {
    std::vector<Segment> motion;
    motion.reserve(rest.size());
    double rate = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        Segment& segment = rest[i];
        if (segment.beside && rate < 1 && !stands(segment, 0)) {
            BlendPace pace = speed_up(segment, rate, acceleration);
            std::move(pace.parts.begin(), pace.parts.end(), std::back_inserter(motion));
            rate = pace.rate;
            continue;
        }
        if (!segment.beside && rate < 1 && segment.lead.start_speed() > 0)
            start_slower(rate * segment.lead.start_speed(), segment);
        rate = 1;
        if (!segment.beside && i + 1 < rest.size()) rate = entry_rate(segment.lead.end_speed(), rest[i + 1]);
        motion.push_back(std::move(segment));
    }
    return motion;
}

}  // namespace gsim::motion
