#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"
#include "tests/round_trip/compare_runs.h"

namespace gsim::round_trip {

/// Post for writing programs, and the dialect that reads them.
struct Way {
    std::string post, dialect, controller;  ///< controller: model that a machine file names.
};

/// The three controls of the fidelity table (docs/round-trip.md).
inline const std::vector<Way> kWays{
    {"rs274ngc", "rs274ngc", "linuxcnc-2.9"}, {"ab9", "ab9", "ab9"}, {"grbl", "rs274ngc", "grbl-1.1"}};

/// End of the round trip.
enum class Ending {
    same,          ///< The second program does what the first did.
    differs,       ///< It does not.
    not_written,   ///< The writer has refused by name.
    not_run,       ///< The written program does not run.
    not_recorded,  ///< The run leaves no path.
    does_not_run,  ///< The first program does not run.
};

struct Outcome {
    Ending extension = Ending::same;
    Differences differences;
    std::string message;    ///< Message of the error.
    bool by_lines = false;  ///< Arcs outside the planes are lines: times are not compared.
};

/// Program that is run, recorded, written and run again, in a folder of its own.
class WayRound {
  public:
    /// Axes of the machine, of X Y Z A B C. `folder` is for files in between.
    WayRound(std::filesystem::path folder, std::string axes);

    /// Runs the program in a dialect and records it; returns true if it runs. A run that leaves no path
    /// counts as one, too.
    bool begin(const std::filesystem::path& program, const std::string& dialect);
    /// Records it on the controller of `way`, writes it, with these options, and runs it again.
    Outcome end(const Way& write_mode, const std::vector<std::string>& options = {}) const;
    /// Returns the first run's output.
    const std::string& message() const { return message_; }
    std::string written() const;

  private:
    apps::Ended gsim_run(const std::string& program, const std::string& dialect, const std::string& name,
                         const std::string& controller, bool record) const;
    RunRecord read(const std::string& name) const;
    std::string machine(const std::string& controller) const;

    std::filesystem::path folder_;
    std::string axes_;
    std::filesystem::path program_;
    std::string dialect_;
    std::string message_;
    bool has_path_ = false;
};

}  // namespace gsim::round_trip
