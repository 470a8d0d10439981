#include "motion/planner/stop.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "motion/exact_stop/uncoordinated_move.h"
#include "motion/path/arc_part.h"
#include "motion/path/axis_space.h"
#include "motion/profile/law_cut.h"
#include "motion/profile/ramp.h"
#include "motion/profile/rest_to_rest_law.h"
#include "motion/profile/scaled_blend.h"

namespace gsim::motion {

namespace {

constexpr double kPlannedTolerance = 1e-12;  // relative
constexpr double kMinSpeedShare = 1e-9;      // of the highest speed
constexpr double kMinPathShare = 1e-9;       // of the full path

/// Distances that the leading law and the followers of a segment have covered.
struct Progress {
    double master = 0;
    std::array<double, rrs::kMaxJoints> followers{};
};

Progress progress_at(const Segment& segment, double t_s) {
    Progress progress{segment.master.at(t_s).s, {}};
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        progress.followers[i] = segment.followers()[i].law.at(t_s).s;
    return progress;
}

Progress progress_at_end(const Segment& segment) {
    return progress_at(segment, segment.duration_s);
}

rrs::JointPos position_at(const Segment& segment, const Progress& progress) {
    const double length = segment.master.length();
    const double share = length > 0 ? progress.master / length : 0;
    rrs::JointPos position = segment.start + share * (segment.end - segment.start);
    if (segment.kind == SegmentKind::circular)
        write_position(segment.position_joints, segment.arc.at(segment.arc.phi_at(progress.master)),
                       position);
    if (segment.orientation) {
        const OrientationArc& travel = *segment.orientation;
        const HeadAngles angles = travel.at(share * travel.length_rad()).angles;
        position[travel.turn_joint()] = angles.turn;
        position[travel.tilt_joint()] = angles.tilt;
    }
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        position[follower.joint] = segment.start[follower.joint] + follower.sign * progress.followers[i];
    }
    return position;
}

/// The laws of a part of a segment.
struct SegmentLaws {
    TimeLaw master;
    std::array<TimeLaw, rrs::kMaxJoints> followers;
    double duration_s = 0;
    double end_speed = 0;  ///< Speed of the leading law, also if no distance remains for it.
};

/// Returns the part of the orientation path between two positions of the leading law, or null if that does
/// not move.
std::shared_ptr<const OrientationArc> orientation_part(const Segment& segment, double from, double to) {
    if (!(to > from)) return nullptr;
    const OrientationArc& travel = *segment.orientation;
    const double scale = travel.length_rad() / segment.master.length();
    return std::make_shared<const OrientationArc>(travel.part(from * scale, to * scale));
}

/// The part has no arc if the leading law does not move and only followers do.
void set_arc_part(const Arc& arc, double from_mm, double to_mm, Segment& segment) {
    const std::optional<Arc> part = arc_part(arc, from_mm, to_mm);
    segment.kind = part ? SegmentKind::circular : SegmentKind::linear;
    if (part) segment.arc = *part;
}

/// Returns the part of a segment that begins at `from` and runs by `laws`; `last`: to the very end.
Segment segment_part(const Segment& segment, const Progress& from, const SegmentLaws& laws, bool last) {
    Segment part = segment;
    part.clear_followers();
    Progress to = from;
    to.master = last ? progress_at_end(segment).master : from.master + laws.master.length();
    const double duration_s = laws.duration_s;
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        to.followers[i] += laws.followers[i].length();
        part.add_follower(follower.joint, follower.sign, laws.followers[i], follower.limits);
    }
    part.start = position_at(segment, from);
    part.end = last ? segment.end : position_at(segment, to);
    part.master = laws.master;
    part.duration_s = duration_s;
    if (segment.is_uncoordinated())
        part.length_mm = uncoordinated_distance_mm(part, duration_s);
    else if (segment.master.length() > 0)
        part.length_mm = segment.length_mm * ((to.master - from.master) / segment.master.length());
    if (segment.kind == SegmentKind::circular) set_arc_part(segment.arc, from.master, to.master, part);
    if (segment.orientation) part.orientation = orientation_part(segment, from.master, to.master);
    part.reaches_target = last && segment.reaches_target;
    return part;
}

