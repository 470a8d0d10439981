#include "engine/src/machine/data_table.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace gsim::engine {

using machine::DataRow;
using machine::SectionRules;

namespace {

using Cells = std::vector<std::string>;

std::string unit_name(machine::LengthUnit unit) {
    return unit == machine::LengthUnit::inch ? "inch" : "metric";
}

bool is_visible(const SectionRules& rules, std::span<const DataRow> rows, std::size_t field) {
    return rules.fields[field].required || std::any_of(rows.begin(), rows.end(), [&](const DataRow& row) {
               return !row.values[field].empty();
           });
}

std::vector<Cells> table_cells(const SectionRules& rules, std::span<const DataRow> rows) {
    std::vector<Cells> lines(rows.size() + 1);
    const auto add_column = [&](const std::string& head, const auto& value) {
        lines[0].push_back(head);
        for (std::size_t i = 0; i < rows.size(); ++i) lines[i + 1].push_back(value(rows[i]));
    };
    add_column("ID", [](const DataRow& row) { return row.id; });
    for (std::size_t field = 0; field < rules.fields.size(); ++field) {
        if (is_visible(rules, rows, field))
            add_column(rules.fields[field].name, [&](const DataRow& row) { return row.values[field]; });
    }
    if (rules.has_unit) add_column("UNIT", [](const DataRow& row) { return unit_name(row.unit); });
    return lines;
}

}  // namespace

std::string data_table(const SectionRules& rules, std::span<const DataRow> rows) {
    const std::vector<Cells> lines = table_cells(rules, rows);
    std::vector<std::size_t> widths(lines[0].size());
    for (const Cells& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text = fmt::format("{}\n", rules.keyword);
    for (const Cells& line : lines) {
        std::string out;
        for (std::size_t i = 0; i < line.size(); ++i) out += fmt::format("  {:<{}}", line[i], widths[i]);
        text += fmt::format("{}\n", out.substr(0, out.find_last_not_of(' ') + 1));
    }
    return text;
}

std::string data_list(const SectionRules& rules, const DataRow& row) {
    std::string text;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        if (!row.values[i].empty()) text += fmt::format("{} {}\n", rules.fields[i].name, row.values[i]);
    }
    return rules.has_unit ? text + fmt::format("UNIT {}\n", unit_name(row.unit)) : text;
}

}  // namespace gsim::engine
