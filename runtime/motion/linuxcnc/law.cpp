#include "runtime/motion/linuxcnc/law.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gsim::motion::linuxcnc {

namespace {

double way(const LawPiece& piece, double t_s) {
    return t_s * (piece.v0 + t_s * piece.a0 / 2);
}

double speed(const LawPiece& piece, double t_s) {
    return std::max(0.0, piece.v0 + t_s * piece.a0);
}

// The time that the piece needs for a way within it, in the form that does not cancel.
double time_for(const LawPiece& piece, double length) {
    const double square = std::max(0.0, piece.v0 * piece.v0 + 2 * piece.a0 * length);
    const double sum = piece.v0 + std::sqrt(square);
    return sum > 0 ? std::clamp(2 * length / sum, 0.0, piece.duration_s) : 0;
}

}  // namespace

void Law::add(double duration_s, double speed_before, double acceleration) {
    if (!(duration_s > 0)) return;
    LawPiece& piece = pieces_[count_++];
    piece = {duration_s, length_, speed_before, acceleration, 0};
    length_ += std::max(0.0, way(piece, duration_s));
    duration_s_ += duration_s;
    top_speed_ = std::max({top_speed_, speed_before, speed(piece, duration_s)});
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

Law Law::behind_rest(double rest_s) const {
    Law law;
    law.rest(rest_s);
    for (const LawPiece& piece : std::span(pieces_.data(), count_))
        law.add(piece.duration_s, piece.v0, piece.a0);
    return law;
}

Law Law::part(double from_s, double to_s) const {
    Law part;
    double before_s = 0;
    for (const LawPiece& piece : std::span(pieces_.data(), count_)) {
        const double from = std::max(from_s - before_s, 0.0);
        const double to = std::min(to_s - before_s, piece.duration_s);
        part.add(to - from, speed(piece, from), piece.a0);
        before_s += piece.duration_s;
    }
    return part;
}

TimeLaw Law::scaled(double scale) const {
    std::array<LawPiece, TimeLaw::kMaxPieces> scaled;
    for (std::size_t i = 0; i < count_; ++i) {
        const LawPiece& piece = pieces_[i];
        scaled[i] = {piece.duration_s, piece.s0 * scale, piece.v0 * scale, piece.a0 * scale, 0};
    }
    return TimeLaw::of_pieces({scaled.data(), count_});
}

}  // namespace gsim::motion::linuxcnc