SegmentLaws laws_until(const Segment& segment, double t_s) {
    SegmentLaws laws{law_until(segment.master, t_s), {}, t_s, segment.master.at(t_s).v};
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        laws.followers[i] = law_until(segment.followers()[i].law, t_s);
    return laws;
}

/// All laws brake from `t_s` on; those that stop first wait for the others.
SegmentLaws braking(const Segment& segment, double t_s) {
    SegmentLaws laws{
        braking_law(segment.master, t_s, segment.master_limits), {}, 0, segment.master.at(t_s).v};
    laws.duration_s = laws.master.duration_s();
    if (laws.duration_s > 0) laws.end_speed = laws.master.end_speed();
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        if (t_s < follower.law.duration_s())
            laws.followers[i] = braking_law(follower.law, t_s, follower.limits);
        laws.duration_s = std::max(laws.duration_s, laws.followers[i].duration_s());
    }
    if (segment.followers().empty()) return laws;
    laws.master = extend_with_standstill(laws.master, laws.duration_s);
    for (std::size_t i = 0; i < segment.followers().size(); ++i)
        laws.followers[i] = extend_with_standstill(laws.followers[i], laws.duration_s);
    return laws;
}

LawLimits limit_to_peak(LawLimits limits, const TimeLaw& law) {
    limits.max_speed = std::min(limits.max_speed, law.peak_speed());
    return limits;
}

/// Returns the remaining motion of a segment, as laws from standstill to standstill.
SegmentLaws remaining_laws(const Segment& segment, const Progress& from) {
    const Progress end = progress_at_end(segment);
    const double master = std::max(end.master - from.master, 0.0);
    const LawLimits master_limits = limit_to_peak(segment.master_limits, segment.master);
    const double master_s = master > 0 ? min_rest_to_rest_s(master, master_limits) : 0;
    std::array<double, rrs::kMaxJoints> min_s{};
    SegmentLaws laws;
    laws.duration_s = master_s;
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        const double travel = end.followers[i] - from.followers[i];
        if (travel > 0) min_s[i] = min_rest_to_rest_s(travel, limit_to_peak(follower.limits, follower.law));
        laws.duration_s = std::max(laws.duration_s, min_s[i]);
    }
    const auto time_s = [&](double law_s) { return segment.is_uncoordinated() ? law_s : laws.duration_s; };
    if (master > 0) laws.master = rest_to_rest_law(master, master_limits, master_s, time_s(master_s));
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const Follower& follower = segment.followers()[i];
        const double travel = end.followers[i] - from.followers[i];
        if (travel > 0)
            laws.followers[i] = rest_to_rest_law(travel, limit_to_peak(follower.limits, follower.law),
                                                 min_s[i], time_s(min_s[i]));
    }
    return laws;
}

/// Returns the remainder of a segment, from standstill. It is planned for now to end with the speed with
/// which the segment was to be passed, if any.
Segment remaining_segment(const Segment& segment, const Progress& from) {
    SegmentLaws laws = remaining_laws(segment, from);
    const double exit = segment.master.end_speed();
    const double master = segment.master.length() - from.master;
    if (exit > 0 && master > 0) {
        const LawLimits limits = limit_to_peak(segment.master_limits, segment.master);
        const double end = std::min(exit, reachable_speed(master, 0, limits.acceleration, limits.jerk));
        laws.master = TimeLaw::between(master, 0, end, limits);
        laws.duration_s = laws.master.duration_s();
    }
    return segment_part(segment, from, laws, true);
}

