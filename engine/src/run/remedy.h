#pragma once

#include <optional>

#include "engine/src/run/run_inputs.h"
#include "runtime/report/report.h"

namespace gsim::engine {

/// The inputs of a second run of a program, saved before the first one consumes them.
class Remedy {
  public:
    /// `found` and `cpu` must outlive this object.
    Remedy(const FoundRequest& found, const RunInputs& inputs, os::CpuLimit& cpu);

    /// If the run has violations and reached its end: runs the program again with the shifts of work offsets
    /// that these suggest. If that run exceeds no limit or zone, adds the shifts to the report as its
    /// suggested fix. Does nothing with a controller module.
    void look_for(simulation::Report& report) const;

  private:
    bool mends(const std::vector<simulation::OffsetShift>& shifts) const;

    const FoundRequest& found_;
    os::CpuLimit& cpu_;
    machine::Machine machine_;
    machine::MachineData data_;
    Language language_;
    script::Script program_;
    std::optional<script::Script> setup_;
    simulation::ProbeFeels probe_;
};

}  // namespace gsim::engine
