#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/accuracy/path_distance.h"
#include "tests/accuracy/programmed_move.h"
#include "tests/accuracy/recording.h"
#include "tests/conformance/scratch_folder.h"

namespace gsim::accuracy {

/// Runs recorded programs by gsim-run, each on the machine it was recorded on.
class GsimProgram {
  public:
    /// `machines` are folders of machine files; the first one that has a file counts.
    GsimProgram(std::string gsim_run, std::vector<std::string> machines);

    /// The cycle time of a program in the dialect rs274ngc, s, from its start or its first motion on; the
    /// error is the first one that gsim-run reports.
    Result<double> cycle_time_s(const Recording& recording) const;

    /// Returns the moves that a program asks for: those of a run from standstill to standstill.
    Result<ProgrammedRun> programmed_run(const Recording& recording) const;

    /// The path of a program, sampled every 10 ms; the error as above.
    Result<TimedPath> path(const Recording& recording) const;

  private:
    Result<std::string> run(const Recording& recording, const std::vector<std::string>& outputs) const;
    Result<std::string> run_on(const std::filesystem::path& machine, const Recording& recording,
                               const std::vector<std::string>& outputs) const;

    std::string gsim_run_;
    std::vector<std::string> machines_;
    conformance::ScratchFolder scratch_;
};

/// Returns the cycle time in a report of `gsim-run --json`, in s; the error says why it is missing.
Result<double> read_cycle_time_s(const std::string& report);

/// Returns the start of the first motion, in s, in the output of `gsim-run --moves`, or 0 if it has no
/// motion.
double first_motion_s(std::istream& moves);

/// The path of a recording; the error names the file that cannot be read or understood.
Result<TimedPath> recorded_path(const Recording& recording);

}  // namespace gsim::accuracy
