#include "runtime/simulator/program/move_settings.h"

#include <utility>

namespace gsim::simulation {

void MoveSettings::set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    path_mode_ = {mode, tolerance_mm, merge_tolerance_mm};
    notifier_.notify([&](ProgramObserver& observer) { observer.path_mode(position_.axes(), path_mode_); });
}

void MoveSettings::exact_stop_once() {
    exact_stop_once_ = true;
    notifier_.notify([&](ProgramObserver& observer) { observer.exact_stop_once(position_.axes()); });
}

void MoveSettings::set_path_limits(const ProgrammedPathLimits& limits) {
    motion::PlannerSetup changed = path_limits_ ? *path_limits_ : setup_;
    const auto set = [](double& value, const std::optional<double>& to) { value = to.value_or(value); };
    set(changed.path.max_feed_mm_s, limits.speed_mm_s);
    set(changed.path.max_acceleration_mm_s2, limits.acceleration_mm_s2);
    set(changed.controller.klipper.square_corner_velocity_mm_s, limits.square_corner_velocity_mm_s);
    set(changed.controller.klipper.minimum_cruise_ratio, limits.minimum_cruise_ratio);
    path_limits_ = std::make_shared<const motion::PlannerSetup>(std::move(changed));
    notifier_.notify_unrecordable("the program changes limits of its path");
}

void MoveSettings::set_spindle_speed(double rev_min) {
    notifier_.notify([&](ProgramObserver& observer) { observer.spindle_speed(position_.axes(), rev_min); });
}

/// A move in step with the spindle by its position ignores the feed override.
void MoveSettings::apply_override_rules(const Feed& feed, MoveInfo& info) const {
    info.follows_spindle = feed.linear_mm_rev.has_value();
    const bool is_synchronized = info.kind == MoveKind::thread && info.follows_spindle;
    const bool ignores_feed_override =
        info.kind == MoveKind::probe && !machine_.controller.overrides.override_probe_feed;
    info.enabled_overrides = {.feed = !locks_.feed && !is_synchronized && !ignores_feed_override,
                              .rapid = !locks_.rapid,
                              .spindle = info.follows_spindle && !locks_.spindle};
}

void MoveSettings::apply(motion::MoveParameters& parameters) const {
    const PathModeSettings settings = exact_stop_once_ ? PathModeSettings{} : path_mode_;
    parameters.path_mode = settings.mode;
    parameters.tolerance_mm = settings.tolerance_mm;
    parameters.merge_tolerance_mm = settings.merge_tolerance_mm;
    if (path_limits_) parameters.machine = path_limits_;
}

}  // namespace gsim::simulation
