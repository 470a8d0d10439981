#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

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
    tl::expected<double, std::string> cycle_time_s(const Recording& recording) const;

    /// Returns the moves that a program asks for: those of a run from standstill to standstill.
    tl::expected<ProgrammedRun, std::string> programmed_run(const Recording& recording) const;

    /// The path of a program, sampled every 10 ms; the error as above.
    tl::expected<TimedPath, std::string> path(const Recording& recording) const;

  private:
    tl::expected<std::string, std::string> run(const Recording& recording,
                                               const std::vector<std::string>& outputs) const;
    tl::expected<std::string, std::string> run_on(const std::filesystem::path& machine,
                                                  const Recording& recording,
                                                  const std::vector<std::string>& outputs) const;

    std::string gsim_run_;
    std::vector<std::string> machines_;
    conformance::ScratchFolder scratch_;
};

/// Returns the cycle time in a report of `gsim-run --json`, in s; the error says why it is missing.
tl::expected<double, std::string> read_cycle_time_s(const std::string& report);

/// Returns the start of the first motion, in s, in the output of `gsim-run --moves`, or 0 if it has no
/// motion.
double first_motion_s(std::istream& moves);

/// The path of a recording; the error names the file that cannot be read or understood.
tl::expected<TimedPath, std::string> recorded_path(const Recording& recording);

}  // namespace gsim::accuracy
