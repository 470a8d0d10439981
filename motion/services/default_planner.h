#pragma once

#include <utility>

#include "motion/services/planner_shell.h"

namespace gsim::motion {

/// A planner with its services: our own planner as a controller by itself.
class DefaultPlanner final : public Planner, public PlannerShell {
  public:
    /// As Planner's.
    explicit DefaultPlanner(PlannerSetup setup, SegmentSink* sink = nullptr)
        : Planner(std::move(setup), sink), PlannerShell(static_cast<Planner&>(*this)) {}
};

}  // namespace gsim::motion
