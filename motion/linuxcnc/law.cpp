#include "motion/linuxcnc/law.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gsim::motion::linuxcnc {

namespace {

double way(const LawPiece& piece, double t_s) {
    return t_s * (piece.v0 + t_s * (piece.a0 / 2 + t_s * piece.jerk / 6));
}

double speed(const LawPiece& piece, double t_s) {
    return std::max(0.0, piece.v0 + t_s * (piece.a0 + t_s * piece.jerk / 2));
}

// The jerk is not 0 here. Bisection works because distances only grow.
double time_by_halves(const LawPiece& piece, double length) {
    constexpr int kSteps = 60;
    double low = 0, high = piece.duration_s;
    for (int i = 0; i < kSteps; ++i) {
        const double middle = (low + high) / 2;
        (way(piece, middle) < length ? low : high) = middle;
    }
    return high;
}

// Returns the time that the part needs for a distance within it, in the form without cancellation.
double time_for(const LawPiece& piece, double length) {
    if (piece.jerk != 0) return time_by_halves(piece, length);
    const double square = std::max(0.0, piece.v0 * piece.v0 + 2 * piece.a0 * length);
    const double sum = piece.v0 + std::sqrt(square);
    return sum > 0 ? std::clamp(2 * length / sum, 0.0, piece.duration_s) : 0;
}

}  // namespace

void Law::add(double duration_s, double speed_before, double acceleration, double jerk) {
    if (!(duration_s > 0)) return;
    LawPiece& piece = pieces_[count_++];
    piece = {duration_s, length_, speed_before, acceleration, jerk};
    length_ += std::max(0.0, way(piece, duration_s));
    duration_s_ += duration_s;
    top_speed_ = std::max({top_speed_, speed_before, speed(piece, duration_s)});
}

double Law::end_speed() const {
    return count_ > 0 ? speed(pieces_[count_ - 1], pieces_[count_ - 1].duration_s) : 0;
}

double Law::end_acceleration() const {
    if (count_ == 0) return 0;
    const LawPiece& last = pieces_[count_ - 1];
    return last.a0 + last.duration_s * last.jerk;
}

double Law::at(double t_s) const {
    for (const LawPiece& piece : std::span(pieces_.data(), count_)) {
        if (t_s <= piece.duration_s) return piece.s0 + way(piece, std::max(t_s, 0.0));
        t_s -= piece.duration_s;
    }
    return length_;
}

double Law::time_at(double length) const {
    double before_s = 0;
    for (const LawPiece& piece : std::span(pieces_.data(), count_)) {
        const double end = piece.s0 + way(piece, piece.duration_s);
        if (length <= end) return before_s + time_for(piece, length - piece.s0);
        before_s += piece.duration_s;
    }
    return duration_s_;
}

double Law::speed_at(double t_s) const {
    for (const LawPiece& piece : std::span(pieces_.data(), count_)) {
        if (t_s <= piece.duration_s) return speed(piece, std::max(t_s, 0.0));
        t_s -= piece.duration_s;
    }
    return 0;
}

void Law::append(const Law& other) {
    for (const LawPiece& piece : std::span(other.pieces_.data(), other.count_))
        add(piece.duration_s, piece.v0, piece.a0, piece.jerk);
}

Law Law::part(double from_s, double to_s) const {
    Law part;
    double before_s = 0;
    for (const LawPiece& piece : std::span(pieces_.data(), count_)) {
        const double from = std::max(from_s - before_s, 0.0);
        const double to = std::min(to_s - before_s, piece.duration_s);
        part.add(to - from, speed(piece, from), piece.a0 + from * piece.jerk, piece.jerk);
        before_s += piece.duration_s;
    }
    return part;
}

Law Law::over(double length) const {
    const double scale = length / length_;
    Law law;
    for (const LawPiece& piece : std::span(pieces_.data(), count_))
        law.add(piece.duration_s, piece.v0 * scale, piece.a0 * scale, piece.jerk * scale);
    return law;
}

Law Law::sooner(double by_s) const {
    std::size_t last = count_ - 1;
    while (last > 0 && by_s > pieces_[last].duration_s / 2) by_s -= pieces_[last--].duration_s;
    Law law;
    for (const LawPiece& piece : std::span(pieces_.data(), last))
        law.add(piece.duration_s, piece.v0, piece.a0, piece.jerk);
    const LawPiece& stop = pieces_[last];
    const double stop_s = stop.duration_s - by_s;
    law.add(stop_s, stop.v0, stop.a0, -2 * (stop.v0 + stop.a0 * stop_s) / (stop_s * stop_s));
    return law.over(length_);
}

TimeLaw Law::scaled(double scale) const {
    std::array<LawPiece, TimeLaw::kMaxPieces> scaled;
    for (std::size_t i = 0; i < count_; ++i) {
        const LawPiece& piece = pieces_[i];
        scaled[i] = {piece.duration_s, piece.s0 * scale, piece.v0 * scale, piece.a0 * scale,
                     piece.jerk * scale};
    }
    return TimeLaw::of_pieces({scaled.data(), count_});
}

}  // namespace gsim::motion::linuxcnc
