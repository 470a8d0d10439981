#include "runtime/simulator/machine_motion.h"

#include <utility>

#include "runtime/motion_sources/module_motion.h"
#include "runtime/motion_sources/observed_motion.h"
#include "runtime/motion_sources/planner_motion.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::simulation {

MachineMotion::MachineMotion(const machine::Machine& machine, std::optional<rrs::RcsModule> module,
                             double max_time_s)
    : machine_(machine),
      recorder_(machine, machine::home_position(machine)),
      zones_(machine, recorder_),
      setup_(make_planner_setup(machine)),
      path_deviation_monitor_(setup_),
      source_(make_source(std::move(module), max_time_s)) {
    recorder_.add_output(path_deviation_monitor_);
    path_sinks_.add(path_deviation_monitor_);
}

std::unique_ptr<MotionSource> MachineMotion::make_source(std::optional<rrs::RcsModule> module,
                                                         double max_time_s) {
    if (!module) return std::make_unique<PlannerMotion>(setup_, zones_, path_sinks_);
    return std::make_unique<ModuleMotion>(*std::move(module), setup_, max_time_s, zones_);
}

void MachineMotion::observe(MotionObserver& observer) {
    source_ = std::make_unique<ObservedMotion>(std::move(source_), observer);
    if (!overrides_.empty()) observer.on_unrecordable("overrides are changed");
}

bool MachineMotion::set_overrides(const motion::OverrideSchedule& overrides) {
    overrides_ = overrides.changes();
    std::vector<motion::OverrideChange> active_overrides = overrides_;
    for (motion::OverrideChange& change : active_overrides) {
        if (change.at_s > 0) change.at_s += machine_.controller.overrides.delay_s;
    }
    return source_->set_overrides(
        std::make_shared<const motion::OverrideSchedule>(std::move(active_overrides)));
}

bool MachineMotion::set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) {
    setup_.move_limits = std::move(limits);
    if (source_->set_move_limits(setup_.move_limits)) return true;
    setup_.move_limits = nullptr;
    return false;
}

}  // namespace gsim::simulation
