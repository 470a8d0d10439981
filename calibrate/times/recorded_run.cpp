#include "calibrate/times/recorded_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '"')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '"' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> cells_of(std::string_view line, char between) {
    std::vector<std::string_view> cells;
    while (true) {
        const std::size_t end = line.find(between);
        cells.push_back(without_blanks(line.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

std::optional<std::size_t> column_of(const std::vector<std::string_view>& heading, std::string_view name) {
    const auto found = std::find(heading.begin(), heading.end(), name);
    if (found == heading.end()) return std::nullopt;
    return static_cast<std::size_t>(found - heading.begin());
}

/// Where a list has what.
struct Columns {
    std::size_t program = 0;
    std::size_t time = 0;
    std::string ending;  ///< What names of programs lack.
};

tl::expected<Columns, std::string> columns_of(const std::vector<std::string_view>& heading) {
    struct Names {
        std::string_view program, time, ending;
    };
    for (const auto& [program, time, ending] :
         {Names{"program", "time_s", ""}, Names{"name", "cycle_time_s", ".ngc"}}) {
        const auto at = column_of(heading, program), when = column_of(heading, time);
        if (at && when) return Columns{*at, *when, std::string(ending)};
    }
    return tl::unexpected<std::string>(
        "line 1: it should name the columns, 'program' and 'time_s' among them");
}

tl::expected<RecordedRun, std::string> run_in(const std::vector<std::string_view>& cells,
                                              const Columns& columns, const std::string& folder) {
    if (cells.size() <= std::max(columns.program, columns.time))
        return tl::unexpected<std::string>("a column is missing");
    const std::string_view time = cells[columns.time];
    RecordedRun run;
    const auto read = fast_float::from_chars(time.data(), time.data() + time.size(), run.time_s);
    if (read.ec != std::errc() || read.ptr != time.data() + time.size() || !(run.time_s > 0) ||
        !std::isfinite(run.time_s))
        return tl::unexpected(fmt::format("'{}' should be a time above 0 s", time));
    const std::string name = std::string(cells[columns.program]) + columns.ending;
    run.program = name.starts_with('/') || folder.empty() ? name : folder + "/" + name;
    return run;
}

}  // namespace

tl::expected<std::vector<RecordedRun>, std::string> read_recorded_runs(std::string_view list,
                                                                       const std::string& folder) {
    std::vector<RecordedRun> runs;
    std::optional<Columns> columns;
    char between = ',';
    for (int number = 1; !list.empty(); ++number) {
        const std::size_t end = std::min(list.find('\n'), list.size());
        const std::string_view line = without_blanks(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
        if (!columns) {
            if (line.find('\t') != std::string_view::npos) between = '\t';
            auto found = columns_of(cells_of(line, between));
            if (!found) return tl::unexpected(found.error());
            columns = *std::move(found);
        } else if (!line.empty()) {
            auto run = run_in(cells_of(line, between), *columns, folder);
            if (!run) return tl::unexpected(fmt::format("line {}: {}", number, run.error()));
            runs.push_back(*std::move(run));
        }
    }
    if (!columns) return tl::unexpected<std::string>("it is empty");
    return runs;
}

}  // namespace gsim::calibrate
