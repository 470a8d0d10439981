#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/recorded_run.h"
#include "runtime/machine/machine.h"
#include "runtime/simulation/motion_log.h"

namespace gsim::calibrate {

/// Tells how long programs take on machines that differ in figures of their motion. Each program is run once;
/// then its moves are planned anew for each machine.
class Predictor {
  public:
    /// Runs the programs on `machine`, with what they call from the folders beside them. Empty `dialect`: as
    /// the machine says. The error names the file that cannot be read.
    static tl::expected<Predictor, std::string> of(std::span<const RecordedRun> runs,
                                                   const std::string& dialect,
                                                   const machine::Machine& machine);

    /// The same of some of its runs, by their places.
    Predictor part(std::span<const std::size_t> places) const;

    std::size_t size() const { return programs_.size(); }
    /// The time of each run, s, from its first move or dwell on; the error says why it does not come to its
    /// end. On as many threads as the computer has cores.
    std::vector<tl::expected<double, std::string>> times_s(const machine::Machine& machine) const;

  private:
    /// What a program asks for.
    struct Program {
        std::string file;
        simulation::MotionLog log;
        std::string refused;  ///< Why it does not come to its end; empty: it does.
    };

    void run(Program& program, const std::string& machine) const;
    tl::expected<double, std::string> run_time_s(const std::string& program, const std::string& machine,
                                                 simulation::MotionLog* log) const;

    std::vector<std::shared_ptr<const Program>> programs_;
    std::string dialect_;
};

}  // namespace gsim::calibrate
