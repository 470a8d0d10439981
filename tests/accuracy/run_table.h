#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "tests/accuracy/controller.h"
#include "tests/accuracy/recording.h"

namespace gsim::accuracy {

/// Returns the lines of a table.tsv: columns separated by tabs, under a line that names them. Lines with
/// fewer columns lack the last ones; empty lines are skipped.
std::vector<TableRow> read_rows(std::string_view table);

/// Returns a time in a column, in s. The error quotes the text found in its place.
Result<double> column_s(const TableRow& row, std::string_view column);

/// Returns the runs of a controller that a table lists, sorted by name, for programs that are in the folder.
/// Pauses are subtracted from the times, because a simulation has no operator to resume it. The error names
/// what a line lacks.
Result<std::vector<Recording>> listed_runs(const std::filesystem::path& folder,
                                           const std::vector<TableRow>& rows, const Controller& controller);

}  // namespace gsim::accuracy
