#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "controller/module/rcs_module.h"
#include "motion/planner/planner_setup.h"

namespace gsim::rcs {

/// Description of a machine for a controller module.
class RcsMachine {
  public:
    /// `setup` must be valid.
    explicit RcsMachine(const motion::PlannerSetup& setup);
    RcsMachine(const RcsMachine&) = delete;
    RcsMachine& operator=(const RcsMachine&) = delete;

    /// Returns the description, which is valid as long as this object.
    const gsim_rcs_machine& get() const { return machine_; }

  private:
    struct Text {
        std::string key;
        std::string value;
    };
    void add_parameters(const rrs::ControllerRules& rules);

    std::vector<Text> texts_;
    std::vector<gsim_rcs_parameter> parameters_;
    gsim_rcs_machine machine_{};
};

/// Converts it back, for modules with our own planner.
Result<motion::PlannerSetup> setup_from_rcs_machine(const gsim_rcs_machine& machine);

}  // namespace gsim::rcs
