#include "motion/path/orientation_arc.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/quadratic.h"

namespace gsim::motion {

namespace {

constexpr double kNoTurn_rad = 1e-9;  // rounding of frames and inverse kinematics
constexpr double kNoAngle_rad = 1e-9;
constexpr double kThroughPole = 1e-9;
constexpr double kAtPole = 1e-7;  // sine of the tilt below which the turn is lost in the direction
constexpr double kSameEnd_rad = 1e-8;

}  // namespace

// The direction of the end, seen from the start, is split into its parts along growing tilt and along growing
// turn. This avoids cancellation if the ends are close together.
tl::expected<OrientationArc, OrientationFault> OrientationArc::between(const kinematics::TiltingHead& head,
                                                                       const rrs::JointPos& start,
                                                                       const rrs::JointPos& end) {
    const auto fault = [](OrientationFault why) { return tl::unexpected<OrientationFault>(why); };
    OrientationArc arc;
    arc.head_ = head;
    arc.anchor_ = {start[head.turn_joint], start[head.tilt_joint]};
    arc.tilt_ = arc.anchor_.tilt + head.tilt_at_zero_rad;
    arc.sine_ = std::sin(arc.tilt_);
    arc.cosine_ = std::cos(arc.tilt_);
    const double end_tilt = end[head.tilt_joint] + head.tilt_at_zero_rad;
    const double turn = end[head.turn_joint] - arc.anchor_.turn;
    const bool turns = std::abs(turn) > kNoTurn_rad;
    const double lost = turns ? 2 * squared(std::sin(turn / 2)) : 0;
    const double up = std::sin(end_tilt - arc.tilt_) - arc.cosine_ * std::sin(end_tilt) * lost;
    const double round = turns ? std::sin(end_tilt) * std::sin(turn) : 0;
    const double sine = std::hypot(up, round);
    const double cosine = std::cos(end_tilt - arc.tilt_) - arc.sine_ * std::sin(end_tilt) * lost;
    if (!(sine > kNoAngle_rad))
        return fault(cosine < 0 ? OrientationFault::opposite : OrientationFault::same);
    if (turns && std::min(std::abs(arc.sine_), std::abs(std::sin(end_tilt))) < kAtPole)
        return fault(OrientationFault::at_pole);
    arc.heading_sine_ = round / sine;
    arc.heading_cosine_ = up / sine;
    arc.side_ = arc.sine_ < 0 ? -1 : 1;
    arc.clairaut_ = arc.sine_ * arc.heading_sine_;
    arc.length_rad_ = std::atan2(sine, cosine);
    if (turns && std::abs(arc.clairaut_) < kThroughPole) return fault(OrientationFault::other_end);
    const HeadAngles reached = arc.at(arc.length_rad_).angles;
    const HeadAngles missing{end[head.turn_joint] - reached.turn, end[head.tilt_joint] - reached.tilt};
    if (!(std::max(std::abs(missing.turn), std::abs(missing.tilt)) < kSameEnd_rad))
        return fault(OrientationFault::other_end);
    arc.drift_ = {missing.turn / arc.length_rad_, missing.tilt / arc.length_rad_};
    return arc;
}

OrientationArc::Place OrientationArc::place(double from_anchor_rad) const {
    const double s = std::sin(from_anchor_rad);
    const double c = std::cos(from_anchor_rad);
    const double across = c * sine_ + s * cosine_ * heading_cosine_;
    const double aside = s * heading_sine_;
    return {across, aside, side_ * std::max(std::hypot(across, aside), std::abs(clairaut_)),
            c * cosine_ - s * sine_ * heading_cosine_, -s * cosine_ - c * sine_ * heading_cosine_};
}

HeadAngles OrientationArc::angles(double from_anchor_rad, const Place& place) const {
    HeadAngles angles{anchor_.turn + drift_.turn * from_anchor_rad,
                      anchor_.tilt + drift_.tilt * from_anchor_rad};
    if (is_meridian()) {
        angles.tilt += heading_cosine_ * from_anchor_rad;
        return angles;
    }
    angles.turn += std::atan2(side_ * place.aside, side_ * place.across);
    angles.tilt += std::atan2(place.sine, place.cosine) - std::atan2(sine_, cosine_);
    return angles;
}

HeadState OrientationArc::at(double angle_rad) const {
    const double from_anchor_rad = from_rad_ + angle_rad;
    const Place here = place(from_anchor_rad);
    HeadState state{angles(from_anchor_rad, here), {0, heading_cosine_}, {}};
    if (is_meridian()) return state;
    const double cube = here.sine * here.sine * here.sine;
    state.first = {clairaut_ / squared(here.sine), -here.cosine_slope / here.sine};
    state.second = {-2 * clairaut_ * here.cosine * state.first.tilt / cube,
                    squared(clairaut_) * here.cosine / cube};
    return state;
}

/// The cosine of the tilt is a sine wave of the path, which is shorter than half of its period. So it has one
/// extreme at most.
bool OrientationArc::passes_apex(const Place& start, const Place& end) const {
    return !is_meridian() && start.cosine_slope * end.cosine_slope < 0;
}

OrientationArc::Sines OrientationArc::sines() const {
    const Place start = place(from_rad_);
    const Place end = place(from_rad_ + length_rad_);
    const auto [least, most] = std::minmax({std::abs(start.sine), std::abs(end.sine)});
    const bool passes_equator = start.cosine * end.cosine < 0;
    return {passes_apex(start, end) ? std::abs(clairaut_) : least, passes_equator ? 1 : std::min(most, 1.0)};
}

// With x = S^2 and cos^2 h = 1 - L^2 / x:
//   turn' = L / x                            falls with x
//   tilt' = cos h                            grows with x
//   turn'' = -2 L sqrt((1 - x) (x - L^2)) / x^2, up to the sign; its square is greatest where
//            2 x^2 - 3 (1 + L^2) x + 4 L^2 = 0
//   tilt'' = L^2 cos(tilt) / S^3             falls with x
//   turn''' = 2 L (cos^2 h (3 - 2 x) / x^2 - L^2 (1 - x) / x^3): the greater one of the two parts
//   tilt''' = -L^2 cos h (3 - 2 x) / x^2
HeadBounds OrientationArc::bounds() const {
    if (is_meridian()) return {{0, 1}, {0, 0}, {0, 0}};
    const Sines range = sines();
    const double l = std::abs(clairaut_);
    const double l2 = squared(l);
    const double x = squared(range.least);
    const double cos_heading = std::sqrt(std::max(0.0, 1 - l2 / squared(range.most)));
    const double cos_tilt = std::sqrt(std::max(0.0, 1 - x));
    const double steepest = 8 * l2 / (3 * (1 + l2) + std::sqrt(9 * squared(1 + l2) - 32 * l2));
    const double at = std::clamp(steepest, x, std::max(x, squared(range.most)));
    const double bend = std::max(0.0, (1 - at) * (at - l2));
    const double pole = (3 - 2 * x) / squared(x);
    HeadBounds bounds;
    bounds.first = {l / x, cos_heading};
    bounds.second = {2 * l * std::sqrt(bend) / squared(at), l2 * cos_tilt / (x * range.least)};
    bounds.third = {2 * l * std::max(squared(cos_heading) * pole, l2 * (1 - x) / (x * x * x)),
                    l2 * cos_heading * pole};
    return bounds;
}

Range OrientationArc::tilt_range() const {
    const Place start = place(from_rad_);
    const Place end = place(from_rad_ + length_rad_);
    const auto [least, most] =
        std::minmax({angles(from_rad_, start).tilt, angles(from_rad_ + length_rad_, end).tilt});
    Range range{least, most};
    if (!passes_apex(start, end)) return range;
    const double far = std::sqrt(std::max(0.0, 1 - squared(clairaut_)));
    const double cosine = start.cosine_slope > 0 ? far : -far;
    const double apex =
        anchor_.tilt + std::atan2(side_ * std::abs(clairaut_), cosine) - std::atan2(sine_, cosine_);
    return {std::min(range.min, apex), std::max(range.max, apex)};
}

OrientationArc OrientationArc::part(double from_rad, double to_rad) const {
    OrientationArc part = *this;
    part.from_rad_ += from_rad;
    part.length_rad_ = to_rad - from_rad;
    return part;
}

}  // namespace gsim::motion
