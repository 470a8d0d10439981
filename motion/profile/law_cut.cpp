#include "motion/profile/law_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/profile/ramp.h"

namespace gsim::motion {

namespace {

constexpr double kLengthRounding = 1e-12;
constexpr double kNoAcceleration = 1e-9;  // relative to the ramp's

/// Collector of law parts, one after the other.
class Pieces {
  public:
    void add(double duration_s, double v0, double a0, double jerk) {
        if (!(duration_s > 0) || count_ == pieces_.size()) return;
        pieces_[count_++] = {duration_s, s_, v0, a0, jerk};
        s_ += duration_s * (v0 + duration_s * (a0 / 2 + duration_s * jerk / 6));
    }
    void add(const TimeLaw& law) {
        for (const LawPiece& piece : law.pieces()) add(piece.duration_s, piece.v0, piece.a0, piece.jerk);
    }
    double length() const { return s_; }
    TimeLaw law() const { return TimeLaw::of_pieces(std::span(pieces_.data(), count_)); }

  private:
    std::array<LawPiece, TimeLaw::kMaxPieces> pieces_;
    std::size_t count_ = 0;
    double s_ = 0;
};

/// Returns the remainder of a part after its first `t_s`.
LawPiece rest_of_piece(const LawPiece& piece, double t_s) {
    return {piece.duration_s - t_s, 0, piece.v0 + t_s * (piece.a0 + t_s * piece.jerk / 2),
            piece.a0 + t_s * piece.jerk, piece.jerk};
}

double end_speed(const LawPiece& piece) {
    return std::max(rest_of_piece(piece, piece.duration_s).v0, 0.0);
}

/// Adds the parts of the active ramp from `t_s` on, until the acceleration is 0; returns the speed there.
double finish_ramp(const TimeLaw& law, double t_s, Pieces& pieces) {
    double speed = law.at(t_s).v;
    for (const LawPiece& piece : law.pieces()) {
        if (t_s >= piece.duration_s) {
            t_s -= piece.duration_s;
            continue;
        }
        const LawPiece rest = rest_of_piece(piece, t_s);
        t_s = 0;
        const bool brakes = rest.a0 + rest.jerk * rest.duration_s / 2 < 0;
        if (!brakes) break;
        pieces.add(rest.duration_s, rest.v0, rest.a0, rest.jerk);
        speed = end_speed(rest);
        const double last = rest.a0 + rest.jerk * rest.duration_s;
        if (last >= kNoAcceleration * std::min(rest.a0, last)) break;
    }
    return speed;
}

/// Takes the acceleration at an instant to 0 and returns the remaining speed.
double end_acceleration(const TimeLaw& law, double t_s, const LawLimits& limits, Pieces& pieces) {
    const LawState state = law.at(t_s);
    if (std::isinf(limits.jerk)) return state.v;
    if (state.a < 0) return finish_ramp(law, t_s, pieces);
    const double duration_s = state.a / limits.jerk;
    pieces.add(duration_s, state.v, state.a, -limits.jerk);
    return state.v + state.a * duration_s / 2;
}

/// Returns the lowest speed at the end of `length`, if it is too short for a stop. Lengths of ramps down grow
/// with the change up to two thirds of the speed, or, if they hold their acceleration, up to acceleration^2 /
/// (2 jerk) above standstill.
double lowest_end_speed(double length, double speed, const LawLimits& limits) {
    double low = std::min(speed / 3, limits.deceleration * limits.deceleration / (2 * limits.jerk));
    double high = speed;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (ramp_length(speed, middle, limits.deceleration, limits.jerk) > length ? low : high) = middle;
    }
    return high;
}

}  // namespace

TimeLaw law_until(const TimeLaw& law, double t_s) {
    Pieces pieces;
    for (const LawPiece& piece : law.pieces()) {
        const double duration_s = std::min(piece.duration_s, t_s);
        pieces.add(duration_s, piece.v0, piece.a0, piece.jerk);
        t_s -= duration_s;
    }
    return pieces.law();
}

TimeLaw law_from(const TimeLaw& law, double t_s) {
    Pieces pieces;
    for (const LawPiece& piece : law.pieces()) {
        const double done_s = std::min(piece.duration_s, t_s);
        const LawPiece rest = rest_of_piece(piece, done_s);
        pieces.add(rest.duration_s, rest.v0, rest.a0, rest.jerk);
        t_s -= done_s;
    }
    return pieces.law();
}

TimeLaw law_and_rest(const TimeLaw& law, double duration_s) {
    Pieces pieces;
    pieces.add(law);
    pieces.add(duration_s - law.duration_s(), 0, 0, 0);
    return pieces.law();
}

TimeLaw braking_law(double length, double start_speed, double end_speed, const LawLimits& limits) {
    if (!(length > 0) || !(start_speed > 0)) return {};
    LawLimits brakes = limits;
    brakes.max_speed = start_speed;
    const double stop = ramp_length(start_speed, 0, limits.deceleration, limits.jerk);
    if (stop <= length * (1 + kLengthRounding))
        return stop > 0 ? TimeLaw::between(std::min(stop, length), start_speed, 0, brakes) : TimeLaw();
    const double lowest = std::min(lowest_end_speed(length, start_speed, limits), end_speed);
    return TimeLaw::between(length, start_speed, lowest, brakes);
}

TimeLaw braking_law(const TimeLaw& law, double t_s, const LawLimits& limits) {
    Pieces pieces;
    const double left = law.length() - law.at(t_s).s;
    const double speed = end_acceleration(law, t_s, limits, pieces);
    const double rest = left - pieces.length();
    if (rest > kLengthRounding * law.length()) pieces.add(braking_law(rest, speed, law.end_speed(), limits));
    return pieces.law();
}

}  // namespace gsim::motion
