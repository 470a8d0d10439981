// Operator overrides in the velocity planner: in each period the controller aims at the speed that they
// request then.

#include <algorithm>
#include <cmath>

#include "motion/linuxcnc/pacer.h"
#include "motion/linuxcnc/way.h"
#include "motion/segment/move_part.h"

namespace gsim::motion::linuxcnc {

Stretch Pacer::stretch_of(const Piece& piece) const {
    return {piece.length, target_speed(piece, share_of(piece)), acceleration_alone(piece, planning_),
            piece.jerk};
}

/// Returns the motion of the next sub-segment, or of its part up to an override change. The other part is
/// then a sub-segment after it.
Profile Pacer::overridden_profile(PieceQueue& queue, LimitKind& slowed_by) {
    const double start_s = group_start_s_ + group_.duration_s;
    overrides_ = schedule_->at(start_s);
    const Piece& piece = queue[next_].piece;
    const bool held = share_of(piece) <= 0;
    if (held && group_.speed > kNoSpeed) {
        const Profile brakes = braking_profile(queue);
        return cut_profile(queue, brakes, schedule_->next_change_s(start_s) - start_s);
    }
    double from_s = held ? schedule_->free_s(start_s, piece.obeyed, piece.rapid) : start_s;
    overrides_ = schedule_->at(from_s);
    Profile profile = profile_of(queue, slowed_by);
    double next_s = schedule_->next_change_s(from_s);
    while (profile.law.at(next_s - from_s) <= kLeastPart && std::isfinite(next_s)) {
        overrides_ = schedule_->at(next_s);
        if (share_of(piece) <= 0) break;
        profile = profile_of(queue, slowed_by);
        next_s = schedule_->next_change_s(next_s);
    }
    if (from_s > start_s) {
        Law rest;
        rest.rest(from_s - start_s);
        profile = continued(rest, profile);
    }
    return cut_profile(queue, profile, next_s - start_s);
}

/// Brakes as hard as the sub-segment can, to standstill or to its end.
Profile Pacer::braking_profile(PieceQueue& queue) {
    const Piece& piece = queue[next_].piece;
    if (std::isfinite(piece.jerk)) return curved_braking_profile(queue);
    const double a = acceleration_alone(piece, planning_);
    const double way = group_.speed * group_.speed / (2 * a);
    if (way < piece.length - kLeastPart) {
        split(queue, std::max(way, kLeastPart));
        return ramp(queue[next_].piece.length, group_.speed, 0);
    }
    const bool stops = end_known_ && seen_ == next_;
    const double left = group_.speed * group_.speed - 2 * a * piece.length;
    return ramp(piece.length, group_.speed, stops ? 0 : std::sqrt(std::max(left, 0.0)));
}

Profile Pacer::curved_braking_profile(PieceQueue& queue) {
    const Piece& piece = queue[next_].piece;
    const Law start = started(piece);
    Stretch stretch = stretch_of(piece);
    stretch.length -= start.length();
    const double from = start_speed(start);
    const bool stops = end_known_ && seen_ == next_;
    const Profile brakes = continued(start, braking(stretch, from, stops ? 0 : from));
    if (brakes.law.length() < piece.length - kLeastPart)
        split(queue, std::max(brakes.law.length(), kLeastPart));
    return brakes;
}

/// Returns the motion until `t_s` after its start, if the sub-segment is then on its path.
Profile Pacer::cut_profile(PieceQueue& queue, const Profile& profile, double t_s) {
    if (!(t_s < profile.law.duration_s())) return profile;
    const double way = profile.law.at(t_s);
    if (way <= kLeastPart || way >= queue[next_].piece.length - kLeastPart) return profile;
    Profile part;
    part.law = profile.law.part(0, t_s);
    part.end_speed = profile.law.speed_at(t_s);
    if (std::isfinite(queue[next_].piece.jerk)) part.end_acceleration = part.law.end_acceleration();
    split(queue, way);
    return part;
}

/// Cuts the next sub-segment into two, which meet at speed.
void Pacer::split(PieceQueue& queue, double length) {
    queue.duplicate(next_);
    ++seen_;
    ++final_;
    Piece& first = queue[next_].piece;
    Piece& second = queue[next_ + 1].piece;
    const bool halved = first.after_parabola || first.term == Term::parabola;
    const bool on_lead_in = first.lead_in > 0 && length <= first.lead_in + kLeastPart;
    if (on_lead_in) length = std::min(length, first.lead_in);
    const Piece whole = first;
    const WayPart part = way_part(whole, *axes_, on_lead_in ? 0 : whole.lead_in, length);
    first.end = second.start = part.end;
    first.length = length;
    second.length = whole.length - length;
    first.term = Term::tangent;
    first.after_parabola = second.after_parabola = halved;
    first.kink_speed = -1;
    first.deviation_mm = 0;
    if (on_lead_in) {
        first.curved = false;
        first.target_id = whole.lead_in_id;
        first.lead_in = 0;
        second.lead_in -= length;
        return;
    }
    second.lead_in = 0;
    if (!whole.curved) return;
    const WayPart rest = way_part(whole, *axes_, length, whole.length);
    first.curved = part.curved;
    second.curved = rest.curved;
    first.arc = part.arc;
    second.arc = rest.arc;
}

}  // namespace gsim::motion::linuxcnc
