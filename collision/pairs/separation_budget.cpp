#include "collision/pairs/separation_budget.h"

#include <limits>
#include <utility>

namespace gsim::cell {

namespace {

// Rotation in one motion above which a check is needed.
constexpr double kMaxRotation_rad = 0.5;

}  // namespace

// Adds up all slides, and each angle times the point's distance from that axis: no point moves farther. That
// distance grows by at most the travel of the point, so travel = slides + sum of angle (reach + travel).
double ReachBound::travel_mm(const JointTravel& travel) const {
    double slides_mm = kSkewedArcFactor * travel.arc_mm;
    double turn_rad = 0;
    double rotation_travel_mm = 0;
    for (std::size_t joint = 0; joint < travel.distance.size(); ++joint) {
        if (reach_mm_[joint] > 0) {
            turn_rad += travel.distance[joint];
            rotation_travel_mm += travel.distance[joint] * (reach_mm_[joint] + travel_since_measured_mm_);
        } else {
            slides_mm += travel.distance[joint];
        }
    }
    if (!(turn_rad < kMaxRotation_rad)) return std::numeric_limits<double>::infinity();
    return (slides_mm + rotation_travel_mm) / (1 - turn_rad);
}

void SeparationBudget::set(double budget_mm, const JointReach& reach_mm, double since_mm) {
    budget_mm_ = budget_mm;
    bound_.measure(reach_mm, since_mm);
}

bool SeparationBudget::spend(const JointTravel& travel) {
    if (!(budget_mm_ > 0)) return false;
    const double travel_mm = bound_.travel_mm(travel);
    if (!(travel_mm < budget_mm_)) return false;
    budget_mm_ -= travel_mm;
    travelled_mm_ += travel_mm;
    bound_.advance(travel_mm);
    return true;
}

double SeparationBudget::release_travelled_mm() {
    return std::exchange(travelled_mm_, 0);
}

}  // namespace gsim::cell
