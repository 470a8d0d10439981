#include "motion/linuxcnc/pacer.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/linuxcnc/parabola.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kShortRamp_s = 0.01;   // feed sub-segments of less time than this are one ramp
constexpr std::size_t kKeptPieces = 4;  // a group's end never starts to be shared earlier than with these

// Returns the limit that kept the sub-segment from being faster. `slowed_by` is the limit of the speed at its
// end.
LimitedBy limit_of(const Piece& piece, double share, const Law& law, bool from_rest, bool to_rest,
                   LimitKind slowed_by) {
    if (law.top_speed() >= target_speed(piece, share) * (1 - 1e-6)) {
        return piece.rapid && share < 1 ? LimitedBy{LimitKind::rapid_override, -1} : piece.speed_limit;
    }
    if (from_rest && to_rest) return piece.acceleration_limit;
    if (from_rest || to_rest) return {LimitKind::stop, -1};
    return {slowed_by, -1};
}

constexpr double kNothingLeft = 1e-6;     // mm or degrees
constexpr double kLeastShortened = 1000;  // times that: shorter distances run to their end

// LinuxCNC ends an S-curve in the first period in which almost no distance remains. The returned law ends
// with that period; `before_s` is the time before the law.
Law without_creep(const Law& law, const Piece& piece, double before_s, double period_s) {
    const double nothing = kNothingLeft * (piece.path_limited ? 1 : kRadPerDeg);
    if (std::isinf(piece.jerk) || law.length() < kLeastShortened * nothing) return law;
    const double least_s = before_s + law.time_at(law.length() - nothing);
    const double end_s = std::ceil(least_s / period_s - kWholePeriods) * period_s - before_s;
    return end_s < law.duration_s() ? law.sooner(law.duration_s() - end_s) : law;
}

}  // namespace

void Pacer::advance(PieceQueue& queue, bool ended) {
    ended_ = ended;
    final_ = ended || queue.empty() ? queue.size() : queue.size() - 1;
    while (next_ < final_) {
        look_for_end(queue);
        if (!can_time(queue)) return;
        time_next(queue);
    }
}

std::size_t Pacer::ready() const {
    return next_ - std::min(group_.pieces, kKeptPieces);
}

void Pacer::drop(std::size_t count) {
    next_ -= count;
    seen_ = std::max(seen_, count) - count;
}

void Pacer::clear() {
    *this = Pacer(depth_, clock_, planning_, *axes_);
}

// Each sub-segment is checked once: the next search continues at the end of the last one.
void Pacer::look_for_end(const PieceQueue& queue) {
    seen_ = std::max(seen_, next_);
    const auto tangent = [&](std::size_t index) {
        return queue[index].piece.term == Term::tangent && !(ended_ && index + 1 == final_);
    };
    while (seen_ < final_ && tangent(seen_)) ++seen_;
    end_known_ = seen_ < final_;
}

// The first sub-segment of the next group must also be known at the end of a group.
bool Pacer::can_time(const PieceQueue& queue) const {
    if (!end_known_) return next_ + depth_ < final_;
    const bool blends = seen_ == next_ && queue[next_].piece.term == Term::parabola;
    return !blends || ended_ || next_ + 1 < final_;
}

Horizon Pacer::horizon() const {
    Horizon horizon;
    if (end_known_) horizon.run_end = seen_;
    horizon.run_end_is_last = ended_ && seen_ + 1 == final_;
    horizon.depth = depth_;
    return horizon;
}

void Pacer::time_next(PieceQueue& queue) {
    const bool from_rest = group_.pieces == 0;
    LimitKind slowed_by = LimitKind::corner;
    const Profile profile =
        schedule_ != nullptr ? overridden_profile(queue, slowed_by) : profile_of(queue, slowed_by);
    HeldPiece& held = queue[next_];
    held.ends_group = end_known_ && seen_ == next_;
    held.shared_s = held.written_s = 0;
    held.law = profile.law;
    held.limited_by =
        limit_of(held.piece, share_of(held.piece), held.law, from_rest, held.ends_group, slowed_by);
    ++next_;
    ++group_.pieces;
    group_.duration_s += held.law.duration_s();
    group_.speed = profile.end_speed;
    group_.acceleration = profile.end_acceleration;
    if (held.ends_group) end_group(queue, profile);
}

Profile Pacer::profile_of(PieceQueue& queue, LimitKind& slowed_by) {
    return end_known_ && seen_ == next_ ? last_of_group(queue) : pass_on(queue, slowed_by);
}

