#pragma once

#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/recorded_run.h"
#include "runtime/machine/machine.h"

namespace gsim::calibrate {

/// Runs programs on machines that differ in figures, and tells how long they take.
class Predictor {
  public:
    /// Reads the programs, and what they call from the folders beside them. Empty `dialect`: as the machine
    /// says. The error names the file that cannot be read.
    static tl::expected<Predictor, std::string> of(std::span<const RecordedRun> runs, std::string dialect);

    /// The time of each run, s, from its first move or dwell on; the error says why it does not come to its
    /// end. On as many threads as the computer has cores.
    std::vector<tl::expected<double, std::string>> times_s(const machine::Machine& machine) const;

  private:
    tl::expected<double, std::string> time_s(const std::string& program, const std::string& machine) const;

    std::vector<std::string> programs_;
    std::string dialect_;
};

}  // namespace gsim::calibrate