/// True if a part that continues from `from` by `laws` reaches the end of its segment.
bool reaches_end(const Segment& segment, const Progress& from, const SegmentLaws& laws) {
    const auto reaches = [](double done, double law, double full_distance) {
        return full_distance - done - law <= kMinPathShare * full_distance;
    };
    for (std::size_t i = 0; i < segment.followers().size(); ++i) {
        const double full_distance = segment.followers()[i].law.length();
        if (!reaches(from.followers[i], laws.followers[i].length(), full_distance)) return false;
    }
    return reaches(from.master, laws.master.length(), segment.master.length());
}

/// Returns the speed at the end of a part; a speed within rounding is 0.
double exit_speed(const SegmentLaws& laws, const TimeLaw& planned) {
    const double speed = std::min(laws.end_speed, planned.end_speed());
    return speed > kMinSpeedShare * planned.peak_speed() ? speed : 0;
}

/// Returns the laws for passing a full segment that is entered at a lower speed than planned.
SegmentLaws full_braking_laws(const Segment& segment, double start_speed) {
    SegmentLaws laws;
    laws.master =
        braking_law(segment.master.length(), start_speed, segment.master.end_speed(), segment.master_limits);
    laws.duration_s = laws.master.duration_s();
    laws.end_speed = laws.master.end_speed();
    return laws;
}

void stop_in_dwell(std::vector<Segment>& planned, double at_s, StoppedMotion& stopped) {
    Segment& dwell = planned.front();
    const double done_s = std::clamp(at_s - dwell.start_s, 0.0, dwell.duration_s);
    stopped.position = dwell.start;
    Segment done = dwell;
    done.duration_s = done_s;
    done.reaches_target = false;
    if (done_s > 0) stopped.done.push_back(done);
    dwell.duration_s -= done_s;
    stopped.remainder = std::move(planned);
}

/// Planned motion that is followed while it brakes.
class StopPlanner {
  public:
    StopPlanner(std::vector<Segment> planned, const rrs::JointPos& acceleration)
        : planned_segments_(std::move(planned)),
          acceleration_(acceleration),
          clock_s_(planned_segments_.front().start_s) {}

    StoppedMotion stop(double at_s);

  private:
    void append(std::vector<Segment>& list, Segment segment);
    bool pass_first(double t_s);
    bool pass_single(const Segment& segment, Progress from, const SegmentLaws& laws);
    bool pass_blend(const Segment& blend, double from_s);
    void append_remaining(std::size_t index);

    std::vector<Segment> planned_segments_;
    const rrs::JointPos& acceleration_;
    double clock_s_;
    double rate_ = 1;  ///< Share of the planned speed at the end of the last passed segment.
    StoppedMotion stopped_;
};

StoppedMotion StopPlanner::stop(double at_s) {
    if (planned_segments_.front().kind == SegmentKind::rest || !(planned_segments_.front().duration_s > 0)) {
        stop_in_dwell(planned_segments_, at_s, stopped_);
        return std::move(stopped_);
    }
    bool passed = pass_first(std::clamp(at_s - clock_s_, 0.0, planned_segments_.front().duration_s));
    std::size_t next = 1;
    for (; passed && rate_ > 0 && next < planned_segments_.size(); ++next) {
        const Segment& segment = planned_segments_[next];
        passed =
            segment.superimposed
                ? pass_blend(segment, 0)
                : pass_single(segment, {}, full_braking_laws(segment, rate_ * segment.master.start_speed()));
    }
    append_remaining(next);
    return std::move(stopped_);
}

void StopPlanner::append(std::vector<Segment>& list, Segment segment) {
    segment.start_s = clock_s_;
    clock_s_ += segment.duration_s;
    if (segment.duration_s > 0) list.push_back(std::move(segment));
}

/// Returns true if the segment that has been active for `t_s` is braked beyond its end.
bool StopPlanner::pass_first(double t_s) {
    const Segment& first = planned_segments_.front();
    if (first.superimposed) {
        append(stopped_.done, segment_until(first, t_s));
        return pass_blend(first, t_s);
    }
    append(stopped_.done, segment_until(first, t_s));
    return pass_single(first, progress_at(first, t_s), braking(first, t_s));
}

