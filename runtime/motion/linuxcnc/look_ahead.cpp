#include "runtime/motion/linuxcnc/look_ahead.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

namespace {

double square(double value) {
    return value * value;
}

// The square of the speed that piece `index` and the next one can have where they meet.
double cap(const PieceQueue& queue, std::size_t index) {
    const Piece& piece = queue[index].piece;
    double speed = std::min(piece.max_speed, queue[index + 1].piece.max_speed);
    if (piece.kink_speed >= 0) speed = std::min(speed, piece.kink_speed);
    return square(speed);
}

// The rise of the square of the speed over the piece at full acceleration.
double rise(const Piece& piece) {
    return 2 * acceleration(piece) * piece.length;
}

// The square of the speed at the start of the last piece that is seen.
double cautious(const Piece& last) {
    return std::min(square(target_speed(last)), rise(last) / 2);
}

class Lowest {
  public:
    explicit Lowest(double square) : square_(square) {}
    void lower(double other, LimitKind limit) {
        if (other >= square_) return;
        square_ = other;
        limit_ = limit;
    }
    double value() const { return square_; }
    JunctionSpeed speed() const { return {std::sqrt(square_), limit_}; }

  private:
    double square_;
    LimitKind limit_ = LimitKind::corner;
};

}  // namespace

// Backwards, each junction's speed is the lesser of its cap and what the piece behind it can brake. Seen from
// the first junction that is the least of all caps, each raised by the rises in between; so the look can
// stop where the rises alone are more than the least so far.
JunctionSpeed junction_speed(const PieceQueue& queue, std::size_t index, const Horizon& horizon) {
    Lowest lowest(cap(queue, index));
    double rises = 0;
    for (std::size_t next = index + 1; rises < lowest.value(); ++next) {
        const Piece& piece = queue[next].piece;
        const bool ends = horizon.run_end == next;
        if (ends && !horizon.run_end_is_last) {
            lowest.lower(rises + rise(piece), LimitKind::stop);
            break;
        }
        if (ends || next == index + horizon.depth) {
            lowest.lower(rises + cautious(piece), ends ? LimitKind::stop : LimitKind::look_ahead);
            break;
        }
        rises += rise(piece);
        lowest.lower(rises + cap(queue, next), LimitKind::corner);
    }
    return lowest.speed();
}

}  // namespace gsim::motion::linuxcnc
