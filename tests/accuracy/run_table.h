#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "tests/accuracy/controller.h"
#include "tests/accuracy/recording.h"

namespace gsim::accuracy {

/// The lines of a table.tsv: columns with tabs between, under a line that names them. Lines with fewer
/// columns lack the last ones; empty lines are none.
std::vector<TableRow> read_rows(std::string_view table);

/// A time in a column, s. The error says what there is in its place.
tl::expected<double, std::string> column_s(const TableRow& row, std::string_view column);

/// The runs of a controller that a table lists, sorted by name, of programs that are in the folder. Pauses
/// are taken from the times, as nobody goes on in a simulation. The error says what a line lacks.
tl::expected<std::vector<Recording>, std::string> listed_runs(const std::filesystem::path& folder,
                                                              const std::vector<TableRow>& rows,
                                                              const Controller& controller);

}  // namespace gsim::accuracy
