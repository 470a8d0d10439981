#include "tests/accuracy/estimators.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/profile/time_law.h"

namespace gsim::accuracy {

namespace {

constexpr double kCamoticsRapid_mm_s = 10'000.0 / 60;
constexpr std::size_t kLookAhead = 32;
constexpr double kCentripetalShare = 0.866;

double speed_of(const ProgrammedMove& move) {
    return move.rapid ? move.speed_limit : std::min(move.feed_s, move.speed_limit);
}

/// The same with what an arc allows.
double max_move_speed(const ProgrammedMove& move) {
    if (move.radius_mm <= 0) return speed_of(move);
    return std::min(speed_of(move), std::sqrt(kCentripetalShare * move.acceleration * move.radius_mm));
}

double joint_speed(const ProgrammedMove& before, const ProgrammedMove& behind) {
    return std::min(max_move_speed(before), max_move_speed(behind)) *
           std::max(0.0, before.leaves.dot(behind.enters));
}

/// Returns the speed at which the move after `at` may begin, as far as the look-ahead sees.
double exit_speed(std::span<const ProgrammedMove> moves, std::size_t at) {
    double speed = 0;
    for (std::size_t i = std::min(at + kLookAhead, moves.size()); i-- > at + 1;) {
        const double braked = std::sqrt(speed * speed + 2 * moves[i].acceleration * moves[i].length);
        speed = std::min(braked, joint_speed(moves[i - 1], moves[i]));
    }
    return speed;
}

/// Returns the time of moves between two dwells.
double planned_s(std::span<const ProgrammedMove> moves) {
    double time_s = 0;
    double entry = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const ProgrammedMove& move = moves[i];
        const double reached = std::sqrt(entry * entry + 2 * move.acceleration * move.length);
        const double exit = std::min(exit_speed(moves, i), reached);
        const motion::LawLimits limits{std::max(max_move_speed(move), std::max(entry, exit)),
                                       move.acceleration, move.acceleration};
        time_s += motion::TimeLaw::between(move.length, entry, exit, limits).duration_s();
        entry = exit;
    }
    return time_s;
}

}  // namespace

double length_over_feed_s(std::span<const ProgrammedMove> moves) {
    double time_s = 0;
    for (const ProgrammedMove& move : moves)
        time_s += move.wait_s + (move.length > 0 ? move.length / speed_of(move) : 0);
    return time_s;
}

double camotics_s(std::span<const ProgrammedMove> moves) {
    double time_s = 0;
    for (const ProgrammedMove& move : moves) {
        const double speed = move.rapid ? kCamoticsRapid_mm_s : move.feed_s;
        time_s += move.wait_s + (move.all_axes > 0 ? move.all_axes / speed : 0);
    }
    return time_s;
}

double linuxcnc_parse_s(std::span<const ProgrammedMove> moves) {
    double time_s = 0;
    std::vector<ProgrammedMove> pending_moves;
    for (const ProgrammedMove& move : moves) {
        if (move.wait_s > 0) {
            time_s += planned_s(pending_moves) + move.wait_s;
            pending_moves.clear();
        } else if (move.length > 0) {
            pending_moves.push_back(move);
        }
    }
    return time_s + planned_s(pending_moves);
}

}  // namespace gsim::accuracy
