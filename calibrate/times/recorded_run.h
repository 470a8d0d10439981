#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/motion_record.h"

namespace gsim::calibrate {

/// A part program that a machine ran, and how long it took.
struct RecordedRun {
    std::string program;                     ///< Name of its file.
    double time_s = 0;                       ///< From its first motion or dwell to its last.
    std::string record = {};                 ///< File of its positions over time; empty: none.
    std::vector<MotionSample> samples = {};  ///< What is in it.

    /// How far a time is off the recorded one; below 0 where it is shorter.
    double error_percent(double other_s) const { return 100 * (other_s - time_s) / time_s; }
};

/// Some of the runs, by their places.
std::vector<RecordedRun> runs_at(std::span<const RecordedRun> runs, std::span<const std::size_t> places);

/// The runs that a list names, one a line: a program's file, from `folder` where it is not absolute, and its
/// time in s, with commas or tabs between, under a line that names the columns: `program` and `time_s`, or
/// `name` (without an ending) and `cycle_time_s`. A column `record` names a file of positions over time, in
/// place of the time or beside it. Other columns are of no meaning here. The error says which line lacks
/// what.
tl::expected<std::vector<RecordedRun>, std::string> read_recorded_runs(std::string_view list,
                                                                       const std::string& folder);

/// Puts the positions of a recording into a run, and their time, where the run has none. The error says what
/// is wrong with it.
tl::expected<void, std::string> add_record(std::string_view text, const RecordForm& form, RecordedRun& run);

}  // namespace gsim::calibrate
