#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/datum.h"
#include "calibrate/times/recorded_run.h"
#include "machine/model/machine.h"
#include "runtime/motion_sources/motion_log.h"

namespace gsim::calibrate {

/// How programs are to be read, as for gsim-run.
struct Reading {
    std::string dialect = {};       ///< Empty: as the machine says.
    std::string machine_data = {};  ///< File of tools and offsets; empty: none.
};

/// Tells how long programs take on machines that differ in figures of their motion. Each program is run once;
/// then its moves are planned anew for each machine.
class Predictor {
  public:
    /// Runs the programs on `machine`, with what they call from the folders beside them. The error names the
    /// file that cannot be read.
    static tl::expected<Predictor, std::string> of(std::span<const RecordedRun> runs, const Reading& reading,
                                                   const machine::Machine& machine);

    /// The same of some of its runs, by their places.
    Predictor part(std::span<const std::size_t> places) const;

    /// What a run asks of its controller, in number.
    std::size_t moves_of(std::size_t place) const { return programs_[place]->log.asks().size(); }
    /// Keys of [times] in the machine file that these programs have words for between their moves.
    std::vector<std::string> words() const;
    /// The time of each run, s, from its first move or dwell to its last, whatever words take before
    /// and behind; the error says why it does not come to its
    /// end. On as many threads as the computer has cores.
    std::vector<tl::expected<double, std::string>> times_s(const machine::Machine& machine) const;

    /// What the runs tell, in their order. Of a run that cannot be planned anew it is the whole time.
    std::vector<Datum> data() const;
    /// The times of such data, s; the error names the program that does not come to its end.
    tl::expected<std::vector<double>, std::string> times_s(std::span<const Datum> data,
                                                           const machine::Machine& machine) const;

  private:
    /// What a program asks for.
    struct Program {
        std::string file;
        simulation::MotionLog log;
        std::string refused;      ///< Why it does not come to its end; empty: it does.
        std::vector<Datum> data;  ///< Their run is told by data().
    };

    using Moves = std::vector<simulation::ReplayedMove>;

    void run(Program& program, const std::string& machine) const;
    tl::expected<double, std::string> run_time_s(const std::string& program, const std::string& machine,
                                                 simulation::MotionLog* log) const;
    /// Of a run that cannot be planned anew one move is all of it.
    std::vector<tl::expected<Moves, std::string>> moves(const machine::Machine& machine) const;

    std::vector<std::shared_ptr<const Program>> programs_;
    Reading reading_;
};

}  // namespace gsim::calibrate