Profile Pacer::pass_on(const PieceQueue& queue, LimitKind& slowed_by) const {
    const Piece& piece = queue[next_].piece;
    const JunctionSpeed junction = planning_.s_curves ? curved_junction_speed(queue, next_, horizon())
                                                      : junction_speed(queue, next_, horizon());
    slowed_by = junction.limit;
    const double own = target_speed(piece, share_of(piece));
    const Piece& behind = queue[next_ + 1].piece;
    const double end_speed = std::min({junction.speed, own, target_speed(behind, share_of(behind))});
    const double mean_speed = (group_.speed + std::min(junction.speed, own)) / 2;
    const Law start = started(piece);
    const double from = start_speed(start);
    Stretch stretch = stretch_of(piece);
    stretch.length -= start.length();
    const bool gains_all = from * from + 2 * stretch.acceleration * stretch.length <= end_speed * end_speed;
    const bool is_short = !planning_.s_curves && piece.length < kShortRamp_s * mean_speed;
    if (!gains_all && !piece.rapid && end_speed > 0 && is_short) {
        return ramp(piece.length, group_.speed, end_speed);
    }
    return continued(start, from_speed_to_speed(stretch, from, end_speed));
}

// A group takes full periods: it dwells for the remainder of the last one.
Profile Pacer::last_of_group(const PieceQueue& queue) {
    Stretch stretch = stretch_of(queue[next_].piece);
    const bool late = blends_late(queue, next_);
    const bool from_rest = group_.pieces == 0 && late_acceleration_ <= 0;
    if (from_rest && !late && std::isinf(stretch.jerk)) return rest_to_rest(stretch, clock_);
    const Law start = started(queue[next_].piece);
    stretch.length -= start.length();
    Profile profile = continued(start, from_speed_to_speed(stretch, start_speed(start), 0));
    if (late) profile = to_late_blend(queue, profile);
    if (!clock_.counts) return profile;
    profile.law = without_creep(profile.law, queue[next_].piece, group_.duration_s, clock_.period_s);
    const double motion_s = group_.duration_s + profile.law.duration_s();
    const double rest_s = std::ceil(motion_s / clock_.period_s - kWholePeriods) * clock_.period_s - motion_s;
    profile.law.rest(rest_s);
    if (late) profile.brake_s += rest_s;
    return profile;
}

void Pacer::end_group(PieceQueue& queue, const Profile& profile) {
    const HeldPiece& last = queue[next_ - 1];
    double overlap = 0;
    const bool late = blends_late(queue, next_ - 1);
    late_acceleration_ = 0;
    if (last.piece.term == Term::parabola && next_ < queue.size()) {
        overlap = late ? profile.brake_s : overlap_s(queue, profile);
        if (late) late_acceleration_ = late_acceleration(queue);
        overlap = std::clamp(overlap, 0.0, std::max(0.0, group_.duration_s - shared_before_s_));
        share_end(queue, overlap);
    }
    shared_before_s_ = overlap;
    group_start_s_ += group_.duration_s - overlap;
    group_ = {};
}

// The next sub-segment starts in the first period in which the last one, as it brakes, is slow enough.
double Pacer::overlap_s(const PieceQueue& queue, const Profile& profile) const {
    const Piece& last = queue[next_ - 1].piece;
    const Piece& next = queue[next_].piece;
    const double before = parabola_between(last, next, share_of(last), share_of(next)).before;
    const double brake_s = profile.brake_s;
    const double slowing_s = std::isfinite(last.jerk) ? slow_s(profile, before) : before / acceleration(last);
    if (!clock_.counts) return std::min(slowing_s, brake_s);
    const double slow = slowing_s / clock_.period_s, brake = brake_s / clock_.period_s;
    const double periods = std::ceil(brake - kWholePeriods);
    return clock_.period_s *
           (brake < slow ? periods + 1 : periods - std::floor(brake - slow + kWholePeriods));
}

void Pacer::share_end(PieceQueue& queue, double overlap_s) const {
    const std::size_t first = next_ - std::min(next_, group_.pieces);
    for (std::size_t index = next_; index > first && overlap_s > 0; --index) {
        HeldPiece& held = queue[index - 1];
        held.shared_s = std::min(overlap_s, held.left_s());
        overlap_s -= held.shared_s;
    }
}

}  // namespace gsim::motion::linuxcnc
