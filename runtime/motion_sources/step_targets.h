#pragma once

#include <deque>

#include "controller/services/shell.h"

namespace gsim::simulation {

/// Targets to which the steps of a module belong. A module that was built before GetTargetOfLastStep existed
/// responds that it has no such service; then targets are counted as it reaches them.
class StepTargets {
  public:
    void add(rrs::TargetId id) { pending_.push_back(id); }
    void clear() { pending_.clear(); }
    void on_target_reached() {
        if (!pending_.empty()) pending_.pop_front();
    }
    /// Returns true unless the module has turned out to have no GetTargetOfLastStep.
    bool is_reported() const { return is_reported_; }
    /// Returns the target of the module's last step, or -1 if it is unknown.
    rrs::TargetId of_last_step(rrs::Shell& module) {
        rrs::TargetId id = -1;
        if (is_reported_ && module.GetTargetOfLastStep(id) == rrs::Status::RRS_SUCCESS) {
            pending_.clear();
            return id;
        }
        is_reported_ = false;
        return pending_.empty() ? -1 : pending_.front();
    }

  private:
    std::deque<rrs::TargetId> pending_;  ///< Targets not reached yet, if the module does not report them.
    bool is_reported_ = true;
};

}  // namespace gsim::simulation
