#include "motion/linuxcnc/look_ahead.h"

#include <algorithm>
#include <cmath>

#include "motion/linuxcnc/profile.h"
#include "motion/profile/ramp.h"

namespace gsim::motion::linuxcnc {

namespace {

double square(double value) {
    return value * value;
}

// Returns the squared speed that sub-segment `index` and the next one can have at their junction.
double cap(const PieceQueue& queue, std::size_t index) {
    const Piece& piece = queue[index].piece;
    double speed = std::min(piece.max_speed, queue[index + 1].piece.max_speed);
    if (piece.kink_speed >= 0) speed = std::min(speed, piece.kink_speed);
    return square(speed);
}

// Returns the rise of the squared speed over the sub-segment at full acceleration.
double rise(const Piece& piece) {
    return 2 * acceleration(piece) * piece.length;
}

// Returns the squared speed at the start of the last sub-segment in view.
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

// The speed of each junction, computed backward, is the lesser of its cap and what the sub-segment after it
// can brake. This is, for the first junction, the minimum of all caps, each raised by the rises in between.
// So the search can stop if the rises alone exceed the minimum so far.
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

namespace {

double top_alone(const Piece& piece) {
    return std::isfinite(piece.jerk) ? peak_speed(piece.length, acceleration(piece), piece.jerk) : kUnlimited;
}

// Returns the speed at the start of a sub-segment from which it can slow down to its end.
double start_speed(const Piece& piece, double end_speed) {
    const double straight = std::sqrt(square(end_speed) + rise(piece));
    if (std::isinf(piece.jerk)) return straight;
    const double braked = ramp_end_speed(piece.length, end_speed, acceleration(piece), piece.jerk);
    return std::min(straight, std::max(end_speed, std::min(braked, top_alone(piece))));
}

void lower(JunctionSpeed& junction, double speed, LimitKind limit) {
    if (speed < junction.speed) junction = {speed, limit};
}

// Returns the speed at the start of the last sub-segment in view.
JunctionSpeed last_speed(const Piece& last, bool stops, bool is_last) {
    if (stops) return {start_speed(last, 0), LimitKind::stop};
    JunctionSpeed junction{std::min(target_speed(last), std::sqrt(rise(last) / 2)),
                           is_last ? LimitKind::stop : LimitKind::look_ahead};
    junction.speed = std::min(junction.speed, top_alone(last));
    return junction;
}

}  // namespace

JunctionSpeed curved_junction_speed(const PieceQueue& queue, std::size_t index, const Horizon& horizon) {
    const std::size_t deepest = index + horizon.depth;
    const std::size_t last = std::min(horizon.run_end.value_or(deepest), deepest);
    const bool ends = horizon.run_end == last;
    const bool stops = ends && !horizon.run_end_is_last;
    JunctionSpeed junction = last_speed(queue[last].piece, stops, ends);
    for (std::size_t next = last; next > index; --next) {
        const Piece& before = queue[next - 1].piece;
        if (next < last) junction.speed = start_speed(queue[next].piece, junction.speed);
        lower(junction, std::sqrt(cap(queue, next - 1)), LimitKind::corner);
        if (next < last || stops) lower(junction, top_alone(before), LimitKind::jerk);
    }
    return junction;
}

}  // namespace gsim::motion::linuxcnc
