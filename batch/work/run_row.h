#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::batch {

/// A file that a run has read, or looked for.
struct ReadFile {
    std::string name;
    std::string sha256;  ///< Of its bytes; empty: there was none.

    bool operator==(const ReadFile&) const = default;
};

/// What came of a run.
struct RunRow {
    std::size_t number = 0;  ///< Of its job.
    /// "completed", "violations", "stopped", "alarm" as in a report; "refused": the program or an input has
    /// errors or cannot be read; "crashed", "timeout", "memory": it took its process with it.
    std::string status = {};
    std::string cause =
        {};  ///< What it ended by, as a diagnostic's code ("axis-limit"); empty where all is well.
    std::string message = {};  ///< A sentence on it.
    std::string file = {};     ///< Where, as far as it is known.
    std::uint32_t line = 0;
    std::string machine = {};     ///< Its own name.
    std::string controller = {};  ///< Model.
    double cycle_time_s = 0;
    std::optional<double> least_s = {}, most_s = {};  ///< 95 % of a calibrated machine.
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    double rapid_mm = 0, feed_mm = 0, jet_on_mm = 0;
    std::uint64_t blocks = 0, moves = 0;
    std::uint64_t violations = 0, collisions = 0, process_findings = 0, warnings = 0;
    std::optional<double> energy_j = {};  ///< From the motors, less what comes back.
    /// How near bodies came to each other; no more than the cell's clearance_mm, which is how far they are
    /// looked at. Nothing where no bodies are.
    std::optional<double> clearance_mm = {};
    std::optional<double> deviation_mm = {};  ///< By which corners of feed moves were rounded, at most.
    std::optional<double> joint_speed_share =
        {};                                    ///< Segment::peak_axis_speed_share(), where it was asked for.
    std::optional<double> lower_bound_s = {};  ///< Likewise: the least that any controller would take.
    std::string extents = {};                  ///< JSON: {"X": [min, max], ...}, mm or deg.
    std::string findings = {};                 ///< JSON: the diagnostics of the report.
    double cpu_s = 0;
    std::vector<ReadFile> files = {};
    std::string report = {};         ///< JSON, where the job wants it.
    std::string picture = {};        ///< SVG, likewise.
    std::string picture_fault = {};  ///< Why there is none, in a sentence.

    bool is_clean() const { return status == "completed" && cause.empty(); }
};

/// As a line of JSON, without a line feed.
std::string print_row(const RunRow& row);
/// Such a line. The error is a sentence.
tl::expected<RunRow, std::string> read_row(std::string_view line);

}  // namespace gsim::batch
