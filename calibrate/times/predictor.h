#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/times/recorded_run.h"
#include "calibrate/times/timed_interval.h"
#include "machine/model/machine.h"
#include "runtime/motion_sources/motion_log.h"

namespace gsim::calibrate {

/// Settings for reading programs, as in gsim-run.
struct ReadingOptions {
    std::string dialect = {};       ///< Empty: as the machine says.
    std::string machine_data = {};  ///< File of tools and offsets; empty: none.
};

/// Predictor of the times of programs on machines that differ in motion parameters. Each program is run once;
/// then its moves are replanned for each machine.
class Predictor {
  public:
    /// Runs the programs on `machine`, with called programs from their folders. The error names the file that
    /// cannot be read.
    static Result<Predictor> of(std::span<const RecordedRun> runs, const ReadingOptions& reading_options,
                                const machine::Machine& machine);

    /// Returns the same for some of its runs, by their indices.
    Predictor part(std::span<const std::size_t> indices) const;

    /// Returns the number of a run's requests to its controller.
    std::size_t request_count(std::size_t index) const { return programs_[index]->log.requests().size(); }
    /// Returns keys of [times] in the machine file for which these programs have words between their moves.
    std::vector<std::string> words() const;
    /// Returns the time of each run, s, from its first move or dwell to its last, without times of leading
    /// and trailing words; the error says why it does not reach its end. Uses as many threads as the computer
    /// has cores.
    std::vector<Result<double>> times_s(const machine::Machine& machine) const;

    /// Returns the data of the runs, in their order. For a run that cannot be replanned it is the total time.
    std::vector<TimedInterval> data() const;
    /// Returns the times of such data, s; the error names the program that does not reach its end.
    Result<std::vector<double>> times_s(std::span<const TimedInterval> data,
                                        const machine::Machine& machine) const;

  private:
    /// Requests of a program.
    struct Program {
        std::string file;
        simulation::MotionLog log;
        std::string error_text;           ///< Reason why it does not reach its end; empty: it does.
        std::vector<TimedInterval> data;  ///< Their run is set by data().
    };

    using Moves = std::vector<simulation::ReplayedMove>;

    void run(Program& program, const std::string& machine) const;
    Result<double> run_time_s(const std::string& program, const std::string& machine,
                              simulation::MotionLog* log) const;
    /// Returns one move with the total time for a run that cannot be replanned.
    std::vector<Result<Moves>> moves(const machine::Machine& machine) const;

    std::vector<std::shared_ptr<const Program>> programs_;
    ReadingOptions reading_options_;
};

}  // namespace gsim::calibrate
