#include "motion/services/path_mode_services.h"

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

PlanResult PathModeServices::select_flyby_mode(bool on) {
    if (on && !can_pass_targets_)
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "The default planner stops at each target; it has no fly-by.");
    selections_.move_parameters.path_mode = on ? rrs::PathMode::continuous : rrs::PathMode::exact_stop;
    return {};
}

PlanResult PathModeServices::set_path_mode(rrs::PathMode mode, double tolerance_mm,
                                           double merge_tolerance_mm) {
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 2) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid path mode {}; 0 is exact stop, 1 exact path, 2 continuous.", number));
    }
    if (!(tolerance_mm >= 0 && tolerance_mm < kUnlimited && merge_tolerance_mm >= 0 &&
          merge_tolerance_mm < kUnlimited)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The tolerances of a path must be 0 or greater, not {} and {}.",
                                           tolerance_mm, merge_tolerance_mm));
    }
    selections_.move_parameters.path_mode = mode;
    selections_.move_parameters.tolerance_mm = tolerance_mm;
    selections_.move_parameters.merge_tolerance_mm = merge_tolerance_mm;
    return {};
}

PlanResult PathModeServices::select_dominant_interpolation(rrs::Dominance dominance) {
    const int number = static_cast<int>(dominance);
    if (number < 0 || number > 2) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid dominance {}; 0 is automatic, 1 position, 2 orientation.", number));
    }
    selections_.move_parameters.dominance = dominance;
    return {};
}

}  // namespace gsim::motion
