#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "calibrate/times/motion_record.h"

namespace gsim::calibrate {

/// Part program that a machine ran, and its time.
struct RecordedRun {
    std::string program;                     ///< Name of its file.
    double time_s = 0;                       ///< From its first motion or dwell to its last.
    std::string record = {};                 ///< File of its positions over time; empty: none.
    std::vector<MotionSample> samples = {};  ///< Content of that file.

    /// Returns the deviation of a time from the recorded one; below 0 if it is shorter.
    double error_percent(double other_s) const { return 100 * (other_s - time_s) / time_s; }
};

/// Returns some of the runs, by their indices.
std::vector<RecordedRun> select_runs(std::span<const RecordedRun> runs, std::span<const std::size_t> indices);

/// Reads the runs that a list names, one a line: a program's file, relative to `folder` if it is not
/// absolute, and its time in s. Commas or tabs separate them, and a first line names the columns: `program`
/// and `time_s`, or `name` (without an ending) and `cycle_time_s`. A column `record` names a file of
/// positions over time, instead of the time or in addition to it. Other columns are ignored. The error names
/// the line and what it lacks.
Result<std::vector<RecordedRun>> read_recorded_runs(std::string_view list, const std::string& folder);

/// Adds the positions of a recording to a run, and their time, if the run has none. The error describes the
/// problem.
Result<void> add_record(std::string_view text, const RecordFormat& record_format, RecordedRun& run);

}  // namespace gsim::calibrate
