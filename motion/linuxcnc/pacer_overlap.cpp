// A sub-segment has its full acceleration until the next one starts, since release 2.10. After that it has
// half of it, which is too little for its remaining distance: it arrives with speed, and stops within a
// period.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/pacer.h"
#include "motion/linuxcnc/parabola.h"

namespace gsim::motion::linuxcnc {

namespace {

// Share of the initial speed that is lost, at half of the acceleration, when the distance is used up.
constexpr double kLostShare = 1 - 1 / std::numbers::sqrt2;

}  // namespace

bool Pacer::blends_late(const PieceQueue& queue, std::size_t index) const {
    return planning_.since_2_10 && !planning_.s_curves && queue[index].piece.term == Term::parabola &&
           index + 1 < queue.size();
}

/// Returns how the next sub-segment begins, if it is the first of its group and the last one is still active,
/// or if it begins with an acceleration.
Law Pacer::started(const Piece& piece) const {
    Law start;
    if (group_.acceleration != 0 && std::isfinite(piece.jerk)) {
        start = easing(group_.speed, group_.acceleration, piece.jerk);
        return start.length() < piece.length ? start : Law();
    }
    if (group_.pieces > 0 || late_acceleration_ <= 0) return start;
    const double half_way_s = std::sqrt(piece.length / late_acceleration_);
    start.add(std::min(shared_before_s_, half_way_s), 0, late_acceleration_);
    return start;
}

/// Returns the profile of the last sub-segment of a group that stops, with half of the acceleration after the
/// next one starts.
Profile Pacer::to_late_blend(const PieceQueue& queue, const Profile& profile) const {
    const Piece& piece = queue[next_].piece;
    const Piece& next = queue[next_ + 1].piece;
    const double a = acceleration_alone(piece, planning_);
    const double blend_s = parabola_between(piece, next, share_of(piece), share_of(next)).before / a;
    const double periods = std::max(0.0, std::floor((profile.brake_s - blend_s) / planning_.period_s));
    const double halved_s = std::max(0.0, profile.brake_s - periods * planning_.period_s);
    Profile late;
    late.law = profile.law.part(0, profile.law.duration_s() - halved_s);
    late.brake_s = 2 * kLostShare * halved_s;
    late.law.add(late.brake_s, halved_s * a, -a / 2);
    return late;
}

/// Returns the acceleration of the next sub-segment while it overlaps the last one. Its speed rises with the
/// last one's speed.
double Pacer::late_acceleration(const PieceQueue& queue) const {
    const Piece& last = queue[next_ - 1].piece;
    const Piece& next = queue[next_].piece;
    const Parabola parabola = parabola_between(last, next, share_of(last), share_of(next));
    const double rise = acceleration_alone(last, planning_) * parabola.after / parabola.before;
    return std::min(rise, acceleration_alone(next, planning_)) / 2;
}

}  // namespace gsim::motion::linuxcnc
