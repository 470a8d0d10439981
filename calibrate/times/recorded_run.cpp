#include "calibrate/times/recorded_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "calibrate/times/passages.h"

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
    std::optional<std::size_t> time;
    std::optional<std::size_t> record;
    std::string ending;  ///< What names of programs lack.

    std::size_t last() const { return std::max({program, time.value_or(0), record.value_or(0)}); }
};

tl::expected<Columns, std::string> columns_of(const std::vector<std::string_view>& heading) {
    struct Names {
        std::string_view program, time, ending;
    };
    for (const auto& [program, time, ending] :
         {Names{"program", "time_s", ""}, Names{"name", "cycle_time_s", ".ngc"}}) {
        const auto at = column_of(heading, program), when = column_of(heading, time);
        const auto record = column_of(heading, "record");
        if (at && (when || record)) return Columns{*at, when, record, std::string(ending)};
    }
    return tl::unexpected<std::string>(
        "line 1: it should name the columns, 'program' and 'time_s' (or 'record') among them");
}

tl::expected<RecordedRun, std::string> run_in(const std::vector<std::string_view>& cells,
                                              const Columns& columns, const std::string& folder) {
    if (cells.size() <= columns.last()) return tl::unexpected<std::string>("a column is missing");
    const std::string_view time = columns.time ? cells[*columns.time] : "";
    const std::string_view record = columns.record ? cells[*columns.record] : "";
    const auto from_folder = [&](const std::string& name) {
        return name.starts_with('/') || folder.empty() ? name : folder + "/" + name;
    };
    RecordedRun run;
    run.program = from_folder(std::string(cells[columns.program]) + columns.ending);
    if (!record.empty()) run.record = from_folder(std::string(record));
    if (time.empty() && !record.empty()) return run;
    const auto read = fast_float::from_chars(time.data(), time.data() + time.size(), run.time_s);
    if (read.ec != std::errc() || read.ptr != time.data() + time.size() || !(run.time_s > 0) ||
        !std::isfinite(run.time_s))
        return tl::unexpected(fmt::format("'{}' should be a time above 0 s", time));
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

tl::expected<void, std::string> add_record(std::string_view text, const RecordForm& form, RecordedRun& run) {
    auto samples = read_motion_record(text, form);
    if (!samples) return tl::unexpected(samples.error());
    const auto span = motion_span(*samples);
    if (!span) return tl::unexpected<std::string>("nothing moves in it");
    run.samples = *std::move(samples);
    if (!(run.time_s > 0)) run.time_s = span->end_s - span->start_s;
    return {};
}

}  // namespace gsim::calibrate
