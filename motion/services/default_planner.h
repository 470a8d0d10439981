#pragma once

#include <utility>

#include "motion/services/planner_shell.h"

namespace gsim::motion {

/// Planner with its services: our own planner as a controller by itself.
class DefaultPlanner final : public Planner, public PlannerShell {
  public:
    /// Makes a planner as Planner's constructor does.
    explicit DefaultPlanner(PlannerSetup setup, SegmentSink* sink = nullptr)
        : Planner(std::move(setup), sink), PlannerShell(static_cast<Planner&>(*this)) {}
};

}  // namespace gsim::motion
