#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::calibrate {

/// What stands between the separators of a line, without the blanks and quotation marks around it.
using Cells = std::vector<std::string_view>;

/// The cells of a line; each character of `between` is a separator.
Cells cells_of(std::string_view line, std::string_view between);

/// The place of a column by its name; nothing where no column is called so.
std::optional<std::size_t> column_of(const Cells& heading, std::string_view name);

/// The finite number that a cell is, without a plus sign; nothing where it is none.
std::optional<double> number_in(std::string_view cell);

/// Takes the cells of a line; the error says what is wrong with them.
using TakeCells = std::function<tl::expected<void, std::string>(const Cells& cells)>;

/// Reads a list, one thing a line with commas between, or tabs where the first line has one: that names the
/// columns, and goes to `heading`, the others that are not empty to `row`, whose errors come with the number
/// of the line. A list without a line is an error.
tl::expected<void, std::string> read_list(std::string_view list, const TakeCells& heading,
                                          const TakeCells& row);

}  // namespace gsim::calibrate