bool StopPlanner::pass_single(const Segment& segment, Progress from, const SegmentLaws& laws) {
    const bool passed = reaches_end(segment, from, laws);
    const Segment part = segment_part(segment, from, laws, passed);
    append(stopped_.braking, part);
    stopped_.position = part.end;
    if (passed) {
        const double speed = exit_speed(laws, segment.master);
        rate_ = speed > 0 ? speed / segment.master.end_speed() : 0;
        return true;
    }
    from.master += laws.master.length();
    for (std::size_t i = 0; i < part.followers().size(); ++i) from.followers[i] += laws.followers[i].length();
    stopped_.remainder.push_back(remaining_segment(segment, from));
    return false;
}

bool StopPlanner::pass_blend(const Segment& blend, double from_s) {
    ScaledBlend scaled_blend{{}, from_s, 0};
    if (!is_stationary(blend, from_s)) scaled_blend = slow_down(blend, from_s, rate_, acceleration_);
    for (Segment& part : scaled_blend.parts) append(stopped_.braking, std::move(part));
    stopped_.position = blend.position_at(scaled_blend.until_s);
    if (scaled_blend.until_s >= blend.duration_s) {
        rate_ = is_stationary(blend, blend.duration_s) ? 0 : scaled_blend.rate;
        return true;
    }
    stopped_.remainder.push_back(blend_part(blend, scaled_blend.until_s, blend.duration_s));
    return false;
}

void StopPlanner::append_remaining(std::size_t index) {
    const auto first = planned_segments_.begin() + static_cast<std::ptrdiff_t>(index);
    stopped_.remainder.insert(stopped_.remainder.end(), std::make_move_iterator(first),
                              std::make_move_iterator(planned_segments_.end()));
}

/// Returns the ratio of the speed at the end of a segment to the planned start speed of the next one.
double entry_rate(double speed, const Segment& next) {
    const double planned = next.master.start_speed();
    return speed < planned * (1 - kPlannedTolerance) ? speed / planned : 1;
}

/// Plans a segment without a superimposed motion to start at a lower speed than planned.
void start_slower(double speed, Segment& segment) {
    const LawLimits limits = limit_to_peak(segment.master_limits, segment.master);
    const double length = segment.master.length();
    const double end = std::min(segment.master.end_speed(),
                                reachable_speed(length, speed, limits.acceleration, limits.jerk));
    segment.master = TimeLaw::between(length, speed, end, limits);
    segment.duration_s = segment.master.duration_s();
}

}  // namespace

Segment segment_until(const Segment& segment, double t_s) {
    if (segment.superimposed) return blend_part(segment, 0, t_s);
    return segment_part(segment, {}, laws_until(segment, t_s), false);
}

StoppedMotion stop_motion(std::vector<Segment> planned, double at_s, const rrs::JointPos& acceleration) {
    return StopPlanner(std::move(planned), acceleration).stop(at_s);
}

std::vector<Segment> restart_motion(std::vector<Segment> remainder, const rrs::JointPos& acceleration) {
    std::vector<Segment> motion;
    motion.reserve(remainder.size());
    double rate = 0;
    for (std::size_t i = 0; i < remainder.size(); ++i) {
        Segment& segment = remainder[i];
        if (segment.superimposed && rate < 1 && !is_stationary(segment, 0)) {
            ScaledBlend scaled_blend = speed_up(segment, rate, acceleration);
            std::move(scaled_blend.parts.begin(), scaled_blend.parts.end(), std::back_inserter(motion));
            rate = scaled_blend.rate;
            continue;
        }
        if (!segment.superimposed && rate < 1 && segment.master.start_speed() > 0)
            start_slower(rate * segment.master.start_speed(), segment);
        rate = 1;
        if (!segment.superimposed && i + 1 < remainder.size())
            rate = entry_rate(segment.master.end_speed(), remainder[i + 1]);
        motion.push_back(std::move(segment));
    }
    return motion;
}

}  // namespace gsim::motion
