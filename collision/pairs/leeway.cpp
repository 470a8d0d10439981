#include "collision/pairs/leeway.h"

#include <limits>
#include <utility>

namespace gsim::cell {

namespace {

// Rotation in one motion above which a check is needed.
constexpr double kMostTurn_rad = 0.5;

}  // namespace

// Adds up all slides, and each angle times the point's distance from that axis: no point moves farther. That
// distance grows by at most the travel of the point, so travel = slides + sum of angle (reach + travel).
double ReachBound::way_mm(const JointTravel& travel) const {
    double slides_mm = kSkewedArc * travel.arc_mm;
    double turn_rad = 0;
    double turned_mm = 0;
    for (std::size_t joint = 0; joint < travel.way.size(); ++joint) {
        if (reach_mm_[joint] > 0) {
            turn_rad += travel.way[joint];
            turned_mm += travel.way[joint] * (reach_mm_[joint] + since_mm_);
        } else {
            slides_mm += travel.way[joint];
        }
    }
    if (!(turn_rad < kMostTurn_rad)) return std::numeric_limits<double>::infinity();
    return (slides_mm + turned_mm) / (1 - turn_rad);
}

void Leeway::set(double slack_mm, const JointReach& reach_mm, double since_mm) {
    slack_mm_ = slack_mm;
    bound_.measure(reach_mm, since_mm);
}

bool Leeway::take(const JointTravel& travel) {
    if (!(slack_mm_ > 0)) return false;
    const double way_mm = bound_.way_mm(travel);
    if (!(way_mm < slack_mm_)) return false;
    slack_mm_ -= way_mm;
    gone_mm_ += way_mm;
    bound_.go_on(way_mm);
    return true;
}

double Leeway::release_gone_mm() {
    return std::exchange(gone_mm_, 0);
}

}  // namespace gsim::cell
