#pragma once

#include <optional>

#include "engine/src/run/run_inputs.h"
#include "runtime/report/report.h"

namespace gsim::engine {

/// What a second run of a program needs, kept before the first one uses its inputs up.
class Remedy {
  public:
    /// `found` and `cpu` must outlive this.
    Remedy(const FoundRequest& found, const RunInputs& inputs, os::CpuLimit& cpu);

    /// Where the run has violations and came to its end: runs the program again with the shifts of work
    /// offsets that these suggest, and puts them into the report as its remedy where nothing is past a limit
    /// or a zone then. With a controller module it does nothing.
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
