#include "runtime/motion/time_law.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion {

double TimeLaw::fastest_s(double length, double max_speed, double max_acceleration) {
    if (length <= 0) return 0;
    const double ramp_s = max_speed / max_acceleration;
    if (std::isfinite(max_speed) && max_speed * ramp_s <= length) return length / max_speed + ramp_s;
    return 2 * std::sqrt(length / max_acceleration);
}

TimeLaw TimeLaw::fastest(double length, double max_speed, double max_acceleration) {
    const double duration_s = fastest_s(length, max_speed, max_acceleration);
    const double top = std::sqrt(length * max_acceleration);  // of the triangle
    return {length, duration_s, duration_s > 0 ? std::min(top, max_speed) : 0, max_acceleration};
}

// The cruise speed v solves length = v duration - v^2 / acceleration; this form of the root has no
// cancellation. Where the root is nearly double (a triangle) rounding may lift v by the square root of an
// epsilon, but then the length depends on v only in the second order, so holding it to max_speed costs
// nothing.
TimeLaw TimeLaw::in_time(double length, double duration_s, double max_acceleration, double max_speed) {
    if (!(duration_s > 0)) return {length, 0, 0, max_acceleration};
    const double square = 1 - 4 * length / max_acceleration / (duration_s * duration_s);
    const double speed = 2 * length / (duration_s * (1 + std::sqrt(std::max(0.0, square))));
    return {length, duration_s, std::min(speed, max_speed), max_acceleration};
}

TimeLaw::TimeLaw(double length, double duration_s, double cruise_speed, double acceleration)
    : length_(length), duration_s_(duration_s), peak_speed_(cruise_speed) {
    double ramp_s = std::min(cruise_speed / acceleration, duration_s / 2);
    double ramp_acceleration = cruise_speed / ramp_s;
    if (!std::isfinite(ramp_acceleration)) ramp_s = ramp_acceleration = 0;  // the rectangle
    const double ramp_length = cruise_speed * ramp_s / 2;
    add_piece(ramp_s, 0, 0, ramp_acceleration);
    add_piece(duration_s - 2 * ramp_s, ramp_length, cruise_speed, 0);
    add_piece(ramp_s, length - ramp_length, cruise_speed, -ramp_acceleration);
}

LawState TimeLaw::at(double t_s) const {
    if (count_ == 0) return {length_, 0, 0};
    double t = t_s;
    std::size_t index = 0;
    const bool over = t_s >= duration_s_;
    while (index + 1 < count_ && (over || t > pieces_[index].duration_s)) t -= pieces_[index++].duration_s;
    const LawPiece& piece = pieces_[index];
    // Counted from the end, the last piece comes to rest exactly, however long the others are.
    if (index + 1 == count_) t = piece.duration_s - (duration_s_ - t_s);
    t = std::clamp(t, 0.0, piece.duration_s);
    const double s = piece.s0 + t * (piece.v0 + t * (piece.a0 / 2 + t * piece.jerk / 6));
    const double v = piece.v0 + t * (piece.a0 + t * piece.jerk / 2);
    // A path is never run backwards: a negative speed at the end is rounding.
    return {over ? length_ : std::clamp(s, 0.0, length_), std::max(v, 0.0), piece.a0 + t * piece.jerk};
}

}  // namespace gsim::motion
