#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Function that receives a text in parts. False: it cannot be written.
using Sink = std::function<bool(std::string_view)>;

/// Writes a line with the column names, then the rows of a query, as CSV (RFC 4180).
Result<void> write_csv(Database& results, std::string_view query, const Sink& sink);
/// Does the same as JSON, one object a line. Columns of JSON (settings, options, extents, findings) are
/// values.
Result<void> write_json_lines(Database& results, std::string_view query, const Sink& sink);

/// All runs of the latest batch, with all columns.
inline constexpr std::string_view kAllColumnsQuery = "SELECT * FROM latest";
/// The same without findings, which do not fit into a table.
inline constexpr std::string_view kTableColumnsQuery =
    "SELECT job, program, machine, machine_name, controller, options, settings, status, cause, message, "
    "file, line, "
    "cycle_time_s, cycle_time_min_s, cycle_time_max_s, rapid_s, feed_s, dwell_s, rapid_mm, feed_mm, "
    "process_on_mm, blocks, moves, "
    "violations, "
    "collisions, process_findings, warnings, energy_j, clearance_mm, deviation_mm, joint_speed_share, "
    "lower_bound_s, extents, cpu_s, reused, ran_at, version, key FROM "
    "latest";

/// Writes the latest batch in the JUnit format: a suite for each machine, a case for each run.
Result<void> write_junit(Database& results, const Sink& sink);
/// Writes the findings of the programs of the latest batch as SARIF 2.1.0: each finding once, for any number
/// of machines.
Result<void> write_sarif(Database& results, const Sink& sink);

/// Returns a summary of the latest batch for people: causes of failures, and the machines.
Result<std::string> summary(Database& results);

}  // namespace gsim::batch
