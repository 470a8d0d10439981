#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::batch {

/// File that a run has read, or searched for.
struct ReadFile {
    std::string name;
    std::string sha256;  ///< Hash of its bytes; empty: no file.

    bool operator==(const ReadFile&) const = default;
};

/// How a run has ended.
struct RunOutcome {
    /// "completed", "violations", "stopped", "alarm" as in a report; "refused": the program or an input has
    /// errors or cannot be read; "crashed", "timeout", "memory": the process ended with it.
    std::string status = {};
    std::string cause =
        {};  ///< Cause of its end, as a diagnostic's code ("axis-limit"); empty if without error.
    std::string message = {};  ///< Its message.
    std::string file = {};     ///< Source file, if known.
    std::uint32_t line = 0;

    bool is_clean() const { return status == "completed" && cause.empty(); }
};

/// Times of the machine.
struct RunTimes {
    double cycle_s = 0;
    std::optional<double> min_s = {}, max_s = {};  ///< 95 % of a calibrated machine.
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    std::optional<double> lower_bound_s = {};  ///< If requested: min time with any controller.
};

/// Distances that the tool has moved.
struct RunDistances {
    double rapid_mm = 0, feed_mm = 0, process_on_mm = 0;
};

/// Numbers of what a run has done and found.
struct RunCounts {
    std::uint64_t blocks = 0, moves = 0;
    std::uint64_t violations = 0, collisions = 0, process_findings = 0, warnings = 0;
};

/// Documents of a run, if its job wants them.
struct RunReports {
    std::string report = {};         ///< JSON.
    std::string picture = {};        ///< SVG.
    std::string picture_error = {};  ///< Message why no picture exists.
};

/// Results of a run.
struct RunRow {
    std::size_t number = 0;  ///< Number of its job.
    RunOutcome outcome = {};
    std::string machine = {};     ///< Name in its file.
    std::string controller = {};  ///< Model.
    RunTimes times = {};
    RunDistances distances = {};
    RunCounts counts = {};
    std::optional<double> energy_j = {};  ///< From the motors, less what comes back.
    /// Smallest distance between bodies; at most the cell's clearance_mm, which is the checked distance.
    /// Empty if the run has no bodies.
    std::optional<double> clearance_mm = {};
    std::optional<double> deviation_mm = {};       ///< Max deviation at rounded corners of feed moves.
    std::optional<double> joint_speed_share = {};  ///< Segment::peak_axis_speed_share(), if requested.
    std::string extents = {};                      ///< JSON: {"X": [min, max], ...}, mm or deg.
    std::string findings = {};                     ///< JSON: the diagnostics of the report.
    double cpu_s = 0;
    std::vector<ReadFile> files = {};
    RunReports documents = {};
};

/// Returns the row as a line of JSON, without a line feed.
std::string print_row(const RunRow& row);
/// Reads such a line.
Result<RunRow> read_row(std::string_view line);

}  // namespace gsim::batch
