#include "motion/klipper/speeds.h"

#include <algorithm>

namespace gsim::motion::klipper {

namespace {

using Queue = std::deque<QueuedMove>;

/// Part of the entries of the two plans that is final.
struct FinalEntries {
    std::size_t full = 0;    ///< Those of the moves up to this one,
    std::size_t smooth = 0;  ///< and of this one also that it speeds up.
};

/// Further moves can only raise the entry speed from which braking is possible. So an entry limited by its
/// cap is final, and so are all entries before it.
FinalEntries run_backward_pass(Queue& queue) {
    FinalEntries known;
    double full = 0, smooth = 0;
    for (std::size_t i = queue.size(); i-- > 0;) {
        QueuedMove& move = queue[i];
        const double reach = full + move.full.change;
        const double smooth_reachable = smooth + move.smooth.change;
        if (known.full == 0 && move.full.entry_cap_squared <= reach) known.full = i;
        if (known.smooth == 0 && move.smooth.entry_cap_squared < smooth_reachable) known.smooth = i;
        full = move.full.entry_squared = std::min(move.full.entry_cap_squared, reach);
        smooth = move.smooth.entry_squared = std::min(move.smooth.entry_cap_squared, smooth_reachable);
    }
    return known;
}

/// Returns the highest squared speed of a plan between two squared speeds.
double peak_squared(const Plan& plan, double next_entry) {
    return (plan.entry_squared + next_entry + plan.change) / 2;
}

}  // namespace

std::size_t plan_speeds(Queue& queue, double last_cruise_squared) {
    const FinalEntries known = run_backward_pass(queue);
    std::size_t final_count = 0;
    double next_full = 0, next_smooth = 0, peak = 0;
    bool next_speeds_up = true;
    std::size_t deceleration_end =
        queue.size();  // end of the moves that follow the checked one and only slow down
    for (std::size_t i = queue.size(); i-- > 0;) {
        QueuedMove& move = queue[i];
        move.speeds_up = move.smooth.entry_squared < next_smooth + move.smooth.change;
        if (move.speeds_up) {
            const bool turns =
                move.smooth.entry_squared + move.smooth.change > next_smooth || !next_speeds_up;
            if (turns) {
                peak = peak_squared(move.smooth, next_smooth);
                if (final_count == 0 && i + 1 <= known.smooth)
                    final_count = std::min(deceleration_end, known.full);
            }
            move.cruise_speed_squared =
                std::min({peak_squared(move.full, next_full), move.max_speed_squared(), peak});
            deceleration_end = i;
        }
        next_speeds_up = move.speeds_up;
        next_full = move.full.entry_squared;
        next_smooth = move.smooth.entry_squared;
    }
    double top = last_cruise_squared;
    for (QueuedMove& move : queue) {
        if (!move.speeds_up) move.cruise_speed_squared = std::min(top, move.full.entry_squared);
        top = move.cruise_speed_squared;
    }
    return final_count;
}

}  // namespace gsim::motion::klipper
