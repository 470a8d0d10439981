#include "tests/accuracy/run_table.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "tests/accuracy/operator_inputs.h"

namespace gsim::accuracy {

namespace {

namespace fs = std::filesystem;

// Returns the part of `text` up to `end`, and removes both from `text`.
std::string_view next_field(std::string_view& text, char end) {
    const std::size_t at = std::min(text.find(end), text.size());
    const std::string_view part = text.substr(0, at);
    text.remove_prefix(std::min(at + 1, text.size()));
    return part;
}

std::vector<std::string> split_columns(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    std::vector<std::string> columns;
    while (!line.empty()) columns.emplace_back(next_field(line, '\t'));
    return columns;
}

Result<Recording> parse_run(const TableRow& row, const fs::path& program, const Controller& controller) {
    const auto time_s = column_s(row, controller.time_key);
    if (!time_s) return tl::unexpected(time_s.error());
    const auto pause_s = row.contains("pause_s") ? column_s(row, "pause_s") : 0.0;
    if (!pause_s) return tl::unexpected(pause_s.error());
    const auto overridden = overrides_of(text_in(row, "inputs"));
    Recording run;
    run.name = program.stem().string();
    if (controller.runs->variant_of != nullptr) run.name += ' ' + controller.runs->variant_of(row);
    run.program = program;
    run.dialect = controller.dialect;
    run.machine_file = controller.runs->machine_name(row) + ".toml";
    run.cycle_time_s = *time_s - *pause_s;
    run.overrides = overridden.value_or("");
    run.from_first_move = controller.from_first_move;
    run.tools = controller.tools;
    std::string left_out;
    if (!overridden) {
        left_out = overridden.error().message;
    } else if (controller.runs->left_out_for != nullptr) {
        left_out = controller.runs->left_out_for(row);
    }
    run.counted = left_out.empty();
    run.note = left_out.empty() ? text_in(row, controller.note_key) : left_out;
    return run;
}

}  // namespace

Result<double> column_s(const TableRow& row, std::string_view column) {
    const auto found = row.find(column);
    if (found == row.end()) return Unexpected(fmt::format("there is no column '{}'", column));
    const std::string& text = found->second;
    double time_s = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), time_s);
    if (read.ec != std::errc() || !(time_s >= 0)) return Unexpected(fmt::format("'{}' is no time", text));
    return time_s;
}

std::vector<TableRow> read_rows(std::string_view table) {
    const std::vector<std::string> heading = split_columns(next_field(table, '\n'));
    std::vector<TableRow> rows;
    while (!table.empty()) {
        const std::vector<std::string> columns = split_columns(next_field(table, '\n'));
        if (columns.empty()) continue;
        TableRow& row = rows.emplace_back();
        for (std::size_t i = 0; i < std::min(columns.size(), heading.size()); ++i)
            row[heading[i]] = columns[i];
    }
    return rows;
}

Result<std::vector<Recording>> listed_runs(const fs::path& folder, const std::vector<TableRow>& rows,
                                           const Controller& controller) {
    std::vector<Recording> runs;
    for (const TableRow& row : rows) {
        const fs::path program = folder / (text_in(row, "name") + ".ngc");
        if (!fs::is_regular_file(program)) continue;
        auto run = parse_run(row, program, controller);
        if (!run) return Unexpected(fmt::format("{}: {}", program.stem().string(), run.error().message));
        runs.push_back(*std::move(run));
    }
    std::sort(runs.begin(), runs.end(),
              [](const Recording& a, const Recording& b) { return a.name < b.name; });
    return runs;
}

}  // namespace gsim::accuracy
