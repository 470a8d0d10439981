#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::calibrate {

/// Texts between the separators of a line, without the blanks and quotation marks around them.
using Cells = std::vector<std::string_view>;

/// Returns the cells of a line; each character of `separators` is a separator.
Cells split_cells(std::string_view line, std::string_view separators);

/// Returns the index of a column by its name; empty if no column has it.
std::optional<std::size_t> find_column(const Cells& heading, std::string_view name);

/// Returns the finite number in a cell, without a plus sign; empty if the cell is none.
std::optional<double> parse_number(std::string_view cell);

/// Function that receives the cells of a line; the error describes what is wrong with them.
using RowHandler = std::function<Result<void>(const Cells& cells)>;

/// Reads a list, one item a line, separated by commas, or by tabs if the first line has one. The first line
/// names the columns and is passed to `heading`. The other non-empty lines are passed to `row`, and its
/// errors get the number of the line. A list without a line is an error.
Result<void> read_list(std::string_view list, const RowHandler& heading, const RowHandler& row);

}  // namespace gsim::calibrate
