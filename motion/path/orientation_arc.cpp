#include "motion/path/orientation_arc.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/quadratic.h"

namespace gsim::motion {

namespace {

constexpr double kTurnTolerance_rad = 1e-9;  // rounding of frames and inverse kinematics
constexpr double kAngleTolerance_rad = 1e-9;
constexpr double kPoleTolerance = 1e-9;
constexpr double kPoleSineTolerance = 1e-7;  // sine of the tilt below which the turn is lost in the direction
constexpr double kEndTolerance_rad = 1e-8;

}  // namespace

// The direction of the end, seen from the start, is split into its parts along growing tilt and along growing
// turn. This avoids cancellation if the ends are close together.
tl::expected<OrientationArc, OrientationError> OrientationArc::between(const kinematics::TiltingHead& head,
                                                                       const rrs::JointPos& start,
                                                                       const rrs::JointPos& end) {
    const auto error = [](OrientationError reason) { return tl::unexpected<OrientationError>(reason); };
    OrientationArc arc;
    arc.head_ = head;
    arc.anchor_ = {start[head.turn_joint], start[head.tilt_joint]};
    arc.tilt_ = arc.anchor_.tilt + head.tilt_at_zero_rad;
    arc.sine_ = std::sin(arc.tilt_);
    arc.cosine_ = std::cos(arc.tilt_);
    const double end_tilt = end[head.tilt_joint] + head.tilt_at_zero_rad;
    const double turn = end[head.turn_joint] - arc.anchor_.turn;
    const bool turns = std::abs(turn) > kTurnTolerance_rad;
    const double lost = turns ? 2 * squared(std::sin(turn / 2)) : 0;
    const double up = std::sin(end_tilt - arc.tilt_) - arc.cosine_ * std::sin(end_tilt) * lost;
    const double round = turns ? std::sin(end_tilt) * std::sin(turn) : 0;
    const double sine = std::hypot(up, round);
    const double cosine = std::cos(end_tilt - arc.tilt_) - arc.sine_ * std::sin(end_tilt) * lost;
    if (!(sine > kAngleTolerance_rad))
        return error(cosine < 0 ? OrientationError::opposite : OrientationError::same);
    if (turns && std::min(std::abs(arc.sine_), std::abs(std::sin(end_tilt))) < kPoleSineTolerance)
        return error(OrientationError::at_pole);
    arc.heading_sine_ = round / sine;
    arc.heading_cosine_ = up / sine;
    arc.tilt_sign_ = arc.sine_ < 0 ? -1 : 1;
    arc.clairaut_ = arc.sine_ * arc.heading_sine_;
    arc.length_rad_ = std::atan2(sine, cosine);
    if (turns && std::abs(arc.clairaut_) < kPoleTolerance) return error(OrientationError::different_solution);
    const HeadAngles reached = arc.at(arc.length_rad_).angles;
    const HeadAngles missing{end[head.turn_joint] - reached.turn, end[head.tilt_joint] - reached.tilt};
    if (!(std::max(std::abs(missing.turn), std::abs(missing.tilt)) < kEndTolerance_rad))
        return error(OrientationError::different_solution);
    arc.rounding_drift_ = {missing.turn / arc.length_rad_, missing.tilt / arc.length_rad_};
    return arc;
}

OrientationArc::Direction OrientationArc::direction(double from_anchor_rad) const {
    const double s = std::sin(from_anchor_rad);
    const double c = std::cos(from_anchor_rad);
    const double across = c * sine_ + s * cosine_ * heading_cosine_;
    const double lateral = s * heading_sine_;
    return {across, lateral, tilt_sign_ * std::max(std::hypot(across, lateral), std::abs(clairaut_)),
            c * cosine_ - s * sine_ * heading_cosine_, -s * cosine_ - c * sine_ * heading_cosine_};
}

HeadAngles OrientationArc::angles(double from_anchor_rad, const Direction& direction) const {
    HeadAngles angles{anchor_.turn + rounding_drift_.turn * from_anchor_rad,
                      anchor_.tilt + rounding_drift_.tilt * from_anchor_rad};
    if (is_meridian()) {
        angles.tilt += heading_cosine_ * from_anchor_rad;
        return angles;
    }
    angles.turn += std::atan2(tilt_sign_ * direction.lateral, tilt_sign_ * direction.across);
    angles.tilt += std::atan2(direction.sine, direction.cosine) - std::atan2(sine_, cosine_);
    return angles;
}

HeadState OrientationArc::at(double angle_rad) const {
    const double from_anchor_rad = from_rad_ + angle_rad;
    const Direction current = direction(from_anchor_rad);
    HeadState state{angles(from_anchor_rad, current), {0, heading_cosine_}, {}};
    if (is_meridian()) return state;
    const double cube = current.sine * current.sine * current.sine;
    state.first = {clairaut_ / squared(current.sine), -current.cosine_slope / current.sine};
    state.second = {-2 * clairaut_ * current.cosine * state.first.tilt / cube,
                    squared(clairaut_) * current.cosine / cube};
    return state;
}

/// The cosine of the tilt is a sine wave of the path, which is shorter than half of its period. So it has one
/// extreme at most.
bool OrientationArc::passes_apex(const Direction& start, const Direction& end) const {
    return !is_meridian() && start.cosine_slope * end.cosine_slope < 0;
}

OrientationArc::SineRange OrientationArc::sine_range() const {
    const Direction start = direction(from_rad_);
    const Direction end = direction(from_rad_ + length_rad_);
    const auto [min, max] = std::minmax({std::abs(start.sine), std::abs(end.sine)});
    const bool passes_equator = start.cosine * end.cosine < 0;
    return {passes_apex(start, end) ? std::abs(clairaut_) : min, passes_equator ? 1 : std::min(max, 1.0)};
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
    const SineRange range = sine_range();
    const double l = std::abs(clairaut_);
    const double l2 = squared(l);
    const double x = squared(range.min);
    const double cos_heading = std::sqrt(std::max(0.0, 1 - l2 / squared(range.max)));
    const double cos_tilt = std::sqrt(std::max(0.0, 1 - x));
    const double steepest = 8 * l2 / (3 * (1 + l2) + std::sqrt(9 * squared(1 + l2) - 32 * l2));
    const double at = std::clamp(steepest, x, std::max(x, squared(range.max)));
    const double bound = std::max(0.0, (1 - at) * (at - l2));
    const double pole = (3 - 2 * x) / squared(x);
    HeadBounds bounds;
    bounds.first = {l / x, cos_heading};
    bounds.second = {2 * l * std::sqrt(bound) / squared(at), l2 * cos_tilt / (x * range.min)};
    bounds.third = {2 * l * std::max(squared(cos_heading) * pole, l2 * (1 - x) / (x * x * x)),
                    l2 * cos_heading * pole};
    return bounds;
}

Range OrientationArc::tilt_range() const {
    const Direction start = direction(from_rad_);
    const Direction end = direction(from_rad_ + length_rad_);
    const auto [min, max] =
        std::minmax({angles(from_rad_, start).tilt, angles(from_rad_ + length_rad_, end).tilt});
    Range range{min, max};
    if (!passes_apex(start, end)) return range;
    const double cosine_magnitude = std::sqrt(std::max(0.0, 1 - squared(clairaut_)));
    const double cosine = start.cosine_slope > 0 ? cosine_magnitude : -cosine_magnitude;
    const double apex =
        anchor_.tilt + std::atan2(tilt_sign_ * std::abs(clairaut_), cosine) - std::atan2(sine_, cosine_);
    return {std::min(range.min, apex), std::max(range.max, apex)};
}

OrientationArc OrientationArc::part(double from_rad, double to_rad) const {
    OrientationArc part = *this;
    part.from_rad_ += from_rad;
    part.length_rad_ = to_rad - from_rad;
    return part;
}

}  // namespace gsim::motion
