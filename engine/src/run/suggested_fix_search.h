#pragma once

#include <optional>

#include "engine/src/run/run_inputs.h"
#include "runtime/report/report.h"

namespace gsim::engine {

/// The inputs of a second run of a program, saved before the first one consumes them.
class SuggestedFixSearch {
  public:
    /// `found` and `cpu` must outlive this object.
    SuggestedFixSearch(const ResolvedRequest& found, const RunInputs& inputs, os::CpuLimit& cpu);

    /// If the run has violations and reached its end: runs the program again with the shifts of work offsets
    /// that these suggest. If that run exceeds no limit or zone, adds the shifts to the report as its
    /// suggested fix. Does nothing with a controller module.
    void search(simulation::Report& report) const;

  private:
    bool is_fixed_by(const std::vector<simulation::OffsetShift>& shifts) const;

    const ResolvedRequest& found_;
    os::CpuLimit& cpu_limit_;
    machine::Machine machine_;
    machine::MachineData data_;
    Language language_;
    script::Script program_;
    std::optional<script::Script> setup_;
    simulation::ProbeSurface probe_;
};

}  // namespace gsim::engine
