#include "runtime/script/processes/known_motion.h"

#include <algorithm>
#include <limits>

namespace gsim::script {

using process::ProcessId;

void KnownMotion::update() const {
    update_conveyors();
    if (multi_robot_monitor_ == nullptr) return;
    double known_s = std::numeric_limits<double>::infinity();
    for (ProcessId id = 0; id < table_.size(); ++id)
        known_s = std::min(known_s, table_.schedule().next_action_s(id));
    multi_robot_monitor_->set_known_until(known_s);
}

/// A process changes conveyors only at its own time, with its own robot at standstill.
void KnownMotion::update_conveyors() const {
    for (RobotController* controller : robots_.controllers()) {
        if (!controller->simulator().cell().has_conveyors()) continue;
        double known_s = std::numeric_limits<double>::infinity();
        for (ProcessId id = 0; id < table_.size(); ++id) {
            if (table_.lua_process(id).controller != controller)
                known_s = std::min(known_s, table_.schedule().next_action_s(id));
        }
        controller->simulator().cell().monitor()->set_known_until(known_s);
    }
}

void KnownMotion::on_zone_holder(std::size_t zone, double time_s,
                                 const std::optional<ProcessId>& holder) const {
    if (multi_robot_monitor_ == nullptr) return;
    if (!holder) return multi_robot_monitor_->assign_zone(zone, time_s, std::nullopt);
    multi_robot_monitor_->assign_zone(
        zone, time_s,
        simulation::MultiRobotMonitor::ZoneHolder{*holder, table_.schedule().process(*holder).name});
}

void KnownMotion::on_robot_owner(const RobotController& controller) const {
    if (multi_robot_monitor_ == nullptr) return;
    const std::vector<RobotController*>& all = robots_.controllers();
    const auto found = std::find(all.begin(), all.end(), &controller);
    multi_robot_monitor_->assign_robot(static_cast<std::size_t>(found - all.begin()), table_.running().time_s,
                                       table_.running_id());
}

}  // namespace gsim::script
