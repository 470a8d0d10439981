#include "calibrate/text/list.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/read_number.h"
#include "base/text/trimmed.h"

namespace gsim::calibrate {

namespace {

// A tab is not included: if tabs are separators, one at the beginning is an empty cell.
constexpr std::string_view kCellBlanks = " \"\r";

}  // namespace

Cells split_cells(std::string_view line, std::string_view separators) {
    Cells cells;
    while (true) {
        const std::size_t end = line.find_first_of(separators);
        cells.push_back(text::trimmed(line.substr(0, end), kCellBlanks));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

std::optional<std::size_t> find_column(const Cells& heading, std::string_view name) {
    const auto found = std::find(heading.begin(), heading.end(), name);
    if (found == heading.end()) return std::nullopt;
    return static_cast<std::size_t>(found - heading.begin());
}

std::optional<double> parse_number(std::string_view cell) {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto read = text::read_number(cell.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

Result<void> read_list(std::string_view list, const RowHandler& heading, const RowHandler& row) {
    if (list.empty()) return Unexpected("it is empty");
    std::string_view separators = ",";
    for (int number = 1; !list.empty(); ++number) {
        const std::size_t end = std::min(list.find('\n'), list.size());
        const std::string_view line = text::trimmed(list.substr(0, end), kCellBlanks);
        list.remove_prefix(std::min(end + 1, list.size()));
        if (number == 1) {
            if (line.find('\t') != std::string_view::npos) separators = "\t";
            if (auto handled = heading(split_cells(line, separators)); !handled) return handled;
        } else if (!line.empty()) {
            if (const auto handled = row(split_cells(line, separators)); !handled)
                return Unexpected(fmt::format("line {}: {}", number, handled.error().message));
        }
    }
    return {};
}

}  // namespace gsim::calibrate
